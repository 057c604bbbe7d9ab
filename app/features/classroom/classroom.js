// @ts-check
/** The teacher's part of the page, where the page's address says that it is a teacher's. */
import { onMessage } from "../../wire/channel.js";
import { OWN_BODY } from "./phases.js";

/** Loads the teacher's part, and gives what makes it; of another page, what makes nothing. */
export async function loadClassroom() {
  if (new URLSearchParams(location.search).get("as") !== "desk") return () => {};
  const { addDesk } = await import("./desk.js");
  return () => {
    addDesk();
    onMessage("desk", ({ asking }) => {
      document.documentElement.dataset.softrodClass = OWN_BODY.has(asking.phase) ? "desk own" : "desk";
    });
  };
}
