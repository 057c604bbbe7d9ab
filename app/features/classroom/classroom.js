// @ts-check
/** The teacher's part of the page, where the page's address says that it is a teacher's. */
import { onMessage } from "../../wire/channel.js";
import { addDesk } from "./desk.js";
import { OWN_BODY } from "./phases.js";

/** Makes it: a server without classes never tells it anything. */
export function addClassroom() {
  if (new URLSearchParams(location.search).get("as") !== "desk") return;
  addDesk();
  onMessage("desk", ({ asking }) => {
    document.documentElement.dataset.softrodClass = OWN_BODY.has(asking.phase) ? "desk own" : "desk";
  });
}
