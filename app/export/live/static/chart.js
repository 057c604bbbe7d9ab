// @ts-check
/**
 * A small plot in a canvas: quantities over time, or over another one.
 *
 * @typedef {Pick<import("./quantities.js").Recording, "times" | "values" | "swings">} Recording
 * @typedef {object} Plot
 * @property {string[]} names of the quantities
 * @property {string[]} words what they are called
 * @property {string[]} units of each
 * @property {string} over what they are plotted over; empty for the time
 * @property {string} overWords what that is called
 * @property {string} overUnit
 * @property {boolean} turned whether y grows downwards
 */
import { axisMarks, rangeOf } from "../../../stage/axes.js";
import { make } from "../../../ui/dialog.js";
import { numbersOf, sentenceOf } from "../../../ui/plot_words.js";
import { joined, say, tied, upright } from "../../../words/words.js";
import { said } from "./readings.js";

/** Simulated seconds that a plot over time shows. */
const SPAN = 10;
/** Margins of the curves, pixels, and at the left and below as multiples of the size of letters: numbers have room there. */
const RIGHT = 10;
const TOP = 8;
const LETTERS_LEFT = 5.2;
const LETTERS_BELOW = 1.8;
/** Lines of the grid in one direction. */
const LINES = 4;
/** Colours of the curves, in turn. */
const COLORS = ["brand", "pulled", "torque-plus", "torque-minus", "held"];

/** @param {Plot} plot @returns {{element: HTMLElement, draw: (record: Recording) => void}} */
export function makeChart(plot) {
  const { names, words, units, over, overWords, overUnit, turned } = plot;
  const element = make("figure", "chart");
  const title = make("figcaption", "");
  title.ariaHidden = "true"; // the image's name has these words, with the numbers
  words.forEach((word, i) => {
    const quantity = word + (units[i] && `, ${units[i]}`);
    const key = make("span", "", turned ? say("live-downwards", { quantity }) : quantity);
    key.prepend(make("i", `key-${COLORS[i % COLORS.length]}`));
    title.append(key, " ");
  });
  if (over) title.append(make("span", "", say("live-over", { quantity: overWords + (overUnit && `, ${overUnit}`) })));
  const canvas = make("canvas", "");
  canvas.setAttribute("role", "img");
  const reading = make("p", "reading");
  /** What is in view, in numbers. @type {{along: import("../../../ui/plot_words.js").Along, curves: import("../../../ui/plot_words.js").Curve[]}} */
  let shown = { along: { label: "", values: [], isTime: true }, curves: [] };
  element.append(title, canvas, reading, numbersOf(() => shown));
  let due = 0;
  /** The moment that is pointed at, simulated seconds. @type {number | null} */
  let marked = null;
  /** When the sample nearest to a place was taken. @type {(x: number, y: number) => number | null} */
  let timeAt = () => null;
  /** @type {Recording | null} */
  let last = null;

  /** @param {number | null} time */
  const mark = (time) => {
    marked = time;
    due = 0;
    if (last) draw(last);
  };
  for (const kind of /** @type {const} */ (["pointerdown", "pointermove"])) {
    canvas.addEventListener(kind, ({ clientX, clientY }) => {
      const { left, top } = canvas.getBoundingClientRect(); // on a projector, offsets count smaller pixels
      mark(timeAt(clientX - left, clientY - top));
    });
  }
  // A finger that is lifted leaves the mark where it was.
  canvas.addEventListener("pointerleave", ({ pointerType }) => pointerType === "mouse" && mark(null));

  /** @param {Recording} record */
  function draw(record) {
    last = record;
    const to = canvas.getContext("2d");
    if (!to) return;
    const { width, height } = canvas.getBoundingClientRect();
    if (!(width > 0)) return;
    const fine = devicePixelRatio;
    const [across, down] = [Math.round(width * fine), Math.round(height * fine)];
    if (canvas.width !== across || canvas.height !== down) [canvas.width, canvas.height] = [across, down];
    to.setTransform(fine, 0, 0, fine, 0, 0);
    to.clearRect(0, 0, width, height);
    const styles = getComputedStyle(document.documentElement);
    /** @param {string} name */
    const styled = (name) => styles.getPropertyValue(`--softrod-${name}`);
    const end = record.times[record.times.length - 1] ?? 0;
    const first = over ? 0 : Math.max(0, record.times.findIndex((time) => time >= end - SPAN));
    const curves = names.map((name) => (record.values.get(name) ?? []).slice(first));
    const along = (over ? (record.values.get(over) ?? []) : record.times).slice(first);
    const [low, high] = rangeOf(curves);
    const [from, until] = over ? rangeOf([along]) : [Math.max(0, end - SPAN), Math.max(SPAN, end)];
    // On a projector letters are larger.
    const letters = Math.max(12, 0.7 * parseFloat(getComputedStyle(element).fontSize));
    const left = LETTERS_LEFT * letters, bottom = LETTERS_BELOW * letters;
    const x = (/** @type {number} */ value) => left + ((value - from) / (until - from)) * (width - left - RIGHT);
    const y = (/** @type {number} */ value) => {
      const part = (value - low) / (high - low);
      return TOP + (turned ? part : 1 - part) * (height - TOP - bottom);
    };
    Object.assign(to, { lineWidth: 1, strokeStyle: styled("line"), fillStyle: styled("text"), font: `${letters}px ${styled("font")}` });
    to.beginPath();
    to.textAlign = "right";
    to.textBaseline = "middle";
    for (const value of axisMarks(low, high, LINES)) {
      to.moveTo(left, y(value));
      to.lineTo(width - RIGHT, y(value));
      to.fillText(said(value), left - 6, y(value));
    }
    to.textAlign = "center";
    to.textBaseline = "top";
    for (const value of axisMarks(from, until, LINES)) {
      to.moveTo(x(value), TOP);
      to.lineTo(x(value), height - bottom);
      to.fillText(`${said(value)}${over ? "" : " s"}`, Math.min(x(value), width - 1.4 * letters), height - bottom + 5);
    }
    to.stroke();
    Object.assign(to, { lineWidth: 2, lineJoin: "round" });
    curves.forEach((values, i) => {
      to.strokeStyle = styled(COLORS[i % COLORS.length]);
      to.beginPath();
      values.forEach((value, k) => (k ? to.lineTo(x(along[k]), y(value)) : to.moveTo(x(along[k]), y(value))));
      to.stroke();
    });
    const times = record.times.slice(first);
    timeAt = (toX, toY) => {
      const away = along.map((value, k) => Math.hypot(x(value) - toX, over ? y(curves[0][k]) - toY : 0));
      return times[away.indexOf(Math.min(...away))] ?? null;
    };
    const at = marked === null || marked < times[0] ? -1 : times.findIndex((time) => time >= Number(marked));
    if (at >= 0) {
      Object.assign(to, { lineWidth: 1, strokeStyle: styled("text") });
      to.strokeRect(x(along[at]), TOP, 0, height - TOP - bottom);
    }
    const now = performance.now();
    if (now < due) return;
    due = now + 250;
    const found = names.map((name) => (over ? null : record.swings(name)));
    const told = names.map((_, i) => {
      const values = curves[i], swing = found[i];
      if (!values.length) return "";
      const reading = `${words[i]}: ${upright(`${said(values[at >= 0 ? at : values.length - 1])} ${units[i]}`.trim())}`;
      if (at >= 0 || !swing) return reading;
      return say("live-swing", { reading, period: said(swing.period), amplitude: upright(`${said(swing.amplitude)} ${units[i]}`.trim()) });
    });
    /** @param {"period" | "amplitude"} what */
    const of = (what) => joined(found.map((swing) => said(swing?.[what] ?? 0)));
    const readings = joined(told, "language-semicolon");
    if (at >= 0) reading.textContent = tied(say("live-at", { time: said(times[at]), readings }));
    else if (names.length <= 2) reading.textContent = tied(readings);
    else if (!found.every(Boolean)) reading.textContent = "";
    else reading.textContent = say("live-swings", { periods: of("period"), amplitudes: upright(`${of("amplitude")} ${units[0]}`.trim()) });
    /** @param {string} name @param {string} unit */
    const labelled = (name, unit) => joined([name, unit]);
    shown = {
      along: { label: over ? labelled(overWords, overUnit) : say("ui-plot-time"), values: along, isTime: !over },
      curves: words.map((word, i) => ({ label: labelled(word, units[i]), values: curves[i] })),
    };
    canvas.ariaLabel = shown.curves.map((curve) => sentenceOf(curve, shown.along)).join(" ");
  }
  return { element, draw };
}
