// @ts-check
/**
 * A body that goes on in the page while there is no connection, by the physics of live files: from where it was last, with the
 * velocities of its last two frames. The server's body waits meanwhile, and is shown again afterwards.
 *
 * @typedef {import("./picture.js").Picture} Picture
 * @typedef {import("./bench.js").Bench} Bench
 * @typedef {import("../../export/live/static/hands.js").Hands} Hands
 * @typedef {import("../../export/live/static/settings.js").Setting} Setting
 */
import { onMessage } from "../../wire/channel.js";

const NOTHING_HELD = { factor: 1, angle: 0 };

export class Alone {
  /** The data of the body; null where its method needs the server. @type {any} */
  #data = null;
  /** The values of the sliders as the data have them. @type {Map<string, number | string>} */
  #first = new Map();
  /** What moves it; null before that is loaded. @type {typeof import("./physics.js").physics | null} */
  #physics = null;
  /** @type {import("../../export/live/static/clock.js").Clock | null} */
  #clock = null;
  #before = 0;
  playing = true;

  /** @param {Picture} picture @param {Bench} bench @param {() => Hands} hands */
  constructor(picture, bench, hands) {
    this.picture = picture;
    this.bench = bench;
    this.hands = hands;
    onMessage("alone", ({ body, method, dt }) => {
      this.#data = body ? { body: JSON.parse(body), method, dt } : null;
      this.#first.clear();
      if (body && !this.#physics) import("./physics.js").then(({ physics }) => (this.#physics = physics), () => {});
    });
    onMessage("bench", ({ dials }) => {
      for (const { key, value } of dials) if (!this.#first.has(key)) this.#first.set(key, value);
    });
  }

  /** Whether a body moves here now. */
  get isOn() {
    return this.#clock !== null;
  }

  /** Goes on, if that is possible here. @param {boolean} isOwn whether the body is this page's */
  begin(isOwn) {
    const clock = this.#clock || !isOwn ? null : this.#start();
    if (!clock) return;
    const { body } = clock;
    const [one, two] = this.picture.latest.slice(-2);
    if (two && two.positions.length === body.positions.length && two.time > one.time) {
      const h = two.time - one.time;
      body.positions.set(two.positions);
      for (let i = 0; i < body.velocities.length; i++) if (!body.held[i >> 1]) body.velocities[i] = (two.positions[i] - one.positions[i]) / h;
      body.time = two.time;
    }
    this.#clock = clock;
    for (const dial of this.bench.dials) if (dial.value !== this.#first.get(dial.key)) this.change(dial, dial.value);
    this.#before = performance.now();
    requestAnimationFrame((now) => this.#next(now));
  }

  /** The clock of a body at its start; null where there can be none. */
  #start() {
    if (!this.#data || !this.#physics) return null;
    const { Body, Clock } = this.#physics;
    return new Clock(new Body(this.#data.body), this.#data.method, this.#data.dt);
  }

  /** Shows the server's body again. */
  end() {
    this.#clock = null;
    this.picture.release();
  }

  /** From the beginning. */
  reset() {
    if (!this.#clock) return;
    this.#clock = this.#start();
    this.hands().letGo();
    this.playing = true;
  }

  /** Sets a number of the body; true if one moves here. @param {import("../../wire/wire.js").Dial} dial @param {number | string} value */
  change(dial, value) {
    const clock = this.#clock;
    if (!clock || !this.#physics) return false;
    const first = this.#first.get(dial.key);
    const setting = /** @type {Setting} */ ({ ...dial, value: first === undefined ? dial.value : first });
    if (dial.key === "dt") clock.dt = Number(value);
    else if (dial.sets.length) this.#physics.write(clock.body, setting, value);
    clock.changed();
    return true;
  }

  /** @param {number} now ms */
  #next(now) {
    const clock = this.#clock, { plan } = this.picture;
    if (!clock || !plan || !this.#physics) return;
    const { body } = clock, { measure } = this.#physics;
    if (this.playing && !clock.exploded) clock.go((now - this.#before) / 1e3, this.hands().all, NOTHING_HELD);
    this.#before = now;
    plan.restAngle = Float32Array.from(body.restAngle);
    this.picture.show({
      ...{ generation: plan.generation, time: body.time, lengthScale: body.scale, angleShift: body.shift },
      ...{ positions: Float32Array.from(body.positions), ghost: null },
    });
    this.bench.take(body.time, this.bench.names.map((name) => measure(body, name)));
    requestAnimationFrame((later) => this.#next(later));
  }
}
