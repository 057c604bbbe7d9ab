// @ts-check
/**
 * The strip of a race over the bar of time: how far each body has come, which is ahead or was first, another body that joins,
 * and a start after a count-down. It is made at the first race.
 */
import { canvasBox } from "../../ui/viser/viser.js";
import { onMessage, pageState } from "../../wire/channel.js";
import { sendParts } from "../../ui/kept/links.js";
import { withKey } from "../../ui/hands/key_table.js";
import { make, makeButton, overCanvas } from "../../ui/dialog.js";
import { distance, fullRace, isOver, namesOf, verdict } from "./words.js";
import { addRaceMarks } from "./marks.js";
import { fit } from "../../stage/camera.js";
import { redrawMarks } from "../../stage/sight.js";
import { theGallery } from "../gallery/gallery.js";
import { makeStrip } from "../../ui/strip.js";
import { perform } from "../../wire/perform.js";
import { decimal, listed, say } from "../../words/words.js";

/** @typedef {import("../../wire/wire.js").Race} Race */

/** Milliseconds of each number of the count-down, and of the word after it. */
const COUNT = 700;
/** Milliseconds between two readings for a screen reader. */
const READ_EVERY = 3000;
/** The group of presets that move by themselves. */
const MOVING = say("gallery-muscles");
const GO = say("race-go");

let race = fullRace({ tell: "race" });

/** Begins a race against a scene, by its link or its name. @param {string} text */
const raceAgainst = (text) => void sendParts("rival", encodeURIComponent(text.trim()));

/** The line of the gallery into which a link to a rival is pasted. */
function makeLine() {
  const line = make("form", "softrod-dialog-line softrod-rival");
  const pasted = make("input", "softrod-search");
  pasted.placeholder = say("race-choose.paste");
  pasted.ariaLabel = say("race-choose.link");
  line.append(pasted, make("button", "softrod-button softrod-first", say("race-choose.go")));
  line.addEventListener("submit", (event) => {
    event.preventDefault();
    if (pasted.value.trim()) raceAgainst(pasted.value);
  });
  return line;
}

/** Chooses a rival, or one more. */
const chooseRival = () => theGallery().open({ title: say("race-choose"), line: makeLine(), first: MOVING, pick: raceAgainst });

/** Chooses a rival; or in a race, starts it again. */
export const openRace = () => (race.on ? start() : chooseRival());

/** The row of one of the bodies. @param {number} i */
function makeRow(i) {
  const row = make("div", `softrod-race-row softrod-race-${i ? "theirs" : "mine"}`);
  const [who, track, bar, way] = [make("b", ""), make("span", "softrod-race-track"), make("i", ""), make("output", "")];
  way.ariaLive = "off"; // what is read out is the line above
  track.append(bar);
  row.append(who, track, way);
  return { row, who, bar, way };
}

let start = () => {};

function makeRace() {
  const { strip, head, says, live, show } = makeStrip("race", say("race-strip"));
  const begin = makeButton(say("race-start"), () => start(), "softrod-race-start");
  begin.title = withKey(say("race-start.hint"), "race");
  const leave = makeButton(say("race-leave"), () => perform("leaveRace"), "");
  leave.title = say("race-leave.hint");
  const add = makeButton(say("race-add"), chooseRival, "");
  add.title = say("race-add.hint");
  head.append(begin, add, leave);
  /** @type {ReturnType<typeof makeRow>[]} */
  let rows = [];
  const rule = make("small", "softrod-race-rule", say("race-rule"));
  strip.append(rule);
  const count = make("div", "softrod-count");
  count.ariaLive = "assertive";
  count.hidden = true;
  overCanvas().append(count);

  let [counting, read, before] = [0, 0, 0];
  const stopCount = () => {
    clearTimeout(counting);
    counting = 0;
    count.hidden = true;
  };
  /** @param {number} left */
  const countDown = (left) => {
    count.hidden = false;
    count.textContent = left ? String(left) : GO;
    const box = canvasBox();
    if (box) Object.assign(count.style, { left: `${box.left + box.width / 2}px`, top: `${box.top + box.height / 3}px` });
    if (!left) perform("run");
    counting = setTimeout(() => (left ? countDown(left - 1) : stopCount()), COUNT);
  };
  start = () => {
    stopCount();
    perform("pause");
    perform("reset");
    fit(true);
    begin.blur(); // the keys are the bodies'
    countDown(3);
  };
  window.addEventListener("keydown", ({ key }) => key === "Escape" && stopCount(), true);
  onMessage("pageState", ({ playing }) => playing && counting && count.textContent !== GO && stopCount());
  return (/** @type {Required<Race>} */ now) => {
    const { on, ways, seconds, fair, finish, arrived } = now;
    if (strip.hidden === on) live.textContent = on ? say("race-begins", { names: listed(namesOf(now).slice(1)), start: withKey(say("race-start"), "race") }) : say("race-left");
    else if (seconds < before) live.textContent = ""; // so that the same result is read out again
    before = seconds;
    show(on);
    if (!on) stopCount();
    if (rows.length !== ways.length) {
      for (const { row } of rows) row.remove();
      rows = ways.map((_, i) => makeRow(i));
      for (const { row } of rows) rule.before(row);
    }
    add.hidden = !now.more;
    rows.forEach(({ who, bar, way }, i) => {
      const name = namesOf(now)[i];
      if (who.textContent !== name) who.textContent = name;
      const part = finish ? Math.max(0, Math.min(1, ways[i] / finish)) : 0;
      bar.style.transform = `scaleX(${(arrived[i] === null ? part : 1).toFixed(4)})`;
      way.textContent = arrived[i] === null ? distance(ways[i] * Math.sign(finish)) : `${decimal(Number(arrived[i]).toFixed(2))} s`;
    });
    const begun = seconds > 0;
    const someoneIsThere = arrived.some((time) => time !== null);
    const isDecided = someoneIsThere || isOver(now);
    const result = isDecided ? verdict(now) : say("race-so-far", { verdict: verdict(now), seconds: decimal(seconds.toFixed(1)) });
    const text = fair ? result : say("race-unfair", { verdict: result });
    const shown = begun ? text : say("race-at-start");
    if (says.textContent !== shown) says.textContent = shown;
    begin.textContent = say(begun ? "race-start.again" : "race-start");
    rule.hidden = begun && fair;
    if (!begun || !on) return;
    /** @param {string} words */
    const tell = (words) => live.textContent !== words && (live.textContent = words);
    if (isOver(now) || !pageState().playing) tell(text);
    else if (!someoneIsThere && performance.now() - read > READ_EVERY) {
      read = performance.now();
      tell(verdict(now, false));
    }
  };
}

/** @type {ReturnType<typeof makeRace> | null} */
let show = null;

/** Shows a race. @param {Race} now */
function hearRace(now) {
  const before = race.lines.length;
  race = fullRace(now);
  if (!show && !race.on) return;
  if (!show) addRaceMarks(() => race);
  // All are at their starts, which may be far from where the body was seen last; alone, it may have become a dot.
  if (race.lines.length !== before) requestAnimationFrame(() => fit(true));
  show ??= makeRace();
  show(race);
  redrawMarks();
}

/** @param {Race | import("../../wire/wire.js").RaceAnswer} message */
export function hear(message) {
  if (message.tell === "race") hearRace(message);
  else if (message.problem) theGallery().say(message.problem);
  else theGallery().close();
}
