// @ts-check
/** A class's part of the page, by what the page's address says that it is. */
import { onMessage } from "../../wire/channel.js";
import { markCanvas } from "../../ui/viser/widgets.js";
import { addDesk } from "./desk.js";
import { addSeat } from "./seat.js";
import { addWall } from "./wall.js";

/** Phases in which each pupil has a body of their own. */
const OWN = new Set(["try", "collect"]);
/** Milliseconds between two looks whether viser has made its canvas anew. */
const LOOK_EVERY = 200;

/** Makes it, for any page: a server without classes tells it nothing. */
export function addClassroom() {
  const as = new URLSearchParams(location.search).get("as");
  if (as === "desk") addDesk();
  else if (as === "wall") addWall();
  else addSeat();
  const { dataset } = document.documentElement;
  // What only looks on has no use for the panel.
  onMessage("seat", ({ asking, follows }) => (dataset.softrodClass = OWN.has(asking?.phase ?? "") && !follows ? "seat" : "seat looks"));
  onMessage("wall", ({ asking }) => (dataset.softrodClass = asking.phase === "lobby" ? "wall lobby" : "wall"));
  onMessage("desk", () => (dataset.softrodClass = "desk"));
  setInterval(() => {
    if (dataset.softrodClass) markCanvas();
  }, LOOK_EVERY);
}
