// @ts-check
/** Where a class's card stands: beside the body, and on a narrow screen in the panel, above its sliders. */

const NARROW = matchMedia("(max-width: 799px)");
/** Milliseconds between two checks whether viser has remade that place. */
const LOOK_EVERY = 100;
/** Of the place in the panel, see `role.py`. */
const PLACE = "softrod-class-place";

/** Keeps a card there. @param {HTMLElement} card */
export function keepInPlace(card) {
  const look = () => {
    const place = (NARROW.matches && document.getElementById(PLACE)) || document.body;
    if (card.parentElement !== place) place.append(card);
  };
  look();
  setInterval(look, LOOK_EVERY);
}
