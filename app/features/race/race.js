// @ts-check
/**
 * The strip of a race over the bar of time: how far each body has come, which is ahead or has won, and a start after a
 * count-down; and the finish on the canvas.
 * It is made at the first race.
 */
import { canvasBox } from "../../ui/viser/viser.js";
import { onMessage, pageState } from "../../wire/channel.js";
import { sendParts } from "../../ui/kept/links.js";
import { withKey } from "../../ui/hands/key_table.js";
import { make, makeButton } from "../../ui/dialog.js";
import { secondIn } from "../../stage/canvas.js";
import { edgeArrow } from "../../stage/edge.js";
import { onScreen } from "../../stage/screen.js";
import { insertMarksLayer, onMarksRedraw } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
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
/** Seconds between two arrivals below which neither was first. */
const AT_ONCE = 0.05;
/** Pixels of the window between the flag of the finish and the ground of its line. */
const LINE = 90;

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

/** True if the race is decided: both have arrived, or one, and the other never will. @param {Race} race */
export const isOver = ({ arrivals: [one, other] = [null, null], out = "" }) => one != null && (other != null || out !== "");

/** @param {number} seconds */
const after = (seconds) => `after ${seconds.toFixed(1)} s`;

/** Who has won, or which is ahead: the one that has come farther, in either direction. @param {Race} race */
export function verdict(race) {
  const { ways: [one, other] = [0, 0], arrivals: [mine_at, theirs_at] = [null, null], out } = race;
  const [mine, theirs] = namesOf(race);
  if (mine_at != null && theirs_at != null) {
    const [first, least] = mine_at < theirs_at ? [mine, mine_at] : [theirs, theirs_at];
    const lead = Math.abs(mine_at - theirs_at);
    return lead < AT_ONCE ? `Both at once, ${after(least)}` : `${first} was first, by ${lead.toFixed(1)} s`;
  }
  if (out && mine_at != null) return `${mine} has won: ${theirs} is out, ${out}`;
  if (mine_at != null) return `${mine} is there, ${after(mine_at)}`;
  if (theirs_at != null) return `${theirs} is there, ${after(theirs_at)}`;
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
    const { ways = [0, 0], seconds = 0, fair = true, finish = 1 } = now;
    rows.forEach(({ who, bar, way }, i) => {
      const name = namesOf(now)[i];
      if (who.textContent !== name) who.textContent = name;
      bar.style.transform = `scaleX(${Math.min(Math.abs(ways[i]) / finish, 1).toFixed(4)})`;
      way.textContent = inPx(ways[i]);
    });
    const begun = seconds > 0;
    const decided = isOver(now);
    const passed = decided || now.arrivals?.some((at) => at != null) ? "" : `, ${after(seconds)}`;
    const text = begun ? `${verdict(now)}${passed}${fair ? "" : "; changed or moved on the way"}` : "";
    const said = text || `At the start: ${inPx(finish)} to the finish`;
    if (says.textContent !== said) says.textContent = said;
    begin.textContent = decided ? "Race again" : begun ? "Start again" : "Start";
    rule.hidden = begun && fair;
    if (decided && on) {
      if (live.textContent !== text) live.textContent = text;
    } else if (begun && on && performance.now() - read > READ_EVERY && pageState().playing) {
      read = performance.now();
      const short = verdict(now).replace(/ by .*/, "");
      if (live.textContent !== short) live.textContent = short;
    } else if (begun && on && !pageState().playing && live.textContent !== text) live.textContent = text;
  };
}

/** The line at which each body has arrived, with a flag. */
function drawFinish() {
  const svg = makeSvg("svg", "softrod-marks softrod-finish");
  const [line, flag] = [makeSvg("path", "softrod-finish-line", svg), makeSvg("path", "softrod-finish-flag", svg)];
  const word = makeSvg("text", "", svg);
  word.textContent = "finish";
  insertMarksLayer(svg);
  onMarksRedraw(({ plan, on, places }) => {
    svg.style.display = race.on ? "" : "none";
    if (!race.on) return;
    const [mine = 0] = race.lines ?? [];
    const x = on.x + (mine - plan.x) * plan.scale * on.step;
    const low = Math.max(...Array.from({ length: places.length / 2 }, (_, i) => places[2 * i + 1]));
    const top = low - LINE;
    set(line, { d: `M${x.toFixed(1)} ${low.toFixed(1)}V${top.toFixed(1)}` });
    set(flag, { d: `M${x.toFixed(1)} ${top.toFixed(1)}l22 8l-22 8z` });
    set(word, { x: x + 4, y: top - 10 });
  });
}

/** The name and the distance of the other body, at the edge of the view that it has left. */
function drawRival() {
  const label = make("div", "softrod-rival-away");
  label.hidden = true;
  label.ariaHidden = "true"; // the strip says it
  document.body.append(label);
  onMarksRedraw(({ frame, on, box: { left, right, top }, floor }) => {
    const second = race.on ? secondIn(frame) : null;
    const places = second ? onScreen(second.plan, second.frame.positions, on) : [];
    const away = edgeArrow(places, { left, right, top, bottom: floor });
    label.hidden = away === null;
    if (!away) return;
    const [one = 0, other = 0] = race.ways ?? [];
    label.textContent = `${namesOf(race)[1]}, ${inPx(Math.abs(Math.abs(other) - Math.abs(one)))}`;
    label.toggleAttribute("data-right", away.x > (left + right) / 2);
    Object.assign(label.style, { left: `${away.x}px`, top: `${away.y}px` });
  });
}

/** Begins to look for a race. */
function begin() {
  /** @type {ReturnType<typeof makeRace> | null} */
  let show = null;
  onMessage("race", (now) => {
    race = now;
    if (!show && !now.on) return;
    if (!show) {
      show = makeRace();
      drawFinish();
      drawRival();
    }
    show(now);
  });
  onMessage("raceAnswer", ({ problem }) => (problem ? gallery.say(problem) : gallery.close()));
}

/** @type {import("../../ui/feature.js").Feature<"race">} */
export default { commands: { race: openRace }, begin };
