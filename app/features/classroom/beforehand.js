// @ts-check
/** What a teacher looks at before the class: the way in, and whether a phone can take part from here. */
import { make } from "../../ui/dialog.js";
import { box, qrCode, typedAddress } from "./elements.js";

/** @param {import("../../wire/wire.js").Desk} desk @returns {HTMLElement[]} */
export function beforehand({ address, code, qr, check, check_qr, tried, seats }) {
  if (!check_qr) return [];
  const link = Object.assign(make("a", "", typedAddress(check)), { href: check, target: "_blank" });
  link.dataset.focus = "check";
  const list = box("ul", "", ...tried.map((one) => make("li", one.works ? "" : "softrod-warning", words(one))));
  list.setAttribute("role", "status");
  const nothing = "If a phone finds nothing at this address, the network keeps devices apart: use this computer's own hotspot.";
  return [
    box("section", "softrod-way-in", make("h3", "", "The way in"), qrCode(qr, `${address}?room=${code}`), make("p", "softrod-quiet", "The wall shows it, too, large.")),
    box(
      "section",
      "softrod-beforehand",
      make("h3", "", "Does the network let them in?"),
      qrCode(check_qr, check),
      box("p", "", "Before the class, with a phone that is in the pupils' network: ", link),
      list,
      ...(tried.length || seats.length ? [] : [make("p", "softrod-quiet", nothing)]),
    ),
  ];
}

/** @param {import("../../wire/wire.js").DeskTried} tried */
function words({ trip, rate, works, doubts }) {
  if (!works) return "A device: it cannot take part; it says why.";
  return `A device: ${doubts ? "works, and says what to mind" : "all right"}, ${trip} ms, ${rate} pictures a second`;
}
