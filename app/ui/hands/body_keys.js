// @ts-check
/** The body by keys alone: a stop of the Tab key over the canvas, and a live region that says what happened. */
import { access } from "../access.js";
import { addTeller, overCanvas } from "../dialog.js";
import { onPicture, shown } from "../../stage/canvas.js";
import { onMessage, pageState, send } from "../../wire/channel.js";
import { toWorld } from "../../stage/draw.js";
import { choose, chosenMass } from "../../stage/overlay.js";
import { freeHand, takeHand, handAt } from "./hands.js";
import { KeyHand } from "./key_hand.js";
import { placeText } from "../../stage/measures.js";
import { sceneAt, wireNumber } from "../../stage/screen.js";
import { say } from "../../words/words.js";

/** Puts up the stop and the live region. */
export function addBodyKeys() {
  const stop = document.createElement("div");
  stop.tabIndex = 0;
  stop.className = "softrod-body";
  stop.setAttribute("role", "application");
  const live = document.createElement("div");
  live.className = "softrod-live";
  live.setAttribute("role", "status");
  overCanvas().prepend(stop);
  overCanvas().append(live);
  const tell = addTeller(); // beside what is said of its masses
  /** Where the mass in hand is, in the world. */
  let at = { x: 0, y: 0 };
  let number = -1;
  const keys = new KeyHand({
    count: () => shown().pictured?.radius.length ?? 0,
    chosen: chosenMass,
    choose,
    grab(mass) {
      const { pictured: plan, frame } = shown();
      if (!plan || !frame) return false;
      number = takeHand();
      if (number < 0) return false;
      const [x, y] = toWorld(plan, frame.positions.subarray(2 * mass, 2 * mass + 2));
      at = { x, y };
      stop.toggleAttribute("data-holds", true);
      send({ do: "grab", hand: number, mass, x: wireNumber(x), y: wireNumber(y) });
      send({ do: "pick", mass });
      return true;
    },
    move(x, y) {
      at = { x: at.x + x, y: at.y + y };
      send({ do: "at", hands: [handAt(number, at)] });
    },
    drop() {
      send({ do: "drop", hand: number });
      freeHand(number);
      number = -1;
      stop.removeAttribute("data-holds");
    },
    where(mass) {
      const { pictured: plan, frame } = shown();
      if (!plan || !frame) return "";
      // What is in hand follows it a picture later.
      const [x, y] = frame.positions.subarray(2 * mass, 2 * mass + 2);
      const place = number < 0 ? { x, y } : sceneAt(plan, at);
      return placeText(place.x, place.y, pageState().unit ?? "");
    },
    hint: () => (document.documentElement.hasAttribute("data-softrod-editing") ? "ui-mass.tools" : "ui-mass.first"),
    say: (text) => (live.textContent = text),
  });
  const name = () => {
    const told = say("ui-body", { count: shown().plan?.radius.length ?? 0 });
    if (stop.ariaLabel !== told) stop.ariaLabel = told;
  };
  stop.addEventListener("focus", () => keys.focus(shown().pictured?.driven ?? 0));
  stop.addEventListener("blur", () => keys.blur());
  window.addEventListener("blur", () => keys.letGo()); // also where the connection is lost
  onPicture(() => {
    keys.recount();
    name();
  });
  stop.addEventListener("keydown", (event) => keys.press(event));

  let before = pageState();
  onMessage("pageState", () => {
    const now = pageState();
    name();
    for (const canvas of overCanvas().querySelectorAll("canvas")) canvas.ariaHidden = "true"; // the stop speaks for them
    if (before.scene !== undefined && now.scene !== before.scene) keys.forget();
    const news = [];
    if (before.page === now.page && before.scene !== now.scene && now.title !== before.title) tell(say("ui-opened", { title: now.title ?? "" }));
    if (before.offer && !now.offer && live.textContent === say("ui-exploded")) live.textContent = "";
    if (now.offer && !before.offer) news.push(say("ui-exploded"));
    else if (before.page && Boolean(now.playing) !== Boolean(before.playing)) news.push(say(now.playing ? "ui-running" : "ui-running.paused"));
    if (before.scene === now.scene && now.broken !== before.broken) news.push(say("ui-broken", { count: now.broken ?? 0 }));
    // While events are spoken, that says these, too.
    if (news.length && !access().events) live.textContent = news.join(". ");
    before = now;
  });
}
