// @ts-check
/**
 * Numbers on the axes of plots. The plotting library formats them with three decimals, so that marks a thousandth apart
 * look alike. It makes its formatter when viser's page is loaded, with a language as the only argument.
 */

/** Digits that distinguish the marks of the narrowest axis, see app/session/plots.py. */
const DIGITS = 7;

/** Makes such formatters write so many digits, until the returned function is called. */
export function fixAxisLabels() {
  const original = Intl.NumberFormat;
  const ours = new Proxy(original, {
    construct: (target, [language, options]) =>
      new target(language, options ?? { maximumSignificantDigits: DIGITS }),
  });
  Intl.NumberFormat = ours;
  return () => {
    if (Intl.NumberFormat === ours) Intl.NumberFormat = original;
  };
}
