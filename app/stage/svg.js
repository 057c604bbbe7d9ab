// @ts-check
/** SVG elements made by scripts. */

export const SVG = "http://www.w3.org/2000/svg";

/**
 * Makes an SVG element.
 *
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} kind @param {string} names of its classes @param {Element} [parent] to which it is added
 * @returns {SVGElementTagNameMap[K]}
 */
export function makeSvg(kind, names, parent) {
  const element = document.createElementNS(SVG, kind);
  element.setAttribute("class", names);
  if (kind === "svg") element.setAttribute("aria-hidden", "true");
  parent?.append(element);
  return element;
}

/** Sets what is not set already. @param {Element} element @param {Record<string, number | string>} attributes */
export function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (element.getAttribute(name) !== String(value)) element.setAttribute(name, String(value));
  }
}
