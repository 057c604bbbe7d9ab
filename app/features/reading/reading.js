// @ts-check
/** The card beside a mass that was clicked, with a line to it; it stands on paper that is free. Escape closes it. */
import { onMessage, send } from "../../wire/channel.js";
import { freePlace } from "../../stage/label.js";
import { insertMarksLayer, onMarksRedraw, redrawMarks } from "../../stage/sight.js";
import { makeSvg, set } from "../../stage/svg.js";
import { takenPaper, takePaper } from "../../stage/taken.js";
import { make, overCanvas } from "../../ui/dialog.js";
import { isFree, isTaken, swallow } from "../../ui/hands/keys.js";
import { viserCanvas } from "../../ui/viser/viser.js";
import { editing } from "../edit/editing.js";
import { CLICK, massAt } from "../../ui/hands/pointer.js";

/** Directions from the mass in which the card may stand, degrees, the best first. */
const AROUND = [180, 0, 150, 30, -150, -30, 120, 60, -120, -60, 90, -90];
/** Pixels from the mass to the card's nearest edge: near, and where a body is in the way. */
const AWAY = [14, 30, 70, 130];
/** Where the card may stand at the edges of the canvas, as parts of its height. */
const HEIGHTS = [0, 0.2, 0.4, 0.6, 0.8, 1];
/** Pixels around the card that stay free. */
const MARGIN = 6;

function begin() {
  const card = make("div", "softrod-mass-card softrod-floats");
  card.hidden = true;
  const title = make("b", "");
  const list = make("dl", "");
  card.append(title, list);
  overCanvas().append(card);
  const svg = makeSvg("svg", "softrod-marks softrod-mass-mark");
  const [line, ring] = [makeSvg("path", "", svg), makeSvg("circle", "", svg)];
  let mass = -1;
  let joint = -1;
  let place = 0;
  let size = { width: 0, height: 0 };

  const close = () => send({ do: "closeCard" });

  /** @param {import("../../stage/sight.js").Sight} seen */
  const draw = ({ plan, on, places, box, floor }) => {
    const has = mass >= 0 && mass < plan.radius.length && !editing.on;
    card.hidden = !has;
    document.documentElement.toggleAttribute("data-softrod-mass-card", has && joint >= 0);
    if (!has) {
      svg.remove();
      takePaper("reading", null);
      return;
    }
    if (!svg.parentNode) insertMarksLayer(svg);
    if (!size.width) size = card.getBoundingClientRect();
    const [x, y] = [places[2 * mass], places[2 * mass + 1]];
    const radius = plan.radius[mass] * on.step + 6;
    const half = { x: size.width / 2 + MARGIN, y: size.height / 2 + MARGIN };
    const beside = AWAY.flatMap((away) =>
      AROUND.map((turn) => {
        const [cos, sin] = [Math.cos((turn * Math.PI) / 180), Math.sin((turn * Math.PI) / 180)];
        return { x: x + cos * (radius + away + size.width / 2), y: y - sin * (radius + away + size.height / 2) };
      }),
    );
    // Where the body is all around, at the edges of the canvas.
    const edges = [box.left + half.x, box.right - half.x].flatMap((edge) =>
      HEIGHTS.map((part) => ({ x: edge, y: box.top + half.y + part * (floor - box.top - 2 * half.y) })),
    );
    /** @param {{x: number, y: number}} spot */
    const far = (spot) => Math.hypot(spot.x - x, spot.y - y);
    edges.sort((one, other) => far(one) - far(other));
    const spots = [...beside, ...edges];
    const inside = spots.map(
      (spot) => spot.x - half.x >= box.left && spot.x + half.x <= box.right && spot.y - half.y >= box.top && spot.y + half.y <= floor,
    );
    const order = [place, ...spots.keys()].filter((i) => inside[i]);
    const radii = plan.radius.map((one) => one * on.step);
    if (order.length) place = order[freePlace(order.map((i) => spots[i]), plan.springs, places, radii, takenPaper("reading"), half)];
    const { x: middle, y: height } = spots[place];
    const [left, top] = [middle - size.width / 2, height - size.height / 2];
    card.style.translate = `${left.toFixed(1)}px ${top.toFixed(1)}px`;
    takePaper("reading", { left, right: left + size.width, top, bottom: top + size.height });
    // From the ring to the nearest point of the card.
    const to = { x: Math.min(Math.max(x, left), left + size.width), y: Math.min(Math.max(y, top), top + size.height) };
    const way = far(to) || 1;
    set(ring, { cx: x, cy: y, r: radius });
    set(line, { d: `M${x + ((to.x - x) * radius) / way} ${y + ((to.y - y) * radius) / way}L${to.x} ${to.y}` });
  };

  onMarksRedraw(draw);
  onMessage("massCard", (told) => {
    const { rows } = told;
    const isNew = told.mass !== mass || rows.length !== list.children.length / 2;
    mass = told.mass;
    joint = told.joint;
    title.textContent = told.title;
    if (isNew) {
      place = 0;
      size = { width: 0, height: 0 };
      list.replaceChildren(...rows.flatMap(() => [make("dt", ""), make("dd", "")]));
    }
    rows.forEach((row, i) => row.forEach((text, j) => (list.children[2 * i + j].textContent = text)));
    if (isNew) redrawMarks();
  });

  window.addEventListener(
    "keydown",
    (event) => {
      if (event.key !== "Escape" || card.hidden || !isFree(event) || isTaken(event)) return;
      swallow(event);
      close();
    },
    true,
  );
  // A click beside the body closes it, too; a drag of the view does not.
  /** @type {PointerEvent | null} */
  let pressed = null;
  window.addEventListener("pointerdown", (event) => (pressed = event), true);
  window.addEventListener(
    "pointerup",
    (event) => {
      if (card.hidden || !pressed || event.target !== viserCanvas() || event.pointerId !== pressed.pointerId) return;
      const at = { x: event.clientX, y: event.clientY };
      if (Math.hypot(at.x - pressed.clientX, at.y - pressed.clientY) > CLICK) return;
      if (massAt(at, event.pointerType) < 0) close();
    },
    true,
  );
}

/** @type {import("../../ui/feature.js").Feature<"reading">} */
export default { commands: {}, begin };
