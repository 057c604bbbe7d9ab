// @ts-check
/** The tones of one line of a plot, on its side, and its clicks. */
import { click } from "./loudspeaker.js";

/** @typedef {import("./pitch.js").Tone} Tone */

/** Seconds in which a voice that is stopped dies away. */
const ENDS = 0.006;
/** A click: seconds, loudness, Hz, and how much shorter after another one it is left out, ms. */
const CLICK = { seconds: 0.008, loud: 0.9, pitch: 3200, apart: 40 };

export class Voice {
  /** @param {BaseAudioContext} context @param {AudioNode} to @param {number} pan @param {number} loud */
  constructor(context, to, pan, loud) {
    this.context = context;
    this.pan = pan;
    this.out = context.createStereoPanner();
    this.out.pan.value = pan;
    this.out.connect(to);
    this.loud = loud;
    /** @type {{oscillator: OscillatorNode, gain: GainNode}[]} */
    this.all = [];
    this.clicked = -Infinity;
  }

  /** @param {Tone[]} tones @param {number} at seconds of the context @param {number} way seconds */
  play(tones, at, way) {
    while (this.all.length < tones.length) {
      const [oscillator, gain] = [this.context.createOscillator(), this.context.createGain()];
      gain.gain.value = 0;
      oscillator.frequency.value = tones[this.all.length].pitch;
      oscillator.connect(gain).connect(this.out);
      oscillator.start();
      this.all.push({ oscillator, gain });
    }
    this.all.forEach(({ oscillator, gain }, i) => {
      if (tones[i]) oscillator.frequency.setTargetAtTime(tones[i].pitch, at, way);
      gain.gain.setTargetAtTime(this.loud * (tones[i]?.gain ?? 0), at, way);
    });
  }

  /** @param {number} at seconds of the context */
  click(at) {
    if (1e3 * (at - this.clicked) < CLICK.apart) return false;
    this.clicked = at;
    click(this.context, this.out, CLICK.seconds, CLICK.loud, CLICK.pitch, at);
    return true;
  }

  stop() {
    for (const { oscillator, gain } of this.all) {
      gain.gain.cancelScheduledValues(this.context.currentTime);
      gain.gain.setTargetAtTime(0, this.context.currentTime, ENDS);
      oscillator.stop(this.context.currentTime + 10 * ENDS);
    }
  }
}
