// @ts-check
/**
 * Draws what is behind the body: the grid, a medium, the ground, walls, the reach of contact, fillings of loops, and wind.
 */
import { isStill } from "../ui/access.js";
import { moving, standing, streaks } from "./environment.js";
import { LAYERS } from "./looks.js";
import { onRender, secondIn, shown } from "./canvas.js";
import { onMessage, pageState } from "../wire/channel.js";
import { sight } from "./sight.js";
import { makeSvg, set } from "./svg.js";
import { onScreen } from "./screen.js";
import { timeNow } from "../ui/clock.js";
import { viser, viserCanvas } from "../ui/viser/viser.js";

/** Milliseconds between two pictures of the wind around a body at rest, which sends no frames. */
const DRIFT_EVERY = 40;
/** Pixels that streaks may drift before they are computed again. */
const MARGIN = 150;
const KINDS = /** @type {(keyof typeof LAYERS)[]} */ (Object.keys(LAYERS));

/** A key of all pictures of the same body from the same place. @param {import("./sight.js").Sight} seen */
const viewOf = ({ plan, on, box }) => [plan.generation, on.x, on.y, on.step, box.width, box.height].join(" ");

/** @typedef {typeof KINDS[number]} Kind */

/**
 * The streaks of the wind; gusts only drift, so the same streaks are moved for a while. Returns a function that draws them
 * at a time, s.
 *
 * @param {Element} path
 */
function windMark(path) {
  let [made, since] = ["", 0];
  /** @param {import("./sight.js").Sight} seen @param {number} time */
  return (seen, time) => {
    const { plan, on, box } = seen;
    const view = viewOf(seen);
    const [u, v] = plan.wind;
    const drift = plan.scale * on.step * (time - since);
    if (view !== made || !(Math.hypot(u, v) * Math.abs(drift) < MARGIN)) {
      const { left, right, top, bottom } = box;
      const more = { left: left - MARGIN, right: right + MARGIN, top: top - MARGIN, bottom: bottom + MARGIN };
      set(path, { d: streaks(plan, time, on, more) });
      path.removeAttribute("transform");
      [made, since] = [view, time];
    } else {
      set(path, { transform: `translate(${(u * drift).toFixed(2)} ${(-v * plan.flip * drift).toFixed(2)})` });
    }
  };
}

/** @type {((seen: import("./sight.js").Sight, svg: SVGSVGElement) => void)[]} */
const others = [];
/** Calls back whenever this is drawn, to draw at the same place. @param {(typeof others)[0]} draw */
export const onUnderlay = (draw) => others.push(draw);

/** The layers behind the body. */
class Underlay {
  constructor() {
    this.svg = makeSvg("svg", "softrod-underlay");
    this.paths = /** @type {Record<Kind, SVGPathElement>} */ (
      Object.fromEntries(KINDS.map((kind) => [kind, makeSvg("path", `softrod-${kind}`, this.svg)]))
    );
    this.drawWind = windMark(this.paths.wind);
    /** The view for which the layers that stand were drawn. */
    this.view = "";
  }

  /** @param {Partial<Record<Kind, string>>} outlines */
  show(outlines) {
    for (const kind of KINDS) if (kind in outlines) set(this.paths[kind], { d: outlines[kind] ?? "" });
  }

  draw() {
    const { plan, frame } = shown();
    const canvas = viserCanvas();
    const { width: across = 0, height: up = 0 } = pageState();
    // The first frame of a new body, and the page's state, may not have arrived yet.
    if (!canvas || !across || plan?.generation !== frame?.generation) return;
    const seen = sight();
    if (!seen) return;
    if (canvas.previousSibling !== this.svg) canvas.before(this.svg);
    const { left, top, width, height } = seen.box;
    set(this.svg, { viewBox: `${left} ${top} ${width} ${height}` });
    const view = [viewOf(seen), across, up].join(" ");
    if (view !== this.view) this.show(standing(seen, Math.max(across, up) / seen.plan.scale));
    this.view = view;
    for (const other of others) other(seen, this.svg);
    this.show(this.movingOutlines(seen));
    set(this.paths.skin, { "stroke-width": (seen.plan.contact * seen.plan.scale * seen.on.step).toFixed(2) });
    if (seen.plan.wind.length) this.drawWind(seen, isStill() ? 0 : timeNow());
    else this.show({ wind: "" });
  }

  /** Skin and fillings of the body, with the fillings of a second one. @param {import("./sight.js").Sight} seen */
  movingOutlines(seen) {
    const { damage } = shown();
    const outlines = moving(seen, damage.broken);
    const second = secondIn(seen.frame);
    if (second) {
      const places = onScreen(second.plan, second.frame.positions, seen.on);
      const theirs = moving({ plan: second.plan, places }, damage.second?.broken ?? new Set());
      outlines.gas += theirs.gas;
      outlines.liquid += theirs.liquid;
    }
    return outlines;
  }

  /** Draws wind that goes on around a body at rest. */
  drift() {
    if (pageState().rest && shown().plan?.wind.length && !isStill()) this.draw();
  }
}

/** Begins to draw. */
export function addUnderlay() {
  const underlay = new Underlay();
  onRender(() => underlay.draw());
  onMessage("pageState", () => viser()?.scene || underlay.draw());
  setInterval(() => underlay.drift(), DRIFT_EVERY);
}
