// @ts-check
/** Says in a live region what happens to the body, while that is wished on the page Access. */
import { onMessage, send } from "../../wire/channel.js";
import { access, onAccess } from "../../ui/access.js";
import { addTeller } from "../../ui/dialog.js";
import { onGrasp } from "../../ui/hands/hands.js";
import { News } from "./news.js";

/** Milliseconds between two looks whether a sentence is due. */
const LOOK_EVERY = 100;

/** Begins to listen. */
export function speakOfEvents() {
  const tell = addTeller("softrod-news");
  const news = new News();
  /** @param {import("./news.js").Event} event */
  const hear = (event) => access().events && news.hear(event, performance.now());

  /** @type {Partial<import("../../wire/wire.js").PageState>} */
  let before = {};
  /** The connection and the wish that the server knows of. */
  let asked = "";
  const ask = () => {
    const wish = `${before.page} ${access().events}`;
    if (!before.page || wish === asked || (!asked && !access().events)) return;
    asked = wish;
    send({ do: "followTouches", on: access().events });
  };
  onAccess(() => {
    if (!access().events) news.clear();
    ask();
  });
  onMessage("pageState", (now) => {
    const same = before.page === now.page && before.scene === now.scene;
    const broke = (now.broken ?? 0) - (before.broken ?? 0);
    if (same && Boolean(now.playing) !== Boolean(before.playing)) hear({ what: now.playing ? "running" : "paused" });
    if (same && before.playing && now.rest && !before.rest) hear({ what: "rest" });
    if (same && broke > 0) hear({ what: "broke", count: broke });
    if (same && now.offer && !before.offer) hear({ what: "exploded" });
    before = now;
    ask();
  });
  onMessage("touched", ({ by }) => hear({ what: "touched", by }));
  onGrasp((mass, holds) => hear({ what: holds ? "grabbed" : "dropped", mass }));
  document.addEventListener("softrod-step", (event) => hear({ what: "step", .../** @type {CustomEvent} */ (event).detail }));
  setInterval(() => {
    const said = news.take(performance.now());
    if (said) tell(said);
  }, LOOK_EVERY);
}
