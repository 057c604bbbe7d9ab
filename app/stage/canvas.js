// @ts-check
/**
 * Draws the body: puts into viser's queue what the plan, the frames and the damage mean for its nodes, and takes out
 * what is softrod's.
 *
 * @typedef {import("../ui/viser/viser.js").Message} Message
 * @typedef {import("../ui/viser/viser.js").Viser} Viser
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {import("./plan.js").Frame} Frame
 * @typedef {import("./draw.js").Instances} Instances
 */
import { NODES, toWorld } from "./draw.js";
import { readDamage, readFrame, readPlan, UNHARMED } from "./plan.js";
import { callAll, onMessage, receive, sendBy } from "../wire/channel.js";
import { viser as current } from "../ui/viser/viser.js";
import { Glide } from "./glide.js";

/** Where the nodes of the body are, and those of a second one. */
const [BODY, SECOND] = ["/body/", "/second/"];

const state = {
  /** @type {Plan | null} */
  plan: null,
  /** What has yielded and broken. */
  damage: UNHARMED,
  /** The picture that is shown. @type {Frame | null} */
  frame: null,
  /** What it is a picture of: a new body's plan comes before its first picture. @type {Plan | null} */
  pictured: null,
  /** When it was shown, ms of the screen's clock. */
  since: 0,
  /** What a second body is made of. @type {Plan | null} */
  secondPlan: null,
  /** Pictures drawn so far. */
  drawn: 0,
};
const glide = new Glide();
/** viser's page, once it is there. @type {Viser | null} */
let page = null;
/** Who owns each node of the body; updates must name the owner. @type {Map<string, string | undefined>} */
const owners = new Map();
/** Colours that a node has. @type {Map<string, Uint8Array>} */
const colors = new Map();
/** @type {((frame: Frame, plan: Plan) => void)[]} */
const listeners = [];
let asked = false;
/** Whether the picture that is shown stays. */
let held = false;

/** What is shown now. */
export const shown = () => state;

/** A second body in a picture, and what it is made of; null without one. @param {Frame} frame */
export function secondIn({ second }) {
  const { secondPlan: plan } = state;
  return second && plan?.radius.length === second.positions.length / 2 ? { plan, frame: second } : null;
}

/** @type {((frame: Frame) => void)[]} */
const takers = [];

/** Calls back with every frame as it comes, which may be more than are shown. @param {(frame: Frame) => void} taker */
export const onFrame = (taker) => takers.push(taker);

/** Calls back with every picture. @param {(frame: Frame, plan: Plan) => void} listener */
export const onPicture = (listener) => listeners.push(listener);

const seconds = () => performance.now() / 1e3;

/** Hands a message on to viser. @param {Message} message */
const pass = (message) => page && Array.prototype.push.call(page.messageQueue, message);

/** Asks for a picture. A hidden page has no animation frames; it is drawn when it is looked at again. */
function ask() {
  if (!asked) requestAnimationFrame(paint);
  asked = true;
}

/** Has the picture that is shown stay, while frames come in, or lets it go on. @param {boolean} on */
export function hold(on) {
  held = on;
  ask();
}

function paint() {
  asked = false;
  if (held) return;
  const { plan } = state;
  const frame = glide.at(seconds());
  if (frame && plan && frame.generation === plan.generation) {
    state.frame = frame;
    state.pictured = plan;
    state.since = performance.now();
    const damage = state.damage.generation === plan.generation ? state.damage : UNHARMED;
    show(BODY, plan, frame, damage);
    const second = secondIn(frame);
    if (second) show(SECOND, second.plan, second.frame, damage.second);
    state.drawn += 1;
    page?.requestRender();
    callAll(listeners, frame, plan);
  }
  if (glide.busy) ask();
}

/**
 * Draws one body.
 *
 * @param {string} at where its nodes are
 * @param {Plan} plan @param {Frame} frame @param {import("./plan.js").Damage} [damage]
 */
function show(at, plan, frame, damage = UNHARMED) {
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const body = { plan, frame, world: toWorld(plan, frame.positions), damage, still };
  for (const [name, { draw, has }] of Object.entries(NODES)) {
    if (owners.has(at + name) && (has?.(body) ?? true)) fill(at + name, draw(body));
  }
}

/** Fills a node with its instances; colours only when they changed. @param {string} node @param {Instances} instances */
function fill(node, instances) {
  const { batched_colors: wanted, ...updates } = instances;
  const before = colors.get(node);
  if (wanted && !(before && before.length === wanted.length && wanted.every((value, i) => value === before[i]))) {
    colors.set(node, wanted);
    Object.assign(updates, { batched_colors: wanted });
  }
  pass({ type: "SceneNodeUpdateMessage", name: node, owner: owners.get(node), updates });
}

/** Begins to take what is told of the body. */
function listen() {
  onMessage("plan", ({ numbers }) => {
    state.plan = readPlan(numbers);
    colors.clear();
    ask();
  });
  onMessage("secondPlan", ({ numbers }) => {
    state.secondPlan = readPlan(numbers);
    colors.clear();
    glide.last = null;
    ask();
  });
  onMessage("damage", ({ numbers }) => {
    state.damage = readDamage(numbers);
    glide.last = null; // the picture that is shown is no longer right
    ask();
  });
  onMessage("frame", ({ numbers, wall }) => {
    const frame = readFrame(numbers);
    glide.take(frame, wall, seconds());
    callAll(takers, frame);
    ask();
  });
}

/** Notes which nodes of the body there are. @param {Message} message */
function note({ type, name = "", owner, props }) {
  if (type === "RemoveSceneNodeMessage") owners.delete(name);
  if (!props || !(name.startsWith(BODY) || name.startsWith(SECOND))) return;
  owners.set(name, owner);
  colors.delete(name);
  glide.last = null; // a new node has to be filled in
  ask();
}

/**
 * Stands in the way of viser's messages.
 *
 * @param {Viser} viser
 */
export function drawBody(viser) {
  page = viser;
  sendBy((message) => current()?.sendMessage(message));
  listen();
  const queue = viser.messageQueue;
  queue.push = (...messages) => {
    for (const message of messages) {
      if (receive(message)) continue;
      note(message);
      pass(message);
    }
    return queue.length;
  };
}
