// @ts-check
/**
 * Draws the body: takes softrod's messages out of viser's queue, and puts in updates of nodes made from plan, frames and
 * damage.
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
import { isStill } from "../ui/access.js";
import { Glide } from "./glide.js";

/** Beginning of the names of the body's nodes. */
const BODY = "/body/";
/** Beginning of the names of a second body's nodes. */
const SECOND = "/second/";

const state = {
  /** @type {Plan | null} */
  plan: null,
  damage: UNHARMED,
  /** The frame that is shown. @type {Frame | null} */
  frame: null,
  /** The frame that viser's nodes have. @type {Frame | null} */
  rendered: null,
  /** Its plan: the plan of a new body arrives before its first frame. @type {Plan | null} */
  pictured: null,
  /** Time at which it was shown, ms of the screen's clock. */
  since: 0,
  /** The plan of a second body. @type {Plan | null} */
  secondPlan: null,
  /** Number of pictures drawn. */
  drawn: 0,
};
const glide = new Glide();
/** viser's page, once it is there. @type {Viser | null} */
let page = null;
/** Owners of nodes, which updates have to name. @type {Map<string, string | undefined>} */
const nodeOwners = new Map();
/** Present colours of nodes. @type {Map<string, Uint8Array>} */
const colors = new Map();
/** @type {((frame: Frame, plan: Plan) => void)[]} */
const listeners = [];
let asked = false;
/** True while the picture is frozen. */
let held = false;

/** The present picture. */
export const shown = () => state;

/** The second body of a frame, with its plan; null without one. @param {Frame} frame */
export function secondIn({ second }) {
  const { secondPlan: plan } = state;
  return second && plan?.radius.length === second.positions.length / 2 ? { plan, frame: second } : null;
}

/** @type {((frame: Frame) => void)[]} */
const frameListeners = [];

/** Calls back with every frame that arrives; not all are shown. @param {(frame: Frame) => void} listener */
export const onFrame = (listener) => frameListeners.push(listener);

/** Calls back with every frame that is shown. @param {(frame: Frame, plan: Plan) => void} listener */
export const onPicture = (listener) => listeners.push(listener);

/** @type {(() => void)[]} */
const renderListeners = [];

/**
 * Calls back when viser draws, so that what is over and behind the body is seen with it. Its nodes then still have the frame
 * before, `shown().rendered`: viser applies updates right after that, for its next redraw.
 *
 * @param {() => void} listener
 */
export const onRender = (listener) => renderListeners.push(listener);

function renders() {
  callAll(renderListeners);
  state.rendered = state.frame;
}

/** Follows viser's redraws, whichever scene it has; without one there is nothing to be in step with. */
function followRenders() {
  const scene = page?.scene;
  if (scene) scene.onBeforeRender = renders;
  else {
    state.rendered = state.frame;
    renders();
  }
}

const seconds = () => performance.now() / 1e3;

/** Passes a message on to viser. @param {Message} message */
const pass = (message) => page && Array.prototype.push.call(page.messageQueue, message);

/** Requests a redraw. A hidden page has no animation frames, and is drawn when it is shown again. */
function ask() {
  if (!asked) requestAnimationFrame(paint);
  asked = true;
}

/** Freezes the picture while frames arrive, or releases it. @param {boolean} on */
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
    followRenders();
  }
  if (glide.busy) ask();
}

/**
 * Draws one body.
 *
 * @param {string} at beginning of its nodes' names
 * @param {Plan} plan @param {Frame} frame @param {import("./plan.js").Damage} [damage]
 */
function show(at, plan, frame, damage = UNHARMED) {
  const still = isStill();
  const body = { plan, frame, world: toWorld(plan, frame.positions), damage, still };
  for (const [name, { draw, has }] of Object.entries(NODES)) {
    if (nodeOwners.has(at + name) && (has?.(body) ?? true)) fill(at + name, draw(body));
  }
}

/** Fills a node with instances; colours only if they have changed. @param {string} node @param {Instances} instances */
function fill(node, instances) {
  const { batched_colors: wanted, ...updates } = instances;
  const before = colors.get(node);
  if (wanted && !(before && before.length === wanted.length && wanted.every((value, i) => value === before[i]))) {
    colors.set(node, wanted);
    Object.assign(updates, { batched_colors: wanted });
  }
  pass({ type: "SceneNodeUpdateMessage", name: node, owner: nodeOwners.get(node), updates });
}

/** Begins to receive the messages of the body. */
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
    glide.last = null; // has the picture redrawn
    ask();
  });
  onMessage("frame", ({ numbers, wall }) => {
    const frame = readFrame(numbers);
    glide.take(frame, wall, seconds());
    callAll(frameListeners, frame);
    ask();
  });
}

/** Follows which nodes of the bodies exist. @param {Message} message */
function note({ type, name = "", owner, props }) {
  if (type === "RemoveSceneNodeMessage") nodeOwners.delete(name);
  if (!props || !(name.startsWith(BODY) || name.startsWith(SECOND))) return;
  nodeOwners.set(name, owner);
  colors.delete(name);
  glide.last = null; // has a new node filled
  ask();
}

/**
 * Begins to intercept viser's messages.
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
