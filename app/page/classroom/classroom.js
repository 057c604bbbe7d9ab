// @ts-check
/** A class's part of the page, by what the page's address says that it is. */
import { addDesk } from "./desk.js";
import { addSeat } from "./seat.js";
import { addWall } from "./wall.js";

/** Makes it, for any page: a server without classes tells it nothing. */
export function addClassroom() {
  const as = new URLSearchParams(location.search).get("as");
  if (as === "desk") addDesk();
  else if (as === "wall") addWall();
  else addSeat();
}
