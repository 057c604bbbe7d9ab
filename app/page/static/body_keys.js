// @ts-check
/**
 * The body by keys alone, for those who have no pointer: a stop of the Tab key over the canvas. There the arrows
 * choose a mass, Space takes hold of it and lets go, and the arrows then move it. A live region says what happened.
 */
import { shown } from "./canvas.js";
import { onTold, send, told } from "./channel.js";
import { choose, chosenMass } from "./overlay.js";

/** Pixels of the scene's frame, taken as 600 high, that a key moves a mass by. */
const STEP = 6;
const FAR = 5;
const FRAME = 600;
/** The page's world is so many units for 600 pixels. */
const WORLD = 6;

/** @type {Record<string, [number, number]>} */
const MOVES = { ArrowUp: [0, 1], ArrowDown: [0, -1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };

/** Puts up the stop and the live region. */
export function addBodyKeys() {
  const stop = document.createElement("div");
  stop.tabIndex = 0;
  stop.className = "softrod-body";
  stop.setAttribute("role", "application");
  const live = document.createElement("div");
  live.className = "softrod-live";
  live.setAttribute("role", "status");
  document.body.prepend(stop);
  document.body.append(live);
  /** @param {string} text */
  const say = (text) => (live.textContent = text);

  /** Where the mass in hand is, in the world; null while none is. @type {{x: number, y: number} | null} */
  let hand = null;
  const name = () => {
    const { plan } = shown();
    return plan ? `mass ${chosenMass() + 1} of ${plan.radius.length}` : "no mass";
  };
  const where = () => {
    const { plan, frame } = shown();
    const mass = chosenMass();
    if (!plan || !frame || mass < 0) return null;
    const [x, y] = frame.positions.subarray(2 * mass, 2 * mass + 2);
    return { x: (x - plan.x) * plan.scale, y: (y - plan.y) * plan.scale * plan.flip };
  };
  /** @param {{x: number, y: number}} at */
  const text = (at) => `${at.x.toFixed(6)},${at.y.toFixed(6)}`;
  const letGo = () => {
    if (!hand) return;
    hand = null;
    send("drop", "");
    say(`${name()} let go`);
  };

  stop.addEventListener("focus", () => {
    const { plan } = shown();
    if (plan && (chosenMass() < 0 || chosenMass() >= plan.radius.length)) choose(Math.max(plan.driven, 0));
    else choose(chosenMass());
    say(`${name()}. Arrows choose, Space takes hold`);
  });
  stop.addEventListener("blur", () => {
    letGo();
    choose(-1);
  });
  stop.addEventListener("keydown", (event) => {
    const { plan } = shown();
    if (!plan || event.ctrlKey || event.metaKey || event.altKey) return;
    const move = MOVES[event.key];
    if (event.code === "Space" || event.key === "Enter") {
      const at = where();
      if (hand) letGo();
      else if (at) {
        hand = at;
        send("grab", `${chosenMass()}|${text(at)}`);
        send("pick", String(chosenMass()));
        say(`${name()} in hand. Arrows move it`);
      }
    } else if (move && hand) {
      const step = ((STEP * WORLD) / FRAME) * (event.shiftKey ? FAR : 1);
      hand = { x: hand.x + move[0] * step, y: hand.y + move[1] * step };
      send("at", text(hand));
    } else if (move) {
      const count = plan.radius.length;
      choose((chosenMass() + (event.key === "ArrowRight" || event.key === "ArrowDown" ? 1 : count - 1)) % count);
      say(name());
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });

  let playing = told().playing;
  onTold(() => {
    const { plan } = shown();
    stop.ariaLabel = `Body of ${plan?.radius.length ?? 0} masses`;
    if (told().offer === "1") say("The simulation ran away and is stopped");
    else if (told().playing !== playing) say(told().playing === "1" ? "Running" : "Paused");
    playing = told().playing;
  });
}
