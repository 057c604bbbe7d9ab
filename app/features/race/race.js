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
import { say } from "../../words/words.js";

/** @typedef {import("../../wire/wire.js").Race} Race */

/** Milliseconds of each number of the count-down, and of the word after it. */
const COUNT = 700;
/** Milliseconds between two readings for a screen reader. */
const READ_EVERY = 3000;
/** The group of presets that move by themselves. */
const MOVING = say("gallery-muscles");
const RULE =
  "All start together, on this body's terrain, and the middle of each counts at the finish. Changes of this body and of the terrain are allowed, and are noted here; Race again makes it fair.";

let race = fullRace({ tell: "race" });

/** Begins a race against a scene, by its link or its name. @param {string} text */
const raceAgainst = (text) => void sendParts("rival", encodeURIComponent(text.trim()));

/** The line of the gallery into which a link to a rival is pasted. */
function makeLine() {
  const line = make("form", "softrod-dialog-line softrod-rival");
  const pasted = make("input", "softrod-search");
  pasted.placeholder = "Paste a link, or choose below";
  pasted.ariaLabel = "Link to the scene to race against";
  line.append(pasted, make("button", "softrod-button softrod-first", "Race"));
  line.addEventListener("submit", (event) => {
    event.preventDefault();
    if (pasted.value.trim()) raceAgainst(pasted.value);
  });
  return line;
}

/** Chooses a rival, or one more. */
const chooseRival = () => theGallery().open({ title: "Race against", line: makeLine(), first: MOVING, pick: raceAgainst });

/** Chooses a rival; or in a race, starts it again. */
const openRace = () => (race.on ? start() : chooseRival());

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
  const { strip, head, says, live, show } = makeStrip("race", "Race");
  const begin = makeButton("Start", () => start(), "softrod-race-start");
  begin.title = withKey("All from the start, after a count-down", "race");
  const leave = makeButton("Leave", () => perform("leaveRace"), "");
  leave.title = "Leave the race; this body goes on alone";
  const add = makeButton("Add", chooseRival, "");
  add.title = "Another body joins the race";
  head.append(begin, add, leave);
  /** @type {ReturnType<typeof makeRow>[]} */
  let rows = [];
  const rule = make("small", "softrod-race-rule", RULE);
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
    fit(true);
    begin.blur(); // the keys are the bodies'
    countDown(3);
  };
  window.addEventListener("keydown", ({ key }) => key === "Escape" && stopCount(), true);
  onMessage("pageState", ({ playing }) => playing && counting && count.textContent !== "Go!" && stopCount());
  return (/** @type {Required<Race>} */ now) => {
    const { on, ways, seconds, fair, finish, arrived } = now;
    if (strip.hidden === on) live.textContent = on ? `A race against ${namesOf(now).slice(1).join(" and ")}. ${withKey("Start", "race")}.` : "The race is left";
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
      way.textContent = arrived[i] === null ? distance(ways[i] * Math.sign(finish)) : `${arrived[i]?.toFixed(2)} s`;
    });
    const begun = seconds > 0;
    const someoneIsThere = arrived.some((time) => time !== null);
    const after = someoneIsThere || isOver(now) ? "" : `, after ${seconds.toFixed(1)} s`;
    const text = begun ? `${verdict(now)}${after}${fair ? "" : "; changed or moved on the way"}` : "";
    if (says.textContent !== (text || "At the start")) says.textContent = text || "At the start";
    begin.textContent = begun ? "Race again" : "Start";
    rule.hidden = begun && fair;
    if (!begun || !on) return;
    /** @param {string} words */
    const tell = (words) => live.textContent !== words && (live.textContent = words);
    if (isOver(now) || !pageState().playing) tell(text);
    else if (!someoneIsThere && performance.now() - read > READ_EVERY) {
      read = performance.now();
      tell(verdict(now).replace(/ by .*/, ""));
    }
  };
}

/** Begins to look for a race. */
function begin() {
  /** @type {ReturnType<typeof makeRace> | null} */
  let show = null;
  onMessage("race", (now) => {
    const before = race.lines.length;
    race = fullRace(now);
    if (!show && !race.on) return;
    if (!show) addRaceMarks(() => race);
    // All are at their starts, which may be far from where the body was seen last; alone, it may have become a dot.
    if (race.lines.length !== before) requestAnimationFrame(() => fit(true));
    show ??= makeRace();
    show(race);
    redrawMarks();
  });
  onMessage("raceAnswer", ({ problem }) => (problem ? theGallery().say(problem) : theGallery().close()));
}

/** @type {import("../../ui/feature.js").Feature<"race">} */
export default { commands: { race: openRace }, begin };
