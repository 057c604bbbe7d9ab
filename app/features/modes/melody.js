// @ts-check
/** A plot as pitch, for those who cannot see it: the higher the value, the higher the tone. */
import { loudspeaker } from "./sound.js";
import { few } from "./shapes.js";
import { melodyOf } from "./tones.js";
import { onMessage } from "../../wire/channel.js";
import { make, overCanvas } from "../../ui/dialog.js";
import { say } from "../../words/words.js";

/** Seconds of a plot. */
const LASTS = 3;
/** Seconds of the transition from one tone to the next, or to silence. */
const WAY = 0.01;
const LOUDNESS = 0.3;

/** Begins to listen for plots that are to be heard. */
export function listenToMelodies() {
  const live = make("div", "softrod-tell");
  live.setAttribute("role", "status");
  overCanvas().append(live);
  /** @type {OscillatorNode | null} */
  let before = null;
  onMessage("melody", ({ name, unit, values }) => {
    const numbers = values.map((value) => value ?? Number.NaN);
    const finite = numbers.filter(Number.isFinite);
    if (!finite.length) {
      live.textContent = say("melody-none", { name });
      return;
    }
    before?.stop();
    const { context, out } = loudspeaker();
    const [oscillator, gain] = [context.createOscillator(), context.createGain()];
    const begin = context.currentTime + 0.05;
    gain.gain.value = 0;
    melodyOf(numbers).forEach((pitch, i) => {
      const at = begin + (i / numbers.length) * LASTS;
      if (pitch) oscillator.frequency.setTargetAtTime(pitch, at, i ? WAY : 1e-4);
      gain.gain.setTargetAtTime(pitch ? LOUDNESS : 0, at, WAY);
    });
    gain.gain.setTargetAtTime(0, begin + LASTS, WAY);
    oscillator.connect(gain).connect(out);
    oscillator.start(begin);
    oscillator.stop(begin + LASTS + 20 * WAY);
    before = oscillator;
    const [low, high] = [Math.min(...finite), Math.max(...finite)];
    live.textContent = say("melody-heard", { name, low: few(low), high: few(high), unit });
  });
}
