// @ts-check
/** Where the pointer is in the scene, told to the server at every animation frame while it matters. */
import { send, told } from "./channel.js";
import { viser } from "./viser.js";

/** Where the pointer was last over the canvas, in pixels of the window. @type {{x: number, y: number} | null} */
let pointer = null;
let pressed = false;
let asked = false;

/**
 * Where a place on the screen meets the plane z = 0, in the coordinates of the scene's nodes.
 *
 * @param {{x: number, y: number}} place in pixels of the window
 */
export function worldAt(place) {
  const { canvas, camera, nodeRefFromName } = viser() ?? {};
  const root = nodeRefFromName?.[""];
  if (!canvas || !camera || !root) return null;
  const box = canvas.getBoundingClientRect();
  const x = ((place.x - box.left) / box.width) * 2 - 1;
  const y = 1 - ((place.y - box.top) / box.height) * 2;
  const inverse = root.matrixWorld.clone().invert();
  const near = camera.position.clone().set(x, y, -1).unproject(camera).applyMatrix4(inverse);
  const far = camera.position.clone().set(x, y, 1).unproject(camera).applyMatrix4(inverse);
  return near.lerp(far, near.z / (near.z - far.z));
}

function report() {
  asked = false;
  const place = pointer && worldAt(pointer);
  if (place && Number.isFinite(place.x) && Number.isFinite(place.y)) {
    send("at", `${place.x.toFixed(6)},${place.y.toFixed(6)}`);
  }
}

/** Begins to listen. */
export function followPointer() {
  window.addEventListener(
    "pointermove",
    (event) => {
      if (event.target !== viser()?.canvas && !pressed) return; // off the canvas it stays where it is
      pointer = { x: event.clientX, y: event.clientY };
      if ((pressed || told().follow === "1") && !asked) {
        asked = true;
        requestAnimationFrame(report);
      }
    },
    true,
  );
  window.addEventListener(
    "pointerdown",
    (event) => {
      if (event.target !== viser()?.canvas) return;
      pressed = true;
      // The keys are the body's again.
      if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
      pointer = { x: event.clientX, y: event.clientY };
    },
    true,
  );
  for (const kind of ["pointerup", "pointercancel"]) {
    window.addEventListener(kind, () => (pressed = false), true);
  }
}
