// @ts-check
/** The steps of the lesson in order, with what can be done to the chosen one. */
import { send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { box } from "./fields.js";
import { say } from "../../words/words.js";

export const MAX_STEPS = 20;

export class StepList {
  /**
   * @param {() => void} flush sends what was typed, before the steps change
   * @param {(step: number) => void} choose chooses a step
   * @param {(step: number) => void} expect chooses a step that the server is about to create or move
   */
  constructor(flush, choose, expect) {
    this.flush = flush;
    this.choose = choose;
    this.expect = expect;
    this.element = make("ol", "softrod-steps");
    /** @type {string[]} */
    this.titles = [];
    /** The chosen step. */
    this.at = 0;
    /** The name of the button that gets the focus once it exists. */
    this.focused = "";
  }

  /** @param {string[]} titles @param {number} at the chosen one */
  show(titles, at) {
    if (at === this.at && JSON.stringify(titles) === JSON.stringify(this.titles)) return;
    [this.titles, this.at] = [titles, at];
    const { activeElement } = document;
    const name = this.focused || (this.element.contains(activeElement) ? (activeElement?.getAttribute("data-focus") ?? "") : "");
    this.element.replaceChildren(...titles.map((_, i) => this.row(i)));
    const again = /** @type {HTMLButtonElement | null} */ (name ? this.element.querySelector(`[data-focus="${name}"]`) : null);
    // A disabled button cannot have the focus.
    if (again?.disabled) /** @type {HTMLElement | null} */ (this.element.querySelector("[aria-current]"))?.focus();
    else again?.focus();
    this.focused = "";
  }

  /** @param {number} i */
  row(i) {
    const item = make("li", "");
    const one = makeButton(`${i + 1}. ${this.titles[i]}`, () => this.choose(i), "softrod-making-title");
    one.dataset.focus = `step ${i}`;
    one.addEventListener("keydown", (event) => {
      const by = { ArrowUp: -1, ArrowDown: 1 }[event.key] ?? 0;
      const to = i + by;
      if (!by || to < 0 || to >= this.titles.length) return;
      event.preventDefault();
      this.focused = `step ${to}`;
      if (event.altKey) this.move(to);
      else this.choose(to);
    });
    item.append(one);
    if (i !== this.at) return item;
    one.setAttribute("aria-current", "step");
    item.append(box(
      "softrod-making-tools",
      this.tool("↑", say("making-up"), i > 0, () => this.move(i - 1)),
      this.tool("↓", say("making-down"), i + 1 < this.titles.length, () => this.move(i + 1)),
      this.tool(say("making-duplicate"), say("making-duplicate"), this.titles.length < MAX_STEPS, () => {
        send({ do: "copyStep", step: i });
        this.expect(i + 1);
      }),
      this.tool(say("making-remove"), say("making-remove"), true, () => {
        send({ do: "removeStep", step: i });
        this.focused = `step ${Math.max(0, i - 1)}`;
      }),
    ));
    return item;
  }

  /** @param {string} text @param {string} label @param {boolean} isEnabled @param {() => void} press */
  tool(text, label, isEnabled, press) {
    const button = makeButton(text, () => {
      this.flush();
      press();
    });
    button.ariaLabel = button.title = label;
    button.dataset.focus = label;
    button.disabled = !isEnabled;
    return button;
  }

  /** Moves the chosen step. @param {number} to */
  move(to) {
    this.flush();
    send({ do: "moveStep", step: this.at, to });
    this.expect(to);
  }
}
