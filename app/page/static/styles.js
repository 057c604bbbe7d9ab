// @ts-check
/** The styles that the server writes: those that depend on colours, and on which controls there are. */
import { onTold } from "./channel.js";

/** Begins to put them into the page, after all others. */
export function showStyles() {
  const style = document.createElement("style");
  document.body.append(style);
  onTold("styles", ({ css }) => (style.textContent = css));
}
