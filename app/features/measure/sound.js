// @ts-check
/**
 * Plots that are heard: what is in view in three seconds, or the newest values while the body moves. A line on the plot shows
 * where the sound is. `app/ui/pitch.js` has the pitches.
 */
import { pageState } from "../../wire/channel.js";
import { access } from "../../ui/access.js";
import { addTeller } from "../../ui/dialog.js";
import { controlOf } from "../../ui/gui/gui.js";
import { Plot } from "../../ui/gui/plot.js";
import { loudspeaker, note } from "../../ui/loudspeaker.js";
import { Follower, panOf, scoreOf } from "../../ui/pitch.js";
import { few } from "../modes/shapes.js";
import { Voice } from "../../ui/voice.js";
import { say } from "../../words/words.js";
import { markPhase } from "./phase.js";

/**
 * @typedef {import("../../wire/wire.js").Melody} Melody
 * @typedef {import("../../wire/wire.js").HeardLine} Line
 * @typedef {import("../../ui/pitch.js").Tone} Tone
 */

/** Seconds in which a plot is played. */
const LASTS = 3;
/** Seconds from the press to the first tone. */
const BEFORE = 0.05;
/** Seconds of the way from one tone to the next, or to silence: while it is played, and while the body moves. */
const WAY = 0.006;
const LIVE_WAY = 0.03;
/** Loudness of all lines together. */
const LOUDNESS = 0.35;
/** Milliseconds without a value after which the tones of a moving body fall silent: one at rest has a value a second. */
const FORGOTTEN = 1500;

/** A tone as it is remembered. @param {Line} line @param {Voice} voice @param {Tone[]} tones @param {number} at ms */
const noteTone = (line, voice, tones, at) =>
  note({ kind: "tone", at, pan: voice.pan, name: line.name, tones: tones.map(({ pitch, gain }) => [pitch, gain]) });

/**
 * What is said of a melody: which of several plots it is, each line with its ends and its side, and what passes meanwhile.
 *
 * @param {Melody} melody
 */
function inWords({ number = 1, count = 1, way, moments, lines }) {
  const told = lines.map(({ name, unit, values }, i) => {
    const finite = values.filter((value) => value !== null);
    if (!finite.length) return say("melody-none", { name });
    const said = { name, low: few(Math.min(...finite)), high: few(Math.max(...finite)), unit };
    if (lines.length < 2) return say("melody-heard", said);
    if (i === 0) return say("melody-heard.left", said);
    return i === lines.length - 1 ? say("melody-heard.right", said) : say("melody-heard.between", said);
  });
  const ends = { from: few(moments[0]), to: few(moments[moments.length - 1]) };
  const which = count > 1 ? [say("melody-which", { number: String(number), count: String(count) })] : [];
  return [...which, ...told, way === "frequency" ? say("melody-passes.frequency", ends) : say("melody-passes", ends)].join(" ");
}

/** Shows on a plot over time where the sound is, or no longer. @param {string} plot @param {number | null} time */
function markTime(plot, time) {
  const control = controlOf(plot);
  if (control instanceof Plot) control.hear(time);
}

/** Shows on a plot where its melody is, or no longer. @param {Melody} melody @param {number | null} at number of the value */
function mark({ plot, way, moments, lines }, at) {
  const element = controlOf(plot)?.element;
  if (way === "time") markTime(plot, at === null ? null : moments[at]);
  else if (!element) return;
  else if (at === null) markPhase(element, null, null);
  else if (way === "frequency") markPhase(element, moments[at], null);
  else markPhase(element, lines[lines.length - 1].values[at], lines[0].values[at]);
}

/** A melody while it is played. */
class Played {
  /** @param {Melody} melody */
  constructor(melody) {
    this.melody = melody;
    const { context, out } = loudspeaker();
    const begin = context.currentTime + BEFORE;
    this.began = performance.now() + 1e3 * BEFORE;
    const { lines } = melody;
    this.voices = lines.map((_, i) => new Voice(context, out, panOf(i, lines.length), LOUDNESS / lines.length));
    lines.forEach((line, i) => {
      for (const { at, tones, clicks } of scoreOf(line, LASTS)) {
        this.voices[i].play(tones, begin + at, WAY);
        const clicked = clicks && this.voices[i].click(begin + at);
        noteTone(line, this.voices[i], tones, this.began + 1e3 * at);
        if (clicked) note({ kind: "click", at: this.began + 1e3 * at, pan: this.voices[i].pan, name: line.name });
      }
      this.voices[i].play([], begin + LASTS, WAY);
    });
    note({ kind: "silence", at: this.began + 1e3 * LASTS });
    this.over = false;
    this.draw();
  }

  draw() {
    if (this.over) return;
    const { moments } = this.melody;
    const part = (performance.now() - this.began) / (1e3 * LASTS);
    if (part >= 1) return this.end();
    mark(this.melody, Math.min(Math.max(Math.floor(part * moments.length), 0), moments.length - 1));
    requestAnimationFrame(() => this.draw());
  }

  end() {
    if (this.over) return;
    this.over = true;
    for (const voice of this.voices) voice.stop();
    mark(this.melody, null);
  }
}

/** The newest values of a plot while the body moves. */
class Live {
  /** @type {{voice: Voice, follower: Follower}[]} */
  lines = [];
  plot = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  late = undefined;
  sounds = false;

  /** @param {import("../../wire/wire.js").Tones} told */
  take({ plot = "", time = 0, lines = [] }) {
    if (plot !== this.plot || lines.length !== this.lines.length) this.end();
    this.plot = plot;
    if (!plot || !lines.length || !access().sound) return;
    const { context, out } = loudspeaker();
    if (!this.lines.length) {
      this.lines = lines.map((_, i) => ({ voice: new Voice(context, out, panOf(i, lines.length), LOUDNESS / lines.length), follower: new Follower() }));
    }
    markTime(plot, time);
    if (!pageState().playing) return;
    lines.forEach((line, i) => {
      const { voice, follower } = this.lines[i];
      const { tones, clicks } = follower.next(line.values[0], line);
      voice.play(tones, context.currentTime, LIVE_WAY);
      noteTone(line, voice, tones, performance.now());
      if (clicks && voice.click(context.currentTime)) note({ kind: "click", at: performance.now(), pan: voice.pan, name: line.name });
    });
    this.sounds = true;
    clearTimeout(this.late);
    this.late = setTimeout(() => this.rest(), FORGOTTEN);
  }

  rest() {
    if (!this.sounds) return;
    this.sounds = false;
    for (const { voice } of this.lines) voice.play([], voice.context.currentTime, LIVE_WAY);
    note({ kind: "silence", at: performance.now() });
  }

  end() {
    clearTimeout(this.late);
    this.rest();
    if (this.plot) markTime(this.plot, null);
    for (const { voice } of this.lines) voice.stop();
    this.lines = [];
  }
}

const tell = addTeller();
/** @type {Played | null} */
let played = null;
const live = new Live();

/** @param {Melody} melody */
function play(melody) {
  played?.end();
  played = null;
  if (!melody.plot || !melody.lines.length) tell(say("melody-no-plot"));
  else if (!access().sound) tell(say("melody-off"));
  else {
    played = new Played(melody);
    tell(inWords(melody));
  }
}

/** @param {import("../../wire/wire.js").Received["melody" | "tones" | "pageState"]} message */
export function hear(message) {
  if (message.tell === "melody") play(message);
  else if (message.tell === "tones") live.take(message);
  else if (!message.playing) live.rest();
}
