// A page without a browser: elements through which events go as in one, a clock that is set on by hand, a canvas with a
// body on it, and the server's end of the wire. Import it before the scripts of the page.
import { mock } from "node:test";
import { drawBody } from "../../app/stage/canvas.js";
import { receive } from "../../app/wire/channel.js";

// ------------------------------------------------------------------------- time
let now = 1e4;
let frames = [];
mock.timers.enable({ apis: ["setTimeout", "setInterval"] });
mock.method(performance, "now", () => now);

/** Lets time go by, ms, and then draws a frame. */
export function pass(ms = 20) {
  now += ms;
  mock.timers.tick(ms);
  for (const draw of frames.splice(0)) draw(now);
}

// ------------------------------------------------------------------------- events
class Event {
  constructor(type, init) {
    Object.assign(this, { type, timeStamp: now, defaultPrevented: false, isOver: false, isStopped: false }, init);
  }
  preventDefault() {
    this.defaultPrevented = true;
  }
  stopPropagation() {
    this.isStopped = true;
  }
  stopImmediatePropagation() {
    this.isStopped = this.isOver = true;
  }
}
class PointerEvent extends Event {}
class KeyboardEvent extends Event {}
class CustomEvent extends Event {}
class MessageEvent extends Event {}

export class Target {
  listeners = [];
  addEventListener(type, call, options) {
    this.listeners.push({ type, call, capture: (options?.capture ?? options) === true });
  }
  removeEventListener(type, call) {
    this.listeners = this.listeners.filter((one) => one.type !== type || one.call !== call);
  }
  dispatchEvent(event) {
    event.target = this;
    const path = [];
    for (let at = this; at; at = at.parentElement ?? above.get(at)) path.push(at);
    const run = (targets, capture) => {
      for (const target of targets) {
        if (event.isStopped) return;
        for (const one of target.listeners.filter((one) => one.type === event.type && one.capture === capture)) {
          if (!event.isOver) one.call.call(target, event);
        }
      }
    };
    run(path.toReversed(), true);
    run(event.bubbles ? path : [this], false);
    return !event.defaultPrevented;
  }
}

// ------------------------------------------------------------------------- elements
const TOKEN = /([\w-]+)|\.([\w-]+)|\[([\w-]+)(?:(\^?)="?([^"\]]*)"?)?\]|:not\(([^)]+)\)|:([\w-]+)/g;

/** Whether an element is one of a compound of a selector, such as `input[type=text]:focus-visible`. */
function isOne(element, compound) {
  return [...compound.matchAll(TOKEN)].every(([, tag, name, attribute, begins, value, not, state]) => {
    if (tag) return element.localName === tag;
    if (name) return element.classList.contains(name);
    if (not) return !isOne(element, not);
    if (state === "focus-within") return element.contains(document.activeElement);
    if (state) return state !== "hover" && document.activeElement === element && (state === "focus" || byKeys);
    const has = element.getAttribute(attribute);
    return value === undefined ? has !== null : begins ? (has ?? "").startsWith(value) : has === value;
  });
}

class Element extends Target {
  attributes = new Map();
  children = [];
  parentElement = null;
  text = "";
  box = { left: 0, top: 0, right: 0, bottom: 0, width: 0, height: 0 };
  style = { setProperty() {} };
  dataset = Object.defineProperty({}, "softrodKey", { get: () => this.getAttribute("data-softrod-key") });
  classList = {
    contains: (name) => this.className.split(" ").includes(name),
    toggle: (name, on = !this.classList.contains(name)) =>
      (this.className = [...this.className.split(" ").filter((one) => one && one !== name), ...(on ? [name] : [])].join(" ")),
    add: (...names) => names.forEach((name) => this.classList.toggle(name, true)),
    remove: (name) => this.classList.toggle(name, false),
  };
  constructor(localName = "") {
    super();
    this.localName = localName;
    this.tagName = localName.toUpperCase();
  }
  getAttribute = (name) => this.attributes.get(name) ?? null;
  hasAttribute = (name) => this.attributes.has(name);
  setAttribute = (name, value) => void this.attributes.set(name, String(value));
  removeAttribute = (name) => this.attributes.delete(name);
  toggleAttribute = (name, on) => (on ? this.setAttribute(name, "") : this.removeAttribute(name));
  append = (...children) => children.forEach((child) => this.insertBefore(child));
  replaceChildren(...children) {
    for (const child of [...this.children]) child.remove();
    this.append(...children);
  }
  prepend(child) {
    this.append(child);
    this.children.unshift(this.children.pop());
  }
  before = (child) => this.parentElement.append(child);
  insertBefore(child) {
    child.remove();
    child.parentElement = this;
    this.children.push(child);
  }
  remove() {
    this.parentElement?.children.splice(this.parentElement.children.indexOf(this), 1);
    this.parentElement = null;
  }
  contains = (other) => other === this || this.children.some((child) => child.contains(other));
  get isConnected() {
    return document.documentElement.contains(this);
  }
  get firstElementChild() {
    return this.children[0] ?? null;
  }
  get lastElementChild() {
    return this.children.at(-1) ?? null;
  }
  get textContent() {
    return this.text + this.children.map((child) => child.textContent).join("");
  }
  set textContent(text) {
    this.children = [];
    this.text = text;
  }
  set innerHTML(text) {
    this.textContent = "";
    let at = this;
    for (const [, end, tag, attributes, closed, words] of text.matchAll(/<(\/?)(\w+)([^>]*?)(\/?)>|([^<]+)/g)) {
      if (words?.trim()) at.text += words;
      else if (end) at = at.parentElement;
      else if (tag) {
        const child = document.createElement(tag);
        for (const [, name, value = ""] of attributes.matchAll(/([\w-]+)(?:="([^"]*)")?/g)) child.setAttribute(name, value);
        at.append(child);
        if (!closed) at = child;
      }
    }
  }
  closest(selector) {
    for (let at = this; at; at = at.parentElement) if (at.matches(selector)) return at;
    return null;
  }
  /** Of selectors there are compounds, one in another, and lists of them. */
  matches(selector) {
    return selector.split(/,\s*/).some((one) => {
      const [compound, around] = one.split(/\s+/).toReversed();
      return isOne(this, compound) && (!around || Boolean(this.parentElement?.closest(around)));
    });
  }
  querySelectorAll(selector) {
    return this.children.flatMap((child) => [...(child.matches(selector) ? [child] : []), ...child.querySelectorAll(selector)]);
  }
  querySelector = (selector) => this.querySelectorAll(selector)[0] ?? null;
  getBoundingClientRect = () => this.box;
  focus() {
    if (document.activeElement === this) return;
    const before = document.activeElement;
    document.activeElement = this;
    before.dispatchEvent(new Event("blur"));
    before.dispatchEvent(new Event("focusout", { bubbles: true, relatedTarget: this }));
    this.dispatchEvent(new Event("focus"));
    this.dispatchEvent(new Event("focusin", { bubbles: true, relatedTarget: before }));
  }
  blur() {
    if (document.activeElement === this) document.body.focus();
  }
  setPointerCapture = (id) => void captured.set(id, this);
  hasPointerCapture = (id) => captured.get(id) === this;
  releasePointerCapture(id) {
    if (captured.delete(id)) this.dispatchEvent(new PointerEvent("lostpointercapture", { pointerId: id, bubbles: true }));
  }
}
const reflect = (name, get, set) => Object.defineProperty(Element.prototype, name, { get, set });
for (const [name, attribute] of [["className", "class"], ["type", "type"], ["ariaLabel", "aria-label"], ["ariaExpanded", "aria-expanded"], ["ariaPressed", "aria-pressed"]]) {
  reflect(name, function () { return this.getAttribute(attribute) ?? ""; }, function (value) { this.setAttribute(attribute, value); });
}
reflect("hidden", function () { return this.hasAttribute("hidden"); }, function (on) { this.toggleAttribute("hidden", on); });
class HTMLElement extends Element {}
class HTMLInputElement extends HTMLElement {}
class SVGElement extends Element {}

// ------------------------------------------------------------------------- the page
/** What gets the events of a pointer, wherever it is. */
const captured = new Map();
/** Whether the last thing that was pressed was a key. */
let byKeys = false;
const window = Object.assign(new Target(), { innerWidth: 800, innerHeight: 600 });
const document = Object.assign(new Target(), {
  createElement: (tag) => new (tag === "input" ? HTMLInputElement : HTMLElement)(tag),
  createElementNS: (_, tag) => new SVGElement(tag),
  documentElement: new HTMLElement("html"),
  body: new HTMLElement("body"),
  querySelector: (selector) => document.documentElement.querySelector(selector),
  querySelectorAll: (selector) => document.documentElement.querySelectorAll(selector),
});
document.documentElement.append(document.body);
document.activeElement = document.body;
/** What events go through above all elements. */
const above = new Map([[document.documentElement, document], [document, window]]);
const storage = () => {
  const kept = new Map();
  return { getItem: (name) => kept.get(name) ?? null, setItem: (name, text) => void kept.set(name, text), removeItem: (name) => kept.delete(name) };
};
const globals = {
  window, document, Event, PointerEvent, KeyboardEvent, MessageEvent, CustomEvent, Element, HTMLElement, HTMLInputElement, SVGElement,
  Node: Element, DOMRect: class { left = 0; right = 0; }, localStorage: storage(), sessionStorage: storage(), location: { search: "" },
  innerWidth: window.innerWidth, innerHeight: window.innerHeight,
  requestAnimationFrame: (draw) => frames.push(draw),
  matchMedia: () => ({ matches: false }),
  getComputedStyle: () => ({ fontSize: "14px" }),
  getSelection: () => ({ isCollapsed: true }),
};
for (const [name, value] of Object.entries(globals)) Object.defineProperty(globalThis, name, { value, writable: true, configurable: true });

/** Adds an element to the page: `put("input", { type: "text", class: "a" })`. */
export function put(tag, attributes = {}, parent = document.body) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  parent.append(element);
  return element;
}

/** Presses a key, or releases it, where the focus is: `key("R")`, `key("z", { ctrlKey: true })`; returns the event. */
export function key(name, init = {}, type = "keydown") {
  const code = name === " " ? "Space" : /^[a-z]$/i.test(name) ? `Key${name.toUpperCase()}` : name;
  byKeys = true;
  const event = new KeyboardEvent(type, { key: name, code, bubbles: true, ...init });
  document.activeElement.dispatchEvent(event);
  return event;
}

/** Moves, presses or releases a pointer: `point("down", { x: 10, y: 20 }, { pointerType: "pen" })`; returns the event. */
export function point(what, at, { on = canvas, pointerType = "mouse", pointerId = 1, button = 0, ...more } = {}) {
  const init = { pointerType, pointerId, button, buttons: what === "up" ? 0 : 1, clientX: at.x, clientY: at.y, bubbles: true, ...more };
  byKeys = false;
  const event = new PointerEvent(`pointer${what}`, init);
  const target = captured.get(pointerId) ?? on;
  target.dispatchEvent(event);
  if (what === "up") target.releasePointerCapture(pointerId);
  return event;
}

// ------------------------------------------------------------------------- the body
export const canvas = put("canvas");
canvas.box = { left: 0, top: 0, right: 800, bottom: 600, width: 800, height: 600 };
/** For a camera that shows a unit of the world as 100 pixels, and its middle in the middle of the canvas. */
const vector = {
  clone: () => ({ ...vector }),
  set: (x, y) => ({ applyMatrix4: () => ({ project: () => ({ x: x / 4, y: y / 3 }) }) }),
};
const viser = {
  canvas, camera: { position: vector, updateMatrixWorld() {} }, cameraControl: null, scene: null,
  nodeRefFromName: { "": { matrixWorld: {} } }, messageQueue: [], requestRender() {},
  sendMessage: ({ text }) => said.push(JSON.parse(text)),
};
Object.assign(window, { __viserMutable: viser });
drawBody(viser);

/** What the page has said to the server. */
const said = [];
/** What it has said since this was asked last. */
export const heard = () => said.splice(0);
/** Has the server tell the page something. */
export const tell = (kind, message = {}, numbers = undefined) =>
  receive({ type: "SoftrodMessage", text: JSON.stringify({ tell: kind, ...message }), numbers });
/** Has the server tell how things are: a page with everything, and what is different now. */
let state = { page: "a", scene: 1, controls: ["play", "edit", "tools", "view"], width: 8, height: 6, speed: 1, rest: true, playing: true };
export const become = (changes = {}) => tell("pageState", (state = { ...state, ...changes }));

let generation = 0;
/** Shows a body whose px are pixels: [x, y] of its masses, pairs of masses as springs, and its joints as plan.js has them. */
export function show(places, springs = [], joints = []) {
  generation += 1;
  const all = (value, count = places.length) => Array(count).fill(value);
  const plan = [
    [generation, 0.01, 400, 300, -1, 0, 1, 8, -1], all(0.05), springs.flat(), all(30, springs.length), all(0.02, springs.length), [1],
    joints.flat(), all(0, joints.length),
  ];
  tell("plan", {}, numbers(plan));
  showAt(places);
}
const numbers = (sections) => new Float32Array(sections.flatMap((section) => [section.length, ...section]));

/** Shows the same body somewhere else. */
export function showAt(places) {
  tell("frame", { wall: now / 1e3 }, numbers([[generation, now / 1e3, 1, 0], places.flat(), []]));
  pass();
}
become();
