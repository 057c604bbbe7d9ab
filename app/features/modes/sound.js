// @ts-check
/**
 * The sound of a body: each of its modes a tone as loud as the mode is large, and clicks where it touches something or
 * breaks. It is off until it is asked for; browsers let nothing sound before a gesture, either.
 */
import { tonesOf } from "./tones.js";
import { onMessage, pageState } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { withKey } from "../../ui/hands/key_table.js";
import { kept, store } from "../../ui/kept/storage.js";

/**
 * @typedef {import("./tones.js").Tone} Tone
 * @typedef {import("./shapes.js").Levels} Levels
 */

const STORED = "softrod-volume";
/** Seconds in which a tone follows a change, after which it goes on by its own decay, and in which all fall silent. */
const [FOLLOWS, OWN, ENDS] = [0.02, 0.1, 0.05];
/** Energies of what is pressed together, in those of a full bar, between which a touch begins. */
const [LOOSE, TOUCH] = [1e-6, 1e-4];
/** Seconds of a click, and of what breaks. */
const [CLICK, CRACK] = [0.03, 0.12];
/** Seconds between two clicks, at least. */
const APART = 0.05;

const ON = "M4 9v6h4l5 4V5L8 9zM16 9a4 4 0 0 1 0 6M18.500 6.500a8 8 0 0 1 0 11";
const OFF = "M4 9v6h4l5 4V5L8 9zM16 9.500l5 5M21 9.500l-5 5";

/** Tones that go on, each with its own loudness. */
export class Voices {
  /** @param {BaseAudioContext} context @param {AudioNode} to where they are heard */
  constructor(context, to) {
    this.context = context;
    this.to = to;
    /** @type {{oscillator: OscillatorNode, gain: GainNode}[]} */
    this.all = [];
  }

  /** Has as many of them as there are tones, silent at first. @param {number} count @param {number} at seconds of the context */
  count(count, at) {
    while (this.all.length > count) this.all.pop()?.oscillator.stop(at);
    while (this.all.length < count) {
      const [oscillator, gain] = [this.context.createOscillator(), this.context.createGain()];
      gain.gain.value = 0;
      oscillator.connect(gain).connect(this.to);
      oscillator.start(at);
      this.all.push({ oscillator, gain });
    }
  }

  /** Each follows its tone, and dies away with that from then on. @param {Tone[]} tones @param {number} at seconds of the context */
  follow(tones, at) {
    this.count(tones.length, at);
    tones.forEach(({ pitch, gain: loud, decay }, i) => {
      const { oscillator, gain } = this.all[i];
      if (pitch > 0 && oscillator.frequency.value !== pitch) oscillator.frequency.setValueAtTime(pitch, at);
      gain.gain.cancelScheduledValues(at);
      gain.gain.setTargetAtTime(loud, at, FOLLOWS);
      if (decay > 0) gain.gain.setTargetAtTime(0, at + OWN, 1 / decay);
    });
  }

  /** All fall silent. @param {number} at seconds of the context */
  rest(at) {
    for (const { gain } of this.all) {
      gain.gain.cancelScheduledValues(at);
      gain.gain.setTargetAtTime(0, at, ENDS / 3);
    }
  }
}

/**
 * A short noise.
 *
 * @param {BaseAudioContext} context @param {AudioNode} to
 * @param {number} seconds @param {number} loud 0..1 @param {number} pitch Hz about which it lies
 */
function click(context, to, seconds, loud, pitch) {
  const buffer = context.createBuffer(1, Math.ceil(4 * seconds * context.sampleRate), context.sampleRate);
  const samples = buffer.getChannelData(0);
  for (let i = 0; i < samples.length; i++) {
    samples[i] = loud * (2 * Math.random() - 1) * Math.exp(-i / (seconds * context.sampleRate));
  }
  const [source, filter] = [context.createBufferSource(), context.createBiquadFilter()];
  Object.assign(source, { buffer });
  filter.type = "bandpass";
  filter.frequency.value = pitch;
  source.connect(filter).connect(to);
  source.start();
}

/** Everything that sounds on a page goes through this; null before the first gesture. @type {{context: AudioContext, out: GainNode} | null} */
let heard = null;
let volume = Number(kept(STORED) || 0.5);

/** Where sound goes; to be called in a gesture for the first time. */
export function loudspeaker() {
  if (!heard) {
    const context = new AudioContext();
    const [out, limit] = [context.createGain(), context.createDynamicsCompressor()];
    out.gain.value = volume * volume;
    out.connect(limit).connect(context.destination);
    heard = { context, out };
  }
  void heard.context.resume();
  return heard;
}

/** @type {() => void} */
let toggle = () => {};
/** Turns the sound of the modes on or off, while they are shown. */
export const toggleSound = () => toggle();

/** The button and the volume, and what sounds. */
export function addSound() {
  const button = makeButton("", () => turn(!on), "softrod-modes-sound");
  const slider = make("input", "softrod-modes-volume");
  Object.assign(slider, { type: "range", min: "0", max: "1", step: "0.05", value: String(volume), ariaLabel: "Volume", title: "Volume" });
  let on = false;
  /** @type {Voices | null} */
  let voices = null;
  /** @type {ArrayLike<number>} */
  let frequencies = [];
  /** @type {ArrayLike<number>} */
  let dampings = [];
  let loose = true;
  let broken = 0;
  let clicked = 0;

  const show = () => {
    button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${on ? ON : OFF}"/></svg>`;
    button.ariaLabel = "Sound of the modes";
    button.ariaPressed = String(on);
    button.title = withKey(on ? "Sound: on" : "Sound: off", "mute");
    slider.hidden = !on;
  };
  /** @param {boolean} to */
  const turn = (to) => {
    on = to && frequencies.length > 0;
    if (on) {
      const { context, out } = loudspeaker();
      voices ??= new Voices(context, out);
      broken = pageState().broken ?? 0;
    } else if (heard && voices) {
      voices.rest(heard.context.currentTime);
    }
    show();
  };
  toggle = () => frequencies.length > 0 && turn(!on);
  slider.addEventListener("input", () => {
    volume = Number(slider.value);
    store(STORED, String(volume));
    // As loudness is heard.
    heard?.out.gain.setTargetAtTime(volume * volume, heard.context.currentTime, FOLLOWS);
  });
  /** @param {number} seconds @param {number} loud @param {number} pitch */
  const knock = (seconds, loud, pitch) => {
    if (!heard || performance.now() / 1e3 - clicked < APART) return;
    clicked = performance.now() / 1e3;
    click(heard.context, heard.out, seconds, loud, pitch);
  };
  onMessage("pageState", ({ playing, broken: now = 0 }) => {
    if (on && heard && voices && !playing) voices.rest(heard.context.currentTime);
    if (on && now > broken) knock(CRACK, 0.9, 900);
    broken = now;
  });
  show();
  return {
    controls: [button, slider],
    /** The modes that sound; none while they are not looked at. @param {ArrayLike<number>} hertz @param {ArrayLike<number>} ratios */
    use(hertz, ratios) {
      [frequencies, dampings] = [hertz, ratios];
      button.disabled = !hertz.length;
      if (!hertz.length && on) turn(false);
    },
    /** How large they are now. @param {Levels} levels */
    hear({ levels, touching }) {
      if (on && heard && voices && pageState().playing) {
        voices.follow(tonesOf(frequencies, dampings, levels, pageState().speed ?? 1), heard.context.currentTime);
        if (loose && touching > TOUCH) knock(CLICK, Math.min(0.15 + Math.sqrt(touching), 1), 2400);
      }
      if (touching > TOUCH) loose = false;
      else if (touching < LOOSE) loose = true;
    },
  };
}
