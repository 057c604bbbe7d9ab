// @ts-check
/** A class's part of the page, by what the page's address says that it is. */
import { onMessage } from "../../wire/channel.js";
import { addDesk } from "./desk.js";
import { addSeat, OWN_BODY } from "./seat.js";
import { addWall } from "./wall.js";

/** Makes it, for any page: a server without classes never tells it anything. */
export function addClassroom() {
  const as = new URLSearchParams(location.search).get("as");
  if (as === "desk") addDesk();
  else if (as === "wall") addWall();
  else addSeat();
  const { dataset } = document.documentElement;
  // A page that only looks needs no panel.
  onMessage("seat", ({ asking, follows }) => (dataset.softrodClass = OWN_BODY.has(asking?.phase ?? "") && !follows ? "seat" : "seat looks"));
  onMessage("wall", ({ asking }) => (dataset.softrodClass = asking.phase === "lobby" ? "wall lobby" : "wall"));
  onMessage("desk", () => (dataset.softrodClass = "desk"));
}
