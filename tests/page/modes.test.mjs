// The sound of modes, of what touches and of what breaks, and their shapes on the screen.
import assert from "node:assert/strict";
import { test } from "node:test";
import { become, heard, key, pass, point, put, tell } from "./page.mjs";
import modes from "../../app/features/modes/modes.js";
import { addSound } from "../../app/features/modes/sound.js";
import { HIGHEST, LOWEST, octavesOf, tonesOf } from "../../app/features/modes/tones.js";
import { percent, posed, readLevels, readShapes } from "../../app/features/modes/shapes.js";

/** Hz and damping ratios of a bridge. */
const FREQUENCIES = [2.32, 3.43, 5.03, 6.71, 9.61];
const DAMPINGS = [0.0031, 0.0004, 0.0092, 0.002, 0.012];

test("all are moved by the same whole number of octaves, so that the slowest can be heard", () => {
  for (const slowest of [0.35, 2.32, 109.9, 110, 3000]) {
    const octaves = octavesOf([slowest]);
    assert.equal(octaves, Math.round(octaves));
    const pitch = slowest * 2 ** octaves;
    assert.ok(pitch >= LOWEST * (1 - 1e-9) && pitch < 2 * LOWEST * (1 + 1e-9), `${slowest} becomes ${pitch}`);
  }
  assert.equal(octavesOf([]), 0);
});

test("what is too high, does not swing or is not there makes no sound", () => {
  const tones = tonesOf([1, 2, 60, 3], [0, 1.2, 0, 0], [1, 1, 1, Number.NaN]);
  assert.ok(tones[0].gain > 0);
  assert.deepEqual(tones.slice(1).map(({ gain }) => gain), [0, 0, 0]);
  assert.ok(60 * 2 ** octavesOf([1]) > HIGHEST);
  const loudest = tonesOf(FREQUENCIES, DAMPINGS, [9, 9, 9, 9, 9]).reduce((sum, { gain }) => sum + gain, 0);
  assert.ok(loudest < 2, `all together: ${loudest}`);
});

test("with the clock at half speed tones last twice as long", () => {
  const [one, two] = [1, 0.5].map((speed) => tonesOf(FREQUENCIES, DAMPINGS, FREQUENCIES, speed));
  assert.equal(two[2].decay, one[2].decay / 2);
  assert.equal(two[2].pitch, one[2].pitch);
});

test("shapes and levels are read as they are written, and a shape lies as its part does", () => {
  const joined = (...parts) => new Float32Array(parts.flatMap((one) => [one.length, ...one]));
  const shapes = readShapes(joined([7, 100], [0, 0, 10, 0], [0, 0], [0, 0, 0, 1], [0, 0.5], [1], [1, 0, 0, 0], [], [0]));
  assert.equal(shapes.number, 7);
  assert.equal(shapes.modes.length, 2);
  assert.deepEqual([...shapes.modes[0].nodes], [0, 0.5]);
  assert.deepEqual([...posed(shapes, 0, 3)], [0, 0, 10, 3]);
  // A quarter turn and a shift.
  assert.deepEqual([...posed(shapes, 0, 3, new Float32Array([0, 1, 5, 6]))], [5, 6, 2, 16]);
  assert.equal(readShapes(new Float32Array()), null);
  const levels = readLevels(joined([7, 1.5, -0.25, 0.5], [0.5, 0.25], [0.75, 0.125, -0.125], [1, 0, 0, 0]));
  assert.equal(levels.other, -0.25);
  assert.deepEqual([...levels.shares], [0.75, 0.125, -0.125]);
  assert.equal(percent(0.0004), "less than 0.1 %");
  assert.equal(percent(-0.1234), "12.3 %");
});

test("what touches and what breaks makes a noise while the sound is on and time goes on", () => {
  const noises = [];
  const gain = () => ({ value: 0, setTargetAtTime: (to) => (gain.last = to), cancelScheduledValues() {}, setValueAtTime() {} });
  const node = (more) => ({ connect: (to) => to, gain: gain(), frequency: gain(), start() {}, stop() {}, ...more });
  globalThis.AudioContext = class {
    currentTime = 0;
    sampleRate = 24000;
    state = "running";
    createGain = node;
    createDynamicsCompressor = node;
    createOscillator = node;
    createBiquadFilter = node;
    createBuffer = (_, length, rate) => ({ duration: length / rate, getChannelData: () => new Float32Array(length) });
    createBufferSource = () => node({ start() { noises.push(this.buffer.duration); } });
  };
  const made = () => pass(100) ?? noises.splice(0);
  const sound = addSound();
  const hear = (touching) => sound.hear({ levels: [1], touching });
  const falls = () => [0, 1].forEach(hear) ?? pass(100) ?? hear(1);
  become({ playing: true, broken: 0 });
  sound.toggle();
  assert.equal(sound.controls[0].ariaPressed, "false", "there is nothing to be heard yet");
  sound.use([2], [0.01]);
  assert.equal(sound.controls[0].ariaPressed, "true", "it was asked for");
  sound.toggle();
  falls();
  become({ broken: 1 });
  assert.deepEqual(made(), [], "it is off");
  sound.toggle();
  assert.equal(sound.controls[0].ariaPressed, "true");
  assert.deepEqual(made(), [], "what is broken already cracks no more");
  falls();
  assert.deepEqual(made(), [0.12], "a click as it begins to touch");
  [0, 1, 0, 1].forEach(hear);
  assert.deepEqual(made(), [0.12], "not two at once");
  become({ broken: 2 });
  assert.deepEqual(made(), [0.48]);
  gain.last = 1;
  become({ playing: false });
  assert.equal(gain.last, 0, "all tones fall silent while it is paused");
  falls();
  assert.deepEqual(made(), []);
  become({ playing: true });
  sound.use([], []);
  assert.equal(sound.controls[0].ariaPressed, "false", "and without modes");
  falls();
  become({ broken: 3 });
  assert.deepEqual(made(), []);
});

test("a bar is moved by keys and by a drag, is driven while it is pressed, and says what it is", () => {
  become({ unit: "px", playing: false });
  put("div", { class: "softrod-transport" });
  modes.begin();
  tell("modes", { on: true, number: 1, frequencies: [2, 3], damping: [0.1, 1], full: [10, 20], driven: -1 });
  const [first, second, others] = document.querySelectorAll(".softrod-mode");
  const says = document.querySelector(".softrod-modes-says");
  const done = () => heard().map(({ do: what, mode, part }) => [what, mode, part].filter((one) => one !== undefined));
  heard();
  key("Tab");
  first.focus();
  assert.match(says.textContent, /^Mode 1: 2 Hz, 0 px, damping 10 %/);
  key("ArrowUp");
  assert.deepEqual(done(), [["visit"], ["putMode", 0, 0.05]]);
  pass();
  key("ArrowRight");
  assert.equal(document.activeElement, second);
  assert.match(says.textContent, /^Mode 2: 3 Hz, 0 px, does not swing/);
  key("Enter");
  key("Enter", {}, "keyup");
  assert.deepEqual(done(), [["driveMode", 1], ["driveMode", -1]]);
  point("down", { x: 5, y: 100 }, { on: first });
  point("move", { x: 5, y: 98 });
  assert.deepEqual(done(), [], "so little is no drag");
  point("move", { x: 5, y: 60 });
  pass();
  point("up", { x: 5, y: 60 });
  assert.deepEqual(done(), [["visit"], ["putMode", 0, 1]]);
  point("down", { x: 5, y: 100 }, { on: second });
  pass(349);
  assert.deepEqual(done(), []);
  pass(1);
  pass();
  assert.deepEqual(done(), [["driveMode", 1]], "one that rests on it drives it");
  point("up", { x: 5, y: 100 });
  assert.deepEqual(done(), [["driveMode", -1]]);
  document.body.focus();
  point("down", { x: 5, y: 100 }, { on: first });
  point("up", { x: 5, y: 100 });
  assert.match(says.textContent, /^Mode 1/, "a tap keeps it in sight");
  tell("modes", { on: true, number: 2, trouble: "it has none" });
  assert.equal(says.textContent, "No modes: it has none.");
  assert.equal(others.getAttribute("role"), "img");
});
