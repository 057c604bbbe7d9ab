// @ts-check
/**
 * The body by keys alone, for users without a pointer: a tab stop over the canvas. There the arrows choose a mass,
 * Space grabs and releases it, and the arrows then move it. A live region says what happened.
 */
import { onPicture, shown } from "../../stage/canvas.js";
import { onMessage, pageState, send } from "../../wire/channel.js";
import { choose, chosenMass } from "../../stage/overlay.js";
import { make } from "../dialog.js";
import { freeHand, takeHand, handAt } from "./hands.js";
import { ARROWS } from "./key_table.js";
import { wireNumber } from "../../stage/screen.js";

/** Distance by which an arrow moves a mass, in the world: a hundredth of the scene's frame. */
const STEP = 0.06;
/** Factor of that with Shift. */
const SHIFT_FACTOR = 5;

/** @param {number} count of broken springs */
const brokenText = (count) => `${count || "No"} ${count === 1 ? "spring" : "springs"} broken`;

/** Adds the tab stop and the live region to the page. */
export function addBodyKeys() {
  const stop = make("div", "softrod-body");
  stop.tabIndex = 0;
  stop.setAttribute("role", "application");
  const live = make("div", "softrod-live");
  live.setAttribute("role", "status");
  document.body.prepend(stop);
  document.body.append(live);
  /** @param {string} text */
  const say = (text) => (live.textContent = text);

  /** The place of the mass in hand, in the world; null without one. @type {{x: number, y: number} | null} */
  let hand = null;
  /** The number of the hand. */
  let number = -1;
  const name = () => {
    const { pictured: plan } = shown();
    return plan ? `mass ${chosenMass()} of 0 to ${plan.radius.length - 1}` : "no mass";
  };
  const where = () => {
    const { pictured: plan, frame } = shown();
    const mass = chosenMass();
    if (!plan || !frame || mass < 0) return null;
    const [x, y] = frame.positions.subarray(2 * mass, 2 * mass + 2);
    return { x: (x - plan.x) * plan.scale, y: (y - plan.y) * plan.scale * plan.flip };
  };
  const letGo = () => {
    if (!hand) return;
    hand = null;
    send({ do: "drop", hand: number });
    freeHand(number);
    say(`${name()} let go`);
  };

  /** The mass that was chosen when the stop lost the focus, for when a dialog returns it; -1 at first. */
  let last = -1;
  stop.addEventListener("focus", () => {
    choose(last < 0 ? Math.max(shown().pictured?.driven ?? 0, 0) : last);
    say(`${name()}. Arrows choose, Space takes hold`);
  });
  stop.addEventListener("blur", () => {
    letGo();
    last = chosenMass();
    choose(-1);
  });
  window.addEventListener("blur", letGo); // also where the connection is lost
  onPicture((_, { radius }) => {
    last = Math.min(last, radius.length - 1);
    if (chosenMass() < radius.length) return;
    choose(radius.length - 1);
    say(name());
  });
  stop.addEventListener("keydown", (event) => {
    const { pictured: plan } = shown();
    if (!plan || event.ctrlKey || event.metaKey || event.altKey) return;
    const move = ARROWS[event.key];
    if (event.code === "Space" || event.key === "Enter") {
      const at = where();
      if (hand) letGo();
      else if (at && (number = takeHand()) >= 0) {
        hand = at;
        const mass = chosenMass();
        send({ do: "grab", hand: number, mass, x: wireNumber(at.x), y: wireNumber(at.y) });
        send({ do: "pick", mass });
        say(`${name()} in hand. Arrows move it`);
      }
    } else if (move && hand) {
      const step = STEP * (event.shiftKey ? SHIFT_FACTOR : 1);
      hand = { x: hand.x + move[0] * step, y: hand.y + move[1] * step };
      send({ do: "at", hands: [handAt(number, hand)] });
    } else if (move) {
      const count = plan.radius.length;
      choose((chosenMass() + (event.key === "ArrowRight" || event.key === "ArrowDown" ? 1 : count - 1)) % count);
      say(name());
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });

  let before = pageState();
  onMessage("pageState", () => {
    const now = pageState();
    stop.ariaLabel = `Body of ${shown().plan?.radius.length ?? 0} masses`;
    if (before.scene !== undefined && now.scene !== before.scene) {
      letGo();
      last = -1;
    }
    const news = [];
    if (now.offer && !before.offer) news.push("The body exploded and is stopped");
    else if (before.page && Boolean(now.playing) !== Boolean(before.playing)) news.push(now.playing ? "Running" : "Paused");
    if (before.scene === now.scene && now.broken !== before.broken) news.push(brokenText(now.broken ?? 0));
    if (news.length) say(news.join(". "));
    before = now;
  });
}
