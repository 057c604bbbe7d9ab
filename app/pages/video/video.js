// @ts-check
/* The page that makes a table of a video: its frames, what is marked in them, and what that becomes. */
import { download } from "../../ui/download.js";
import { HALF, cutOut, find, greyOf } from "./follow.js";
import { rateOf } from "./rate.js";
import { tableOf } from "./table.js";
import { say } from "../../words/words.js";

/** @typedef {import("./table.js").Place} Place */
/** @typedef {import("./table.js").Point} Point */

/** Of Okabe and Ito, which the colour-blind can tell apart. */
const COLOURS = ["#d55e00", "#0072b2", "#009e73"];
/** Frames of the longest video. */
const MAX_FRAMES = 20000;
/** Milliseconds in which a browser reports the time of a frame, unless it shows the same one as before. */
const PATIENCE = 500;
/** The speed at which a video is played to find its rate, and for how many frames. */
const NORMAL = /** @type {const} */ ([0.5, 24]);
/** The same for a video of more frames a second than `FEW`. */
const SLOW = /** @type {const} */ ([0.1, 16]);
const FEW = 45;
/** Milliseconds in which the next frame has to come while a video plays. */
const LISTENED = 2000;

/** @template {HTMLElement} T @param {string} id @returns {T} */
const byId = (id) => /** @type {T} */ (document.getElementById(id));
/** @type {HTMLCanvasElement} */
const canvas = byId("frame");
const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d", { willReadFrequently: true }));
/** The frame without marks. */
const plain = document.createElement("canvas");
const plainPen = /** @type {CanvasRenderingContext2D} */ (plain.getContext("2d", { willReadFrequently: true }));
const video = document.createElement("video");
Object.assign(video, { muted: true, playsInline: true, preload: "auto" });
/** @type {HTMLInputElement} */
const slider = byId("slider");
/** @type {HTMLInputElement} */
const rate = byId("rate");

/** @type {Point[]} */
const points = COLOURS.map((_, i) => ({ name: `mass${i + 1}`, places: new Map() }));
/** Times of the frames that were seen, s. @type {Map<number, number>} */
const times = new Map();
/** @type {Place[]} */
let ruler = [];
/** @type {Place} */
let origin = { x: 0, y: 0 };
/** What a click marks: a point by its number, or "ruler" or "origin". @type {string} */
let tool = "0";
let frame = 0;
let following = false;
/** Time of the frame that is shown, as reported by the browser, s; null where it reports none. @type {number | null} */
let shownAt = null;
/** Seeking goes on one after the other. */
let queue = Promise.resolve();

/** @param {string} text */
const tell = (text) => void (byId("said").textContent = text);
const framesASecond = () => Math.max(1, Math.min(1000, Number(rate.value) || 30));
const frames = () => Math.max(1, Math.min(MAX_FRAMES, Math.round(video.duration * framesASecond())));

/** @param {string} event */
const heard = (event) => new Promise((done) => video.addEventListener(event, done, { once: true }));

/** @param {File | undefined} file */
async function open(file) {
  if (!file) return;
  URL.revokeObjectURL(video.src);
  const come = Promise.race([heard("loadeddata").then(() => true), heard("error").then(() => false)]);
  video.src = URL.createObjectURL(file);
  if (!(await come) || !video.videoWidth) return tell(say("video-unknown", { name: file.name }));
  if (!Number.isFinite(video.duration)) {
    // What a browser records has no length in its header; only its end shows it.
    const end = heard("seeked");
    video.currentTime = 1e9;
    await end;
  }
  [canvas.width, canvas.height] = [plain.width, plain.height] = [video.videoWidth, video.videoHeight];
  canvas.style.width = `min(100%, calc(54vh * ${video.videoWidth / video.videoHeight}))`;
  forget();
  ruler = [];
  origin = { x: 0, y: 0 };
  shownAt = null;
  byId("drop").hidden = byId("about").hidden = true;
  tell(say("video-playing"));
  const found = await playedRate();
  rate.value = String(found ?? 30);
  byId("work").hidden = false;
  slider.max = String(frames() - 1);
  await show(0);
  tell(found === null ? say("video-found.not") : say("video-found", { rate: String(found) }));
}

/** The frame rate, determined from some frames that are played; null where that is not possible. */
async function playedRate() {
  const rate = rateOf(await playedTimes(...NORMAL));
  // Of many frames a second a screen shows only some, and a slow device too few.
  return rate === null || rate > FEW ? rateOf(await playedTimes(...SLOW)) ?? rate : rate;
}

/**
 * Times of the first frames, as the browser reports them while it plays, s.
 * @param {number} speed
 * @param {number} count of frames, at most
 */
async function playedTimes(speed, count) {
  /** @type {number[]} */
  const times = [];
  if (!("requestVideoFrameCallback" in video)) return times;
  if (video.currentTime > 0) {
    const begun = heard("seeked");
    video.currentTime = 0;
    await begun;
  }
  let asked = 0;
  /** @type {Promise<void>} */
  const enough = new Promise((done) => {
    let last = setTimeout(done, LISTENED);
    /** @param {number} _ @param {{ mediaTime: number }} shown */
    const take = (_, { mediaTime }) => {
      clearTimeout(last);
      times.push(mediaTime);
      if (times.length === count) return done();
      last = setTimeout(done, LISTENED);
      asked = video.requestVideoFrameCallback(take);
    };
    asked = video.requestVideoFrameCallback(take);
  });
  video.playbackRate = speed;
  try {
    await video.play();
    await Promise.race([enough, heard("ended")]);
  } catch {
    // It must not be played.
  }
  video.pause();
  video.cancelVideoFrameCallback(asked);
  return times;
}

/** Shows a frame, after those that were asked for before. @param {number} wanted */
function show(wanted) {
  queue = queue.then(() => seek(Math.max(0, Math.min(frames() - 1, wanted))));
  return queue;
}

/** @param {number} wanted */
async function seek(wanted) {
  const seeked = heard("seeked");
  /** @type {Promise<number | null>} */
  const reported = new Promise((done) => {
    if (!("requestVideoFrameCallback" in video)) return done(null);
    return video.requestVideoFrameCallback((_, { mediaTime }) => done(mediaTime));
  });
  // The middle of a frame, so that rounding leads to no other.
  video.currentTime = Math.min((wanted + 0.5) / framesASecond(), video.duration);
  await seeked;
  const time = await Promise.race([reported, new Promise((done) => setTimeout(done, PATIENCE, null))]);
  frame = wanted;
  shownAt = time ?? shownAt;
  times.set(frame, shownAt ?? wanted / framesASecond());
  plainPen.drawImage(video, 0, 0);
  draw();
}

function draw() {
  pen.drawImage(plain, 0, 0);
  const size = canvas.width / Math.max(1, canvas.clientWidth);
  pen.lineWidth = 2 * size;
  points.forEach(({ places }, i) => {
    pen.strokeStyle = pen.fillStyle = COLOURS[i];
    for (const [at, { x, y }] of places) if (at !== frame) pen.fillRect(x - size, y - size, 2 * size, 2 * size);
    const here = places.get(frame);
    if (here) cross(here, 9 * size);
  });
  pen.strokeStyle = "#d6336c";
  if (ruler.length === 2) {
    pen.beginPath();
    pen.moveTo(ruler[0].x, ruler[0].y);
    pen.lineTo(ruler[1].x, ruler[1].y);
    pen.stroke();
  }
  for (const place of [...ruler, ...(origin.x || origin.y ? [origin] : [])]) cross(place, 6 * size);
  slider.value = String(frame);
  byId("where").textContent = say("video-where", {
    frame: String(frame + 1),
    count: String(frames()),
    time: (times.get(frame) ?? 0).toFixed(3),
  });
}

/** @param {Place} place @param {number} size */
function cross({ x, y }, size) {
  pen.beginPath();
  pen.moveTo(x - size, y);
  pen.lineTo(x + size, y);
  pen.moveTo(x, y - size);
  pen.lineTo(x, y + size);
  pen.stroke();
}

/** @param {Place} place */
function mark(place) {
  if (tool === "ruler") {
    ruler = ruler.length === 1 ? [ruler[0], place] : [place];
    tell(say(ruler.length === 1 ? "video-ruler.other" : "video-ruler.length"));
  } else if (tool === "origin") origin = place;
  else points[Number(tool)].places.set(frame, place);
  draw();
}

/** Follows the points that are marked in this frame through the next ones, until one is lost or it is stopped. */
async function follow() {
  const grey = () => greyOf(plainPen.getImageData(0, 0, plain.width, plain.height).data, plain.width, plain.height);
  const first = grey();
  const marked = points.filter(({ places }) => places.has(frame));
  if (!marked.length) return tell(say("video-mark-first"));
  const followed = [];
  for (const { name, places } of marked) {
    const place = /** @type {Place} */ (places.get(frame));
    const template = cutOut(first, place.x, place.y);
    if (!template) {
      return tell(say("video-plain", { name, count: HALF }));
    }
    followed.push({ name, places, template, place, step: { x: 0, y: 0 } });
  }
  following = true;
  byId("follow").textContent = say("video-follow.stop");
  let lost = "";
  while (following && !lost && frame < frames() - 1) {
    await show(frame + 1);
    const now = grey();
    for (const each of followed) {
      const { place, step } = each;
      // It goes on as it went.
      const found = find(now, each.template, place.x + step.x, place.y + step.y);
      if (found) {
        each.step = { x: found.x - place.x, y: found.y - place.y };
        each.place = { x: found.x, y: found.y };
        each.places.set(frame, each.place);
      } else lost ||= each.name;
    }
    draw();
  }
  following = false;
  byId("follow").textContent = say("video-follow");
  tell(lost ? say("video-lost", { name: lost, frame: String(frame + 1) }) : say("video-followed"));
}

function forget() {
  for (const { places } of points) places.clear();
  times.clear();
}

function save() {
  if (points.every(({ places }) => !places.size)) return tell(say("video-none"));
  const length = Number(/** @type {HTMLInputElement} */ (byId("length")).value);
  const [a, b] = ruler;
  const drawn = b ? Math.hypot(b.x - a.x, b.y - a.y) : 0;
  if (b && !(length > 0 && Number.isFinite(length) && drawn > 0)) return tell(say("video-no-length"));
  const unit = /** @type {HTMLInputElement} */ (byId("unit")).value.replace(/[^\p{L}\p{N}]/gu, "") || "px";
  const down = /** @type {HTMLSelectElement} */ (byId("direction")).value === "down";
  const scale = { origin, pixels: b ? drawn / length : 1, unit: b ? unit : "px", down };
  download(new Blob([tableOf(points, times, scale)], { type: "text/csv" }), "video.csv");
  tell(say(b ? "video-saved" : "video-saved.pixels"));
}

/** The buttons that choose what a click marks. */
function makeTools() {
  /** @param {string} what @param {string} label @param {string} [colour] */
  const add = (what, label, colour) => {
    const button = document.createElement("button");
    button.textContent = label;
    button.dataset.tool = what;
    if (colour) button.style.borderColor = colour;
    button.onclick = () => choose(what);
    const together = document.createElement("span");
    together.append(button);
    byId("tools").append(together);
    return together;
  };
  points.forEach((point, i) => {
    const together = add(String(i), say("video-point", { number: i + 1 }), COLOURS[i]);
    const name = document.createElement("input");
    Object.assign(name, { className: "name", value: point.name, maxLength: 20 });
    name.setAttribute("aria-label", say("video-point.name", { number: i + 1 }));
    name.onchange = () => (point.name = name.value = name.value.replace(/[^\p{L}\p{N}]/gu, "") || `mass${i + 1}`);
    together.append(name);
  });
  add("ruler", say("video-ruler"));
  add("origin", say("video-origin"));
  choose(tool);
}

/** @param {string} name */
function choose(name) {
  tool = name;
  for (const button of byId("tools").querySelectorAll("button")) {
    button.setAttribute("aria-pressed", String(button.dataset.tool === name));
  }
}

makeTools();
byId("file").addEventListener("change", ({ target }) => open(/** @type {HTMLInputElement} */ (target).files?.[0]));
addEventListener("dragover", (event) => event.preventDefault());
addEventListener("drop", (event) => {
  event.preventDefault();
  void open(event.dataTransfer?.files[0]);
});
canvas.addEventListener("click", ({ offsetX, offsetY }) => {
  if (following) return;
  mark({ x: (offsetX * canvas.width) / canvas.clientWidth, y: (offsetY * canvas.height) / canvas.clientHeight });
});
addEventListener("keydown", ({ key, target }) => {
  if (target instanceof HTMLInputElement || target instanceof HTMLSelectElement || following) return;
  if (key === "," || key === "ArrowLeft") void show(frame - 1);
  if (key === "." || key === "ArrowRight") void show(frame + 1);
});
byId("back").onclick = () => void (following || show(frame - 1));
byId("on").onclick = () => void (following || show(frame + 1));
slider.oninput = () => void (following || show(Number(slider.value)));
rate.onchange = () => {
  forget();
  slider.max = String(frames() - 1);
  void show(0);
};
byId("follow").onclick = () => void (following ? (following = false) : follow());
byId("clear").onclick = () => {
  if (following) return;
  for (const { places } of points) places.clear();
  draw();
};
byId("save").onclick = save;
