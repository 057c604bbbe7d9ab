// @ts-check
/** What browsers of the last six years may lack, and this page's modules use. */

/** Properties that some browsers have as attributes only. */
const REFLECTED = ["ariaLabel", "ariaPressed", "ariaExpanded", "ariaHidden"];

for (const name of REFLECTED) {
  if (name in Element.prototype) continue;
  const attribute = name.replace("aria", "aria-").toLowerCase();
  Object.defineProperty(Element.prototype, name, {
    configurable: true,
    get() {
      return this.getAttribute(attribute);
    },
    set(value) {
      if (value === null) this.removeAttribute(attribute);
      else this.setAttribute(attribute, value);
    },
  });
}
for (const kind of [Array, Float32Array, Float64Array]) {
  const has = /** @type {any} */ (kind.prototype);
  if (!has.at) Object.defineProperty(has, "at", { configurable: true, writable: true, value: at });
}
if (!Element.prototype.replaceChildren) {
  /** @this {Element} @param {(Node | string)[]} nodes */
  Element.prototype.replaceChildren = function (...nodes) {
    this.textContent = "";
    this.append(...nodes);
  };
}

/** @this {ArrayLike<any>} @param {number} index */
function at(index) {
  return this[index < 0 ? this.length + index : index];
}

export const ready = true;
