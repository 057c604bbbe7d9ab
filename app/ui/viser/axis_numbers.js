// @ts-check
/**
 * Numbers on the axes of plots. The plotting library writes them with three decimals, so that marks a thousandth apart
 * look alike. It makes its formatter when viser's page is loaded, with nothing but a language.
 */

/** Digits that tell the marks of the narrowest axis apart, see app/session/plots.py. */
const DIGITS = 7;

/** Has formatters with nothing but a language write so many digits; returns what ends that. */
export function tellApart() {
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
