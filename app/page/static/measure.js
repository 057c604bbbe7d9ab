// @ts-check
/** Shows the Measure tab when the server asks for it: viser has no way to turn to a tab. */
import { onTold, told } from "./channel.js";

const NAME = "Measure";

/** Begins to listen. */
export function showMeasures() {
  let asked = "0";
  onTold(() => {
    const { measures = "0" } = told();
    if (measures === asked) return;
    asked = measures;
    const tabs = [...document.querySelectorAll("[role=tab]")];
    const tab = tabs.find((each) => each.textContent?.trim() === NAME);
    if (!(tab instanceof HTMLElement)) return;
    // The panel beside the canvas hears of no click, that of a phone of nothing else.
    tab.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true, cancelable: true }));
    tab.click();
  });
}
