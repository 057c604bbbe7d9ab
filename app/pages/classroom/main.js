// @ts-check
/** Starts a class's page: a pupil's, or the wall, as the page's address says. It is drawn on a canvas, without viser. */
import { ready } from "./older.js";
import { element } from "../../export/static/parts.js";
import { apply } from "../../ui/access.js";
import { listenToTaps } from "../../ui/hands/taps.js";
import { identify } from "../../ui/owner.js";
import { make } from "../../ui/dialog.js";
import { onMessage, send } from "../../wire/channel.js";
import { reasonOfRefusal } from "../../wire/reach.js";
import { say } from "../../words/words.js";
import { openLine } from "./line.js";
import { Picture } from "./picture.js";
import { addSeat } from "./seat.js";

async function start() {
  identify();
  listenToTaps();
  apply();
  const picture = new Picture(element("canvas", HTMLCanvasElement), JSON.parse(element("shapes", HTMLScriptElement).textContent || ""));
  const as = new URLSearchParams(location.search).get("as");
  document.documentElement.dataset.softrodClass = as === "wall" ? "wall" : "seat";
  const part = as === "wall" ? (await import("./wall.js")).addWall(picture) : addSeat(picture);
  const banner = element("banner", HTMLElement);
  let wasConnected = false;
  openLine((line) => {
    const away = line !== "connected";
    if (!away) wasConnected = true;
    document.documentElement.toggleAttribute("data-softrod-away", away);
    const words = part.lineChanged(away);
    banner.textContent = away ? words || say("line-away") : "";
    // The server may give no reason why there is no first connection.
    if (away && !wasConnected) reasonOfRefusal(say("class-blocked"), say("line-away")).then((text) => wasConnected || (banner.textContent = text));
  });
  onMessage("remark", ({ title, text }) => {
    const said = make("p", "softrod-remark");
    said.append(make("b", "", title), ` ${text}`);
    element("remarks", HTMLElement).replaceChildren(said);
    setTimeout(() => said.remove(), 12_000);
  });
  // For the browser tests.
  Object.assign(window, { __softrod: { shown: () => picture, send, place: () => picture.place } });
}

if (ready) start();
