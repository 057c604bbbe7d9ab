// @ts-check
/** What a teacher looks at before the class: the way in, and whether a phone can take part from here. */
import { make } from "../../ui/dialog.js";

/** @param {import("../../wire/wire.js").Desk} desk @returns {HTMLElement[]} */
export function beforehand({ address, code, qr, check, check_qr, tried, seats }) {
  if (!check_qr) return [];
  const way = make("section", "softrod-way-in");
  const scanned = make("img", "");
  scanned.src = qr;
  scanned.alt = `QR code of ${address}?room=${code}`;
  way.append(make("h3", "", "The way in"), scanned, make("p", "softrod-quiet", "The wall shows it, too, large."));
  const box = make("section", "softrod-beforehand");
  const picture = make("img", "");
  picture.src = check_qr;
  picture.alt = `QR code of ${check}`;
  const text = make("p", "", "Before the class, with a phone that is in the pupils' network: ");
  const link = make("a", "", check.replace(/^http:\/\//, ""));
  link.href = check;
  link.target = "_blank";
  link.dataset.focus = "check";
  text.append(link);
  const list = make("ul", "");
  for (const one of tried) list.append(make("li", one.works ? "" : "softrod-warning", words(one)));
  list.setAttribute("role", "status");
  box.append(make("h3", "", "Does the network let them in?"), picture, text, list);
  if (!tried.length && !seats.length) {
    box.append(
      make("p", "softrod-quiet", "If a phone finds nothing at this address, the network keeps devices apart: use this computer's own hotspot."),
    );
  }
  return [way, box];
}

/** @param {import("../../wire/wire.js").DeskTried} tried */
function words({ trip, rate, works, doubts }) {
  if (!works) return "A device: it cannot take part; it says why.";
  return `A device: ${doubts ? "works, and says what to mind" : "all right"}, ${trip} ms, ${rate} pictures a second`;
}
