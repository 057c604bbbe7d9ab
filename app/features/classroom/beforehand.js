// @ts-check
/** What a teacher looks at before the class, one after the other: the lesson, the network, a check, the wall. */
import { send } from "../../wire/channel.js";
import { make, untranslated } from "../../ui/dialog.js";
import { say } from "../../words/words.js";
import { box, qrCode, sayWith, typedAddress } from "./elements.js";

/** @param {import("../../wire/wire.js").Desk} desk @returns {HTMLElement[]} */
export function beforehand(desk) {
  if (!desk.check_qr) return [];
  const parts = [...lesson(desk), ...network(desk), check(desk), wayIn(desk)];
  return parts.map(([title, ...content], i) => box("section", "softrod-beforehand", make("h2", "", `${i + 1}. ${title}`), ...content));
}

/** @typedef {[title: string, ...content: HTMLElement[]]} Part */

/**
 * A list to choose from.
 *
 * @param {string} name @param {string} focus @param {{value: string, text: string}[]} options @param {string} chosen
 * @param {(value: string) => void} choose
 */
function list(name, focus, options, chosen, choose) {
  const select = make("select", "");
  select.setAttribute("aria-label", name);
  select.dataset.focus = focus;
  for (const { value, text } of options) select.add(new Option(text, value, false, value === chosen));
  select.addEventListener("change", () => choose(select.value));
  return select;
}

/** @param {import("../../wire/wire.js").Desk} desk @returns {Part[]} */
function lesson({ lessons, lesson, stops }) {
  if (!lessons.length) return [];
  const known = lessons.map(({ name, title }) => ({ value: name, text: title }));
  const options = known.some(({ value }) => value === lesson) ? known : [{ value: lesson, text: stops[0].title }, ...known];
  const choice = list(say("desk-lesson"), "lesson", options, lesson, (name) => name && send({ do: "chooseLesson", name }));
  return [[say("desk-which-lesson"), choice, make("p", "softrod-quiet", say("desk-lesson-steps", { count: stops.length }))]];
}

/** @param {import("../../wire/wire.js").Desk} desk @returns {Part[]} */
function network({ networks, address }) {
  if (!networks.length) return [];
  const options = networks.map((one) => ({ value: one, text: typedAddress(one) }));
  const choice = list(say("desk-address"), "network", options, address, (one) => send({ do: "chooseNetwork", address: one }));
  return [[say("desk-which-network"), choice, make("p", "softrod-quiet", say("desk-networks"))]];
}

/** @param {import("../../wire/wire.js").Desk} desk @returns {Part} */
function check({ check, check_qr, tried, seats }) {
  const link = Object.assign(untranslated(make("a", "", typedAddress(check))), { href: check, target: "_blank" });
  link.dataset.focus = "check";
  const found = box("ul", "", ...tried.map((one) => make("li", one.works ? "" : "softrod-warning", words(one))));
  found.setAttribute("role", "status");
  return [
    say("desk-lets-in"),
    box("div", "softrod-scan", qrCode(check_qr, check), box("p", "", ...sayWith("desk-scan", { address: link }))),
    found,
    ...(tried.length || seats.length ? [] : [make("p", "softrod-quiet", say("desk-finds-nothing"))]),
  ];
}

/** @param {import("../../wire/wire.js").Desk} desk @returns {Part} */
function wayIn({ address, code, qr }) {
  const wall = Object.assign(make("a", "softrod-small", say("desk-open-wall")), { href: `?room=${code}&as=wall`, target: "_blank" });
  wall.dataset.focus = "openWall";
  return [say("desk-projector"), box("p", "", wall), qrCode(qr, `${address}?room=${code}`, "softrod-way-in"), make("p", "softrod-quiet", say("desk-way-in"))];
}

/** @param {import("../../wire/wire.js").DeskTried} tried */
function words({ trip, rate, works, doubts }) {
  if (!works) return say("desk-tried-in-vain");
  return say(doubts ? "desk-tried-doubts" : "desk-tried", { ms: String(trip), rate });
}
