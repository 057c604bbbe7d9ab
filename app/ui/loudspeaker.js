// @ts-check
/** What is heard of the page: one output with its volume, clicks, and a list of what sounded, for tests. */
import { access, onAccess } from "./access.js";
import { kept, store } from "./kept/storage.js";

/**
 * @typedef {object} Sound
 * @property {"tone" | "click" | "silence"} kind
 * @property {number} at when, ms of the page's clock
 * @property {number} [pan] from -1 at the left to 1 at the right
 * @property {string} [name] of what is heard
 * @property {[number, number][]} [tones] pitch, Hz, and loudness of each component
 */

/** Milliseconds between two looks whether the device has interrupted the sound. */
const LOOK_EVERY = 1000;
const STORED = "softrod-volume";
/** Sounds that are remembered. */
const REMEMBERED = 10000;
/** Seconds in which the volume follows a change. */
const FOLLOWS = 0.02;

/** The output of the page; null before the first gesture. @type {{context: AudioContext, out: GainNode} | null} */
let heard = null;
let volume = Number(kept(STORED) || 0.5);
/** @type {Sound[]} */
const past = [];

/** What sounded, the oldest first. */
export const sounds = () => past;

/** Remembers what sounds. @param {Sound} sound */
export function note(sound) {
  past.push(sound);
  if (past.length > REMEMBERED) past.splice(0, past.length - REMEMBERED);
}

// Squared, as loudness is perceived.
const loudness = () => (access().sound ? volume * volume : 0);

/** The output of the page; the first call has to be in a gesture. */
export function loudspeaker() {
  if (!heard) {
    const context = new AudioContext();
    const [out, limit] = [context.createGain(), context.createDynamicsCompressor()];
    out.gain.value = loudness();
    out.connect(limit).connect(context.destination);
    heard = { context, out };
    setInterval(goOn, LOOK_EVERY);
    onAccess(follow);
  }
  goOn();
  return heard;
}

/** Has the sound go on where a call, an alarm or the lock of a phone has interrupted it. */
function goOn() {
  if (heard && heard.context.state !== "running") heard.context.resume().catch(() => undefined);
}

function follow() {
  heard?.out.gain.setTargetAtTime(loudness(), heard.context.currentTime, FOLLOWS);
}

/** The volume, from 0 to 1. */
export const volumeNow = () => volume;

/** Keeps another volume. @param {number} to */
export function setVolume(to) {
  volume = to;
  store(STORED, String(volume));
  follow();
}

/**
 * Plays a short noise.
 *
 * @param {BaseAudioContext} context @param {AudioNode} to
 * @param {number} seconds @param {number} loud 0..1 @param {number} pitch centre frequency, Hz
 * @param {number} [at] seconds of the context
 */
export function click(context, to, seconds, loud, pitch, at) {
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
  source.start(at);
}
