// @ts-check
/**
 * Draws the body: takes the plan and the frames out of viser's queue, and puts in what they mean for its nodes.
 *
 * @typedef {import("./viser.js").Message} Message
 * @typedef {import("./viser.js").Viser} Viser
 * @typedef {import("./plan.js").Plan} Plan
 * @typedef {import("./plan.js").Frame} Frame
 * @typedef {import("./draw.js").Instances} Instances
 */
import * as draw from "./draw.js";
import { Glide } from "./glide.js";
import { keep } from "./keep.js";
import { readFrame, readPlan } from "./plan.js";

const PLAN = "/softrod/plan";
const FRAME = "/softrod/frame";
const KEEPSAKE = "/softrod/keepsake";
const BODY = "/body/";

const state = {
  /** @type {Plan | null} */
  plan: null,
  /** The picture that is shown. @type {Frame | null} */
  frame: null,
  /** When it was shown, ms of the screen's clock. */
  since: 0,
  /** Pictures drawn so far. */
  drawn: 0,
};
const glide = new Glide();
/** Who owns each node of the body; updates must name the owner. @type {Map<string, string | undefined>} */
const owners = new Map();
/** Colours that a node has. @type {Map<string, Uint8Array>} */
const colors = new Map();
/** @type {((frame: Frame, plan: Plan) => void)[]} */
const listeners = [];
let asked = false;

/** What is shown now. */
export const shown = () => state;

/** Calls back with every picture. @param {(frame: Frame, plan: Plan) => void} listener */
export const onPicture = (listener) => listeners.push(listener);

/**
 * Stands in the way of viser's messages.
 *
 * @param {Viser} viser
 * @param {((content: unknown) => void)[]} heard get the content of elements of HTML, or undefined
 */
export function drawBody(viser, heard) {
  const queue = viser.messageQueue;
  const seconds = () => performance.now() / 1e3;
  /** @param {Message} message */
  const pass = (message) => Array.prototype.push.call(queue, message);

  /** @param {string} name @param {Float32Array} data */
  const take = (name, data) => {
    if (name === PLAN) {
      state.plan = readPlan(data);
      colors.clear();
    } else {
      glide.take(readFrame(data), seconds());
    }
    ask();
  };
  const ask = () => {
    if (asked) return;
    asked = true;
    // A hidden page has no animation frames; it is drawn when it is looked at again.
    requestAnimationFrame(paint);
  };

  /** @param {string} name @param {Instances} instances */
  const put = (name, instances) => {
    const node = BODY + name;
    if (!owners.has(node)) return;
    const { batched_colors: wanted, ...updates } = instances;
    const before = colors.get(node);
    if (wanted && !(before && before.length === wanted.length && wanted.every((value, i) => value === before[i]))) {
      colors.set(node, wanted);
      Object.assign(updates, { batched_colors: wanted });
    }
    pass({ type: "SceneNodeUpdateMessage", name: node, owner: owners.get(node), updates });
  };
  /** @param {Plan} plan @param {Frame} frame */
  const show = (plan, frame) => {
    const world = draw.toWorld(plan, frame.positions);
    put("springs", draw.springs(plan, frame, world));
    put("wedges", draw.wedges(plan, frame, world));
    if (plan.pinned.length) put("pins", draw.pins(plan, world));
    if (plan.driven >= 0) put("ring", draw.ring(plan, world));
    put("masses", draw.masses(plan, world));
    if (frame.ghost) put("ghost", draw.ghost(plan, draw.toWorld(plan, frame.ghost)));
  };
  const paint = () => {
    asked = false;
    const { plan } = state;
    const frame = glide.at(seconds());
    if (frame && plan && frame.generation === plan.generation) {
      state.frame = frame;
      state.since = performance.now();
      show(plan, frame);
      state.drawn += 1;
      viser.requestRender();
      for (const listener of listeners) listener(frame, plan);
    }
    if (glide.busy) ask();
  };

  queue.push = (...messages) => {
    for (const message of messages) {
      const { name = "" } = message;
      const data = message.props?.points ?? message.updates?.points;
      if (name === PLAN || name === FRAME) {
        if (data) take(name, /** @type {Float32Array} */ (data));
        continue;
      }
      for (const listener of heard) listener(message.props?.content ?? message.updates?.content);
      if (name === KEEPSAKE) {
        if (message.updates?.colors) keep(/** @type {Uint8Array} */ (message.updates.colors));
        continue;
      }
      if (name.startsWith(BODY) && message.props) {
        owners.set(name, message.owner);
        colors.delete(name);
        glide.last = null; // a new node has to be filled in
        ask();
      }
      if (message.type === "RemoveSceneNodeMessage") owners.delete(name);
      pass(message);
    }
    return queue.length;
  };
}
