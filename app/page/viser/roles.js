// @ts-check
/**
 * Controls that look otherwise than viser draws them. They are marked by an attribute, for the styles: a selector with
 * `:has` would have the browser go through the whole page whenever a text in it changes, which took half of the page's
 * time.
 */
import { onTold } from "../../wire/channel.js";

/** @typedef {import("../../wire/wire.js").Roles["roles"][string]} Role */

/** @type {Record<string, Role>} */
let roles = {};

/** Each role's elements, from the one that has the control's id. @type {Record<Role, (element: Element) => [string, Element | null | undefined][]>} */
const MARKS = {
  slider: (element) => [["slider", element.parentElement]],
  number: (element) => [["number", element.closest(".mantine-NumberInput-root")]],
  outlined: (element) => [["outlined", element]],
  beside: (element) => [
    ["icon", element],
    ["icon-row", element.parentElement],
    ["before-icon", element.parentElement?.previousElementSibling],
  ],
};

function mark() {
  for (const [id, role] of Object.entries(roles)) {
    const element = document.getElementById(id);
    for (const [name, part] of element ? MARKS[role](element) : []) {
      if (part && part.getAttribute("data-softrod") !== name) part.setAttribute("data-softrod", name);
    }
  }
  // viser's own page for developers, which changes what softrod sets.
  document.querySelector(".tabler-icon-adjustments")?.closest("button")?.setAttribute("data-softrod", "developers");
}

/** Begins to mark controls as they come. */
export function markControls() {
  onTold("roles", (told) => {
    roles = told.roles;
    document.documentElement.toggleAttribute("data-softrod-no-time", !told.time_bar);
    mark();
  });
  new MutationObserver(mark).observe(document.getElementById("root") ?? document.body, { childList: true, subtree: true });
}
