// @ts-check
/**
 * The script of a replay file: reads the motion that the file holds, and draws it into a canvas with what the page
 * draws by. It fetches nothing.
 *
 * @typedef {import("../../drawing/static/plan.js").Plan} Plan
 * @typedef {import("../../drawing/static/plan.js").Damage} Damage
 * @typedef {import("../../drawing/static/draw.js").Instances} Instances
 * @typedef {import("../../drawing/static/environment.js").Screen} Screen
 * @typedef {object} About what the file says of its motion
 * @property {number} frames how many
 * @property {number} interval seconds between two
 * @property {number} size of the scene's frame, px: the larger of its sides
 * @property {number[]} box left, right, low and high of what is shown, in the page's world
 * @property {string} springs the mesh that springs are drawn with
 * @property {Record<string, number[][]>} meshes outlines: x and y of each corner
 * @property {number[]} plans from which frame on there is each; its arrays are on white and on dark paper
 * @property {number[]} damages from which frame on there is each
 */
import { moving, standing, streaks } from "../../drawing/static/environment.js";
import { loadArrows } from "../../drawing/static/arrow_shapes.js";
import * as draw from "../../drawing/static/draw.js";
import { ARROW, LAYERS, MARGIN } from "../../drawing/static/looks.js";
import { between, readDamage, readFrame, readPlan, sections, UNHARMED } from "../../drawing/static/plan.js";

/** What is smaller than that, in the world, is not to be seen. */
const UNSEEN = 2e-6;
/** Seconds that an arrow key goes. */
const [NUDGE, LEAP] = [0.1, 1];
/** @template {Element} T @param {string} id @param {new () => T} kind @returns {T} */
function element(id, kind) {
  const found = document.getElementById(id);
  if (!(found instanceof kind)) throw new Error(`there is no ${id}`);
  return found;
}

/** The bytes of the file's data. @param {string} text base64 of what was packed */
async function unpack(text) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** @param {About} about @param {ArrayBuffer} data the arrays of plans, damages and frames, as pages get them */
function readMotion(about, data) {
  const take = sections(new Float32Array(data));
  const plans = about.plans.map((from) => ({ from, light: readPlan(take()), dark: readPlan(take()) }));
  const damages = about.damages.map((from) => ({ from, damage: readDamage(take()) }));
  const frames = Array.from({ length: about.frames }, () => readFrame(take()));
  /** @template {{from: number}} T @param {T[]} list @param {number} frame */
  const present = (list, frame) => list.filter(({ from }) => from <= frame).at(-1);
  return {
    /** What there is at a time, seconds from the beginning. @param {number} time @param {boolean} dark */
    at(time, dark) {
      const at = time / about.interval;
      const before = Math.min(Math.max(Math.floor(at + 1e-6), 0), frames.length - 1);
      const plan = present(plans, before)?.[dark ? "dark" : "light"];
      if (!plan) throw new Error("a frame has no plan");
      const [one, two] = frames.slice(before, before + 2);
      const frame = two ? between(one, two, Math.max(at - before, 0)) : one;
      return { plan, frame, damage: present(damages, before)?.damage ?? UNHARMED };
    },
  };
}

/**
 * Fills copies of a mesh; those that follow each other in one colour are one area, without seams.
 *
 * @param {CanvasRenderingContext2D} to
 * @param {number[][]} lines
 * @param {Instances} parts
 * @param {Screen} on
 */
function stamp(to, lines, parts, on) {
  const { batched_positions: p, batched_wxyzs: q, batched_scales: s, batched_colors: c } = parts;
  let last = "";
  for (let i = 0; i < s.length / 3; i++) {
    if (!c || !(s[3 * i] > UNSEEN)) continue;
    const color = `rgb(${c[3 * i]} ${c[3 * i + 1]} ${c[3 * i + 2]})`;
    if (color !== last) {
      if (last) to.fill();
      to.beginPath();
      to.fillStyle = last = color;
    }
    const [w, z] = [q[4 * i], q[4 * i + 3]];
    const [cosine, sine] = [w * w - z * z, 2 * w * z];
    for (const line of lines) {
      for (let k = 0; k < line.length; k += 2) {
        const [along, across] = [line[k] * s[3 * i], line[k + 1] * s[3 * i + 1]];
        const x = on.x + on.step * (p[3 * i] + along * cosine - across * sine);
        const y = on.y - on.step * (p[3 * i + 1] + along * sine + across * cosine);
        if (k) to.lineTo(x, y);
        else to.moveTo(x, y);
      }
      to.closePath();
    }
  }
  if (last) to.fill();
}

/** @param {About} about @param {ReturnType<typeof readMotion>} motion @param {HTMLCanvasElement} canvas */
function painter(about, motion, canvas) {
  const to = canvas.getContext("2d");
  if (!to) throw new Error("there is no canvas");
  const [left, right, low, high] = about.box;
  const night = matchMedia("(prefers-color-scheme: dark)");
  /** @param {number} time seconds from the beginning */
  return (time) => {
    const { width, height } = canvas.getBoundingClientRect();
    const fine = devicePixelRatio;
    const [across, down] = [Math.round(width * fine), Math.round(height * fine)];
    if (canvas.width !== across || canvas.height !== down) [canvas.width, canvas.height] = [across, down];
    const step = Math.min(width / (right - left), height / (high - low)) / MARGIN;
    const on = { x: width / 2 - (step * (left + right)) / 2, y: height / 2 + (step * (low + high)) / 2, step };
    const { plan, frame, damage } = motion.at(time, night.matches);
    const world = draw.toWorld(plan, frame.positions);
    const places = world.map((value, i) => (i % 2 ? on.y - step * value : on.x + step * value));
    const box = { left: 0, right: width, top: 0, bottom: height };
    const wind = plan.wind.length ? streaks(plan, frame.time, on, box) : "";
    /** @type {Record<string, string>} */
    const paths = { ...standing({ plan, on, box }, about.size), ...moving({ plan, places }, damage.broken), wind };
    const styles = getComputedStyle(document.documentElement);
    /** @param {string} name */
    const color = (name) => styles.getPropertyValue(`--softrod-${name}`);
    to.setTransform(fine, 0, 0, fine, 0, 0);
    to.clearRect(0, 0, width, height);
    for (const [name, { color: ink, opacity, width: wide, round }] of Object.entries(LAYERS)) {
      const path = new Path2D(paths[name]);
      Object.assign(to, { strokeStyle: color(ink), fillStyle: color(ink), globalAlpha: opacity });
      Object.assign(to, { lineWidth: wide ?? plan.contact * plan.scale * step, lineCap: round ? "round" : "butt" });
      if (wide === 0) to.fill(path);
      else to.stroke(path);
    }
    to.globalAlpha = 1;
    /** @param {string} mesh @param {Instances} parts */
    const put = (mesh, parts) => stamp(to, about.meshes[mesh], parts, on);
    put("pin", draw.pins(plan, world));
    put(about.springs, draw.springs(plan, frame, world, damage));
    put("bar", draw.yielded(plan, world, damage));
    put("slice", draw.wedges(plan, frame, world, damage));
    if (plan.driven >= 0) put("ring", draw.ring(plan, world));
    put("disc", draw.masses(plan, world));
    if (frame.ghost) put("bar", draw.ghost(plan, draw.toWorld(plan, frame.ghost), damage));
    if (plan.loads.length) {
      const arrows = new Path2D(loadArrows(plan, places, step));
      Object.assign(to, { strokeStyle: color("force"), fillStyle: color("force"), lineWidth: ARROW, lineJoin: "round" });
      to.stroke(arrows);
      to.fill(arrows);
    }
    return frame;
  };
}

/** @param {About} about @param {(time: number) => import("../../drawing/static/plan.js").Frame} paint */
function player(about, paint) {
  const play = element("play", HTMLButtonElement);
  const slider = element("time", HTMLInputElement);
  const speed = element("speed", HTMLSelectElement);
  const clock = element("clock", HTMLOutputElement);
  const canvas = element("canvas", HTMLCanvasElement);
  const seconds = (about.frames - 1) * about.interval;
  let [time, playing, asked, before] = [0, false, false, 0];
  slider.max = String(seconds);
  const show = () => {
    const frame = paint(time);
    slider.value = String(time);
    clock.value = `${frame.time.toFixed(2)} s`;
    slider.setAttribute("aria-valuetext", clock.value);
    play.dataset.icon = playing ? "pause" : time >= seconds ? "again" : "play";
    play.ariaLabel = { pause: "Pause", again: "Play again", play: "Play" }[play.dataset.icon] ?? "";
  };
  /** @param {number} now ms */
  const next = (now) => {
    asked = false;
    if (playing) time = Math.min(time + (Math.min(now - before, 100) / 1e3) * Number(speed.value), seconds);
    before = now;
    if (time >= seconds) playing = false;
    show();
    if (playing) ask();
  };
  const ask = () => {
    if (!asked) requestAnimationFrame(next);
    asked = true;
  };
  /** @param {boolean} on */
  const set = (on) => {
    playing = on;
    before = performance.now();
    if (on && time >= seconds) time = 0;
    ask();
  };
  /** @param {number} to */
  const go = (to) => {
    playing = false;
    time = Math.min(Math.max(to, 0), seconds);
    ask();
  };
  play.addEventListener("click", () => set(!playing));
  canvas.addEventListener("click", () => set(!playing));
  slider.addEventListener("input", () => go(Number(slider.value)));
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target === speed) return;
    const far = event.shiftKey ? LEAP : NUDGE;
    /** @type {Record<string, () => void>} */
    const keys = {
      " ": () => set(!playing),
      ArrowLeft: () => go(time - far),
      ArrowRight: () => go(time + far),
      Home: () => go(0),
      End: () => go(seconds),
    };
    if (!keys[event.key] || (event.key === " " && event.repeat)) return;
    event.preventDefault();
    keys[event.key]();
  });
  new ResizeObserver(ask).observe(canvas);
  for (const query of ["(prefers-color-scheme: dark)", `(resolution: ${devicePixelRatio}dppx)`]) {
    matchMedia(query).addEventListener("change", ask);
  }
  set(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  // For the browser tests.
  Object.assign(window, { __softrod: { playing: () => playing, shown: () => paint(time) } });
}

try {
  const [about, text] = ["about", "data"].map((id) => element(id, HTMLScriptElement).textContent ?? "");
  const told = /** @type {About} */ (JSON.parse(about));
  const motion = readMotion(told, await unpack(JSON.parse(text)));
  player(told, painter(told, motion, element("canvas", HTMLCanvasElement)));
} catch (error) {
  const said = document.querySelector("[role=alert]");
  if (said) said.textContent = "This browser cannot play the file; a newer one can.";
  throw error;
}
