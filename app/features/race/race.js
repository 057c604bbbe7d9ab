// @ts-check
/**
 * The strip of a race over the bar of time: how far each body has come, which is ahead, and a start after a count-down.
 * It is made at the first race.
 */
import { canvasBox } from "../../ui/viser/viser.js";
import { onMessage, pageState } from "../../wire/channel.js";
import { sendParts } from "../../ui/kept/links.js";
import { withKey } from "../../ui/hands/key_table.js";
import { make, makeButton } from "../../ui/dialog.js";
import { roundUp } from "../../stage/axes.js";
import { gallery } from "../gallery/gallery.js";
import { makeStrip } from "../../ui/strip.js";
import { perform } from "../../wire/perform.js";

/** @typedef {import("../../wire/wire.js").Race} Race */

/** Milliseconds of each number of the count-down, and of the word after it. */
const COUNT = 700;
/** Milliseconds between two readings for a screen reader. */
const READ_EVERY = 3000;
/** Distance below which neither is ahead, px. */
const CLOSE = 0.5;
/** Shortest distance that fills a bar, px. */
const MIN_FULL = 100;

/** The group of presets that move by themselves. */
const MOVING = "Muscles";
const RULE =
  "Both start together, on this body's terrain. Changes of this body and of the terrain are allowed, and are noted here; Start again makes it fair.";

/** @type {Race} */
let race = { tell: "race" };

/** A distance in words. @param {number} way */
const inPx = (way) => {
  const size = Math.abs(way) < 10 ? Number(Math.abs(way).toPrecision(2)) : Math.round(Math.abs(way));
  return `${way < 0 && size ? "−" : ""}${size} ${pageState().unit ?? ""}`;
};

/** The names of both, which are made different if they are the same. @param {Race} race @returns {[string, string]} */
export function namesOf({ names: [one, other] = ["", ""] }) {
  return one === other ? [one, `${other} (the other)`] : [one, other];
}

/** Which is ahead: the one that has come farther, in either direction. @param {Race} race */
export function verdict(race) {
  const { ways: [one, other] = [0, 0], out } = race;
  const [mine, theirs] = namesOf(race);
  if (out) return `${theirs} is out: ${out}`;
  const ahead = Math.abs(one) - Math.abs(other);
  if (Math.abs(ahead) < CLOSE) return "Neither is ahead";
  return `${ahead > 0 ? mine : theirs} is ahead by ${inPx(Math.abs(ahead))}`;
}

/** Begins a race against a scene, by its link or its name. @param {string} text */
const raceAgainst = (text) => void sendParts("rival", encodeURIComponent(text.trim()));

/** The line of the gallery into which a link to a rival is pasted. */
function makeLine() {
  const line = make("form", "softrod-dialog-line softrod-rival");
  const pasted = make("input", "softrod-search");
  pasted.placeholder = "Paste a link to a scene, or choose one below";
  pasted.ariaLabel = "Link to the scene to race against";
  line.append(pasted, make("button", "softrod-button softrod-first", "Race"));
  line.addEventListener("submit", (event) => {
    event.preventDefault();
    if (pasted.value.trim()) raceAgainst(pasted.value);
  });
  return line;
}

/** Chooses a rival; or in a race, starts it anew. */
function openRace() {
  if (race.on) start();
  else gallery.open({ title: "Race against", line: makeLine(), first: MOVING, pick: raceAgainst });
}

let start = () => {};

function makeRace() {
  const { strip, head, says, live, show } = makeStrip("race", "Race");
  const begin = makeButton("Start", () => start(), "softrod-race-start");
  begin.title = withKey("Both from the start, after a count-down", "race");
  const leave = makeButton("Leave", () => perform("leaveRace"), "");
  leave.title = "Leave the race; this body goes on alone";
  head.append(begin, leave);
  const rows = ["softrod-race-mine", "softrod-race-theirs"].map((name) => {
    const row = make("div", `softrod-race-row ${name}`);
    const [who, track, bar, way] = [make("b", ""), make("span", "softrod-race-track"), make("i", ""), make("output", "")];
    way.ariaLive = "off"; // what is read out is the line above
    track.append(bar);
    row.append(who, track, way);
    return { row, who, bar, way };
  });
  const rule = make("small", "softrod-race-rule", RULE);
  strip.append(...rows.map(({ row }) => row), rule);
  const count = make("div", "softrod-count");
  count.ariaLive = "assertive";
  count.hidden = true;
  document.body.append(count);

  let [counting, read] = [0, 0];
  const stopCount = () => {
    clearTimeout(counting);
    counting = 0;
    count.hidden = true;
  };
  /** @param {number} left */
  const countDown = (left) => {
    count.hidden = false;
    count.textContent = left ? String(left) : "Go!";
    const box = canvasBox();
    if (box) Object.assign(count.style, { left: `${box.left + box.width / 2}px`, top: `${box.top + box.height / 3}px` });
    if (!left) perform("run");
    counting = setTimeout(() => (left ? countDown(left - 1) : stopCount()), COUNT);
  };
  start = () => {
    stopCount();
    perform("pause");
    perform("reset");
    begin.blur(); // the keys are the bodies'
    countDown(3);
  };
  window.addEventListener("keydown", ({ key }) => key === "Escape" && stopCount(), true);
  onMessage("pageState", ({ playing }) => playing && counting && count.textContent !== "Go!" && stopCount());
  return (/** @type {Race} */ now) => {
    const on = now.on ?? false;
    if (strip.hidden === on) live.textContent = on ? `A race against ${namesOf(now)[1]}. ${withKey("Start", "race")}.` : "The race is left";
    show(on);
    if (!on) stopCount();
    const { ways = [0, 0], seconds = 0, fair = true } = now;
    const full = roundUp(Math.max(MIN_FULL, ...ways.map(Math.abs)));
    rows.forEach(({ who, bar, way }, i) => {
      const name = namesOf(now)[i];
      if (who.textContent !== name) who.textContent = name;
      bar.style.transform = `scaleX(${(Math.abs(ways[i]) / full).toFixed(4)})`;
      way.textContent = inPx(ways[i]);
    });
    const begun = seconds > 0;
    const text = begun ? `${verdict(now)}, after ${seconds.toFixed(1)} s${fair ? "" : "; changed or moved on the way"}` : "";
    if (says.textContent !== (text || "At the start")) says.textContent = text || "At the start";
    begin.textContent = begun ? "Start again" : "Start";
    rule.hidden = begun && fair;
    if (begun && on && performance.now() - read > READ_EVERY && pageState().playing) {
      read = performance.now();
      const short = verdict(now).replace(/ by .*/, "");
      if (live.textContent !== short) live.textContent = short;
    } else if (begun && on && !pageState().playing && live.textContent !== text) live.textContent = text;
  };
}

/** Begins to look for a race. */
function begin() {
  /** @type {ReturnType<typeof makeRace> | null} */
  let show = null;
  onMessage("race", (now) => {
    race = now;
    if (!show && !now.on) return;
    show ??= makeRace();
    show(now);
  });
  onMessage("raceAnswer", ({ problem }) => (problem ? gallery.say(problem) : gallery.close()));
}

/** @type {import("../../ui/feature.js").Feature<"race">} */
export default { commands: { race: openRace }, begin };
