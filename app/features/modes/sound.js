// @ts-check
/**
 * The sound of a body: a tone for each of its modes, as loud as the mode is large, and clicks when it touches something
 * or breaks. It is off until it is turned on; browsers allow no sound before a gesture, either.
 */
import { tonesOf } from "./tones.js";
import { onMessage, pageState } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { withKey } from "../../ui/hands/key_table.js";
import { click, loudspeaker, note, setVolume, volumeNow } from "../../ui/loudspeaker.js";
import { say } from "../../words/words.js";

/**
 * @typedef {import("./tones.js").Tone} Tone
 * @typedef {import("./shapes.js").Levels} Levels
 */

/** Seconds in which a tone follows a change. */
const FOLLOWS = 0.02;
/** Seconds after a change from which a tone decays by itself: the next levels are late. */
const DECAYS_AFTER = 0.1;
/** Seconds in which all tones fall silent. */
const ENDS = 0.05;
/** Contact energy, in full bars, below which the body touches nothing, and above which a touch clicks. */
const LOOSE = 1e-6;
const TOUCH = 1e-4;
/** Seconds in which a click dies away, and the crack of something that breaks. */
const CLICK = 0.03;
const CRACK = 0.12;
/** Least time between two clicks, s. */
const APART = 0.05;

const ON = "M4 9v6h4l5 4V5L8 9zM16 9a4 4 0 0 1 0 6M18.500 6.500a8 8 0 0 1 0 11";
const OFF = "M4 9v6h4l5 4V5L8 9zM16 9.500l5 5M21 9.500l-5 5";

/** Continuous tones, each with its own loudness. */
export class Voices {
  /** @param {BaseAudioContext} context @param {AudioNode} to where they are heard */
  constructor(context, to) {
    this.context = context;
    this.to = to;
    /** @type {{oscillator: OscillatorNode, gain: GainNode}[]} */
    this.all = [];
  }

  /** Makes as many of them as there are tones, silent at first. @param {number} count @param {number} at seconds of the context */
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

  /** Lets each follow its tone, and then die away as that does. @param {Tone[]} tones @param {number} at seconds of the context */
  follow(tones, at) {
    this.count(tones.length, at);
    tones.forEach(({ pitch, gain: loud, decay }, i) => {
      const { oscillator, gain } = this.all[i];
      if (pitch > 0 && oscillator.frequency.value !== pitch) oscillator.frequency.setValueAtTime(pitch, at);
      gain.gain.cancelScheduledValues(at);
      gain.gain.setTargetAtTime(loud, at, FOLLOWS);
      if (decay > 0) gain.gain.setTargetAtTime(0, at + DECAYS_AFTER, 1 / decay);
    });
  }

  /** Silences all. @param {number} at seconds of the context */
  rest(at) {
    for (const { gain } of this.all) {
      gain.gain.cancelScheduledValues(at);
      gain.gain.setTargetAtTime(0, at, ENDS / 3);
    }
  }
}

/** The button, the volume, and the sound. */
export function addSound() {
  const button = makeButton("", () => turn(!on), "softrod-modes-sound");
  const slider = make("input", "softrod-modes-volume");
  Object.assign(slider, { type: "range", min: "0", max: "1", step: "0.05", value: String(volumeNow()), ariaLabel: say("modes-volume"), title: say("modes-volume") });
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
    button.ariaLabel = say("modes-sound");
    button.ariaPressed = String(on);
    button.title = withKey(say(on ? "modes-sound.on" : "modes-sound.off"), "mute");
    slider.hidden = !on;
  };
  /** @param {boolean} to */
  const turn = (to) => {
    wanted = false;
    on = to && frequencies.length > 0;
    if (on) {
      const { context, out } = loudspeaker();
      voices ??= new Voices(context, out);
      broken = pageState().broken ?? 0;
    } else if (voices) {
      voices.rest(voices.context.currentTime);
    }
    show();
  };
  /** Whether the sound is wanted as soon as there are modes. */
  let wanted = false;
  slider.addEventListener("input", () => setVolume(Number(slider.value)));
  /** @param {number} seconds @param {number} loud @param {number} pitch */
  const knock = (seconds, loud, pitch) => {
    if (performance.now() / 1e3 - clicked < APART) return;
    clicked = performance.now() / 1e3;
    const { context, out } = loudspeaker();
    click(context, out, seconds, loud, pitch);
    note({ kind: "click", at: performance.now(), pan: 0 });
  };
  onMessage("pageState", ({ playing, broken: now = 0 }) => {
    if (on && voices && !playing) voices.rest(voices.context.currentTime);
    if (on && now > broken) knock(CRACK, 0.9, 900);
    broken = now;
  });
  show();
  return {
    controls: [button, slider],
    /** Turns the sound on or off; on without modes, once they are there. */
    toggle() {
      if (frequencies.length) turn(!on);
      else wanted = true;
    },
    /** Takes the modes that sound; none while the strip is closed. @param {ArrayLike<number>} hertz @param {ArrayLike<number>} ratios */
    use(hertz, ratios) {
      [frequencies, dampings] = [hertz, ratios];
      button.disabled = !hertz.length;
      if (!hertz.length && on) turn(false);
      if (hertz.length && wanted) turn(true);
    },
    /** Takes their present levels. @param {Levels} levels */
    hear({ levels, touching }) {
      if (on && voices && pageState().playing) {
        voices.follow(tonesOf(frequencies, dampings, levels, pageState().speed ?? 1), voices.context.currentTime);
        if (loose && touching > TOUCH) knock(CLICK, Math.min(0.15 + Math.sqrt(touching), 1), 2400);
      }
      if (touching > TOUCH) loose = false;
      else if (touching < LOOSE) loose = true;
    },
  };
}
