// @ts-check
/** The teacher's part of the page: where the class is, what comes next, who is there, and what was given. */
import { onTold, send } from "../../wire/channel.js";
import { make, makeButton } from "../looks/dialog.js";
import { Ghosts } from "./ghost.js";
import { SVG } from "../body/overlay.js";
import { beforehand } from "./beforehand.js";
import { plot, voted } from "./wall.js";

/** @typedef {import("../../wire/wire.js").Desk} Desk */
/** @typedef {import("../../wire/wire.js").DeskAnswer} DeskAnswer */
/** @typedef {import("../../wire/wire.js").Arrange} Arrange */

/** What each phase is called on its button. */
const PHASES = {
  lobby: "Come in",
  show: "Look at me",
  ask: "Ask",
  results: "Show answers",
  run: "Run it",
  explain: "Explain in a line",
  try: "Let them try",
  collect: "Collect",
};

/** Where the seats' bodies are. @type {import("../../wire/wire.js").Posters} */
let posters = { tell: "posters", places: {}, springs: [] };

/** Draws the body of the seat that a picture is of. @param {SVGSVGElement} svg */
function drawPoster(svg) {
  const places = posters.places[svg.dataset.seat ?? ""] ?? [];
  let path = "";
  for (const [a, b] of posters.springs) {
    if (places[a] && places[b]) path += `M${places[a].join(" ")}L${places[b].join(" ")}`;
  }
  svg.firstElementChild?.setAttribute("d", path);
}

/** A still picture of a seat's body. @param {number} seat */
function poster(seat) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", "0 0 1000 1000");
  svg.dataset.seat = String(seat);
  svg.setAttribute("aria-hidden", "true");
  svg.append(document.createElementNS(SVG, "path"));
  drawPoster(svg);
  return svg;
}

/** Makes the teacher's part. */
export function addDesk() {
  const desk = make("aside", "softrod-class softrod-desk");
  desk.ariaLabel = "Class";
  const ghosts = new Ghosts();
  let made = "";
  onTold("predictions", ({ bodies }) => ghosts.show(bodies));
  onTold("posters", (told) => {
    posters = told;
    for (const svg of desk.querySelectorAll("svg[data-seat]")) drawPoster(/** @type {SVGSVGElement} */ (svg));
  });
  onTold("desk", (told) => {
    if (!desk.parentNode) document.body.append(desk);
    const now = JSON.stringify(told);
    if (now === made) return;
    made = now;
    const focused = document.activeElement?.getAttribute("data-focus");
    const scrolled = desk.scrollTop;
    desk.replaceChildren(...parts(told));
    desk.scrollTop = scrolled;
    if (focused) /** @type {HTMLElement | null} */ (desk.querySelector(`[data-focus="${focused}"]`))?.focus();
  });
  onTold("classEnded", () => {
    ghosts.show([]);
    desk.replaceChildren(make("h2", "", "The class is over"), make("p", "", "Nothing that was given is kept on this computer."));
  });
}

/** @param {Desk} desk @returns {HTMLElement[]} */
function parts(desk) {
  return [head(desk), steps(desk), ...beforehand(desk), ...asked(desk), seats(desk), ...lines(desk), foot(desk)];
}

/** A button that keeps the focus when the part is made anew. @param {string} text @param {() => void} press @param {string} [name] */
function button(text, press, name = "softrod-small") {
  const made = makeButton(text, press, name);
  made.dataset.focus = text;
  return made;
}

/** @param {Arrange["what"]} what */
const arrange = (what) => send({ do: "arrange", what });

/** @param {Desk} desk */
function head({ code, address, saved }) {
  const box = make("header", "");
  box.append(make("b", "softrod-desk-code", code), make("span", "", `${address.replace(/^http:\/\/|\/$/g, "")}`));
  const wall = make("a", "softrod-small", "Wall");
  wall.href = `?room=${code}&as=wall`;
  wall.target = "_blank";
  wall.dataset.focus = "wall";
  box.append(wall, make("span", "softrod-quiet", saved ? "" : "saving…"));
  return box;
}

/** @param {Desk} desk */
function steps({ stops, asking, next }) {
  const box = make("section", "");
  const pick = make("select", "");
  pick.ariaLabel = "Step";
  pick.dataset.focus = "step";
  stops.forEach(({ title }, i) => {
    const option = make("option", "", `${i + 1}. ${title}`);
    option.value = String(i);
    option.selected = i === asking.stop;
    pick.append(option);
  });
  pick.addEventListener("change", () => send({ do: "stage", stop: Number(pick.value), phase: "show" }));
  const row = make("div", "softrod-phases");
  for (const [phase, round] of stops[asking.stop].phases) {
    const label = round > 0 ? `${PHASES[phase]} again` : PHASES[phase];
    const one = button(label, () => send({ do: "stage", stop: asking.stop, phase, round }));
    one.ariaPressed = String(phase === asking.phase && round === asking.round);
    row.append(one);
  }
  box.append(pick, row);
  if (next) {
    const [stop, phase, round] = next;
    const label = stop === asking.stop ? `${PHASES[phase]}${round > 0 ? " again" : ""}` : `Step ${stop + 1}`;
    const go = button(`Next: ${label}`, () => send({ do: "stage", stop, phase, round }), "softrod-strong");
    go.dataset.focus = "next";
    box.append(go);
  }
  return box;
}

/** @param {Desk} desk */
function asked({ asking, bars, right, answers, seats }) {
  if (!asking.question) return [];
  const box = make("section", "");
  box.append(make("p", "", asking.question), voted(asking.choices, bars, right));
  const votes = bars.reduce((sum, bar) => sum + bar, 0);
  if (votes > 0 && right >= 0) {
    const part = Math.round((100 * bars[right]) / votes);
    const advice = part < 35 ? "teach it once more" : part <= 70 ? "let them talk in pairs, then ask again" : "go on";
    box.append(make("p", "softrod-quiet", `${part} % right: ${advice}.`));
  }
  const ghosts = answers.filter(({ kind }) => kind === "ghost").length;
  if (asking.predict > 0) box.append(make("p", "softrod-quiet", `${ghosts} of ${seats.length} have dragged a prediction.`));
  return [box];
}

/** @param {Desk} desk */
function seats({ seats, asking }) {
  const own = asking.phase === "try" || asking.phase === "collect";
  const box = make("section", "");
  const here = seats.filter((seat) => seat.here).length;
  box.append(make("h3", "", `${here} of ${seats.length} are here`));
  const grid = make("ul", "softrod-seats");
  for (const { number, name, color, here, two, hand, answered, doing } of seats) {
    const item = make("li", "");
    item.style.setProperty("--softrod-seat", color);
    item.toggleAttribute("data-away", !here);
    item.toggleAttribute("data-answered", answered);
    if (own) item.append(poster(number));
    const state = here ? doing && own && ` – ${doing}` : " – away";
    item.append(make("span", "", `${name}${two ? " (two)" : ""}${hand ? " ✋" : ""}${state || ""}`));
    const away = button("×", () => confirm(`Close the seat of ${name}? What it gave goes, too.`) && send({ do: "sendAway", seat: number }), "softrod-cross");
    away.ariaLabel = `Close the seat of ${name}`;
    away.dataset.focus = `away${number}`;
    item.append(away);
    grid.append(item);
  }
  box.append(grid);
  return box;
}

/** @param {Desk} desk */
function lines({ answers, seats, on_wall }) {
  const written = answers.filter(({ kind }) => kind !== "vote");
  if (!written.length) return [];
  const box = make("section", "");
  box.append(make("h3", "", "Given"));
  const found = answers.flatMap(({ setting, found, doubt }) => (setting === null || found === null || doubt ? [] : [{ setting, found }]));
  if (found.length) box.append(plot(found, "", ""));
  const list = make("ul", "softrod-lines");
  for (const { id, seat, kind, text, late, starred, doubt } of written) {
    const item = make("li", "");
    const name = seats.find(({ number }) => number === seat)?.name ?? "";
    item.append(make("span", "", `${name}: ${kind === "ghost" ? "a prediction" : text || "a run"}${late ? " (late)" : ""}${doubt && `: ${doubt}`}`));
    if (kind === "line") {
      const star = button(starred ? "★" : "☆", () => send({ do: "star", answer: id, on: !starred }), "softrod-cross");
      star.ariaLabel = `Show this line on the wall, by ${name}`;
      star.ariaPressed = String(starred);
      star.dataset.focus = `star${id}`;
      item.append(star);
    } else if (kind === "ghost") {
      const alone = button(on_wall === id ? "All" : "Alone", () => send({ do: "toWall", answer: on_wall === id ? "" : id }));
      alone.ariaLabel = `Show the prediction of ${name} alone on the wall`;
      alone.dataset.focus = `wall${id}`;
      item.append(alone);
    }
    list.append(item);
  }
  box.append(list);
  return [box];
}

/** @param {Desk} desk */
function foot({ paused, open, own_names }) {
  const box = make("section", "softrod-phases");
  box.append(
    button(paused ? "Let all go on" : "Pause all", () => arrange(paused ? "goOn" : "pause")),
    button("Reset all", () => arrange("reset")),
    button("All as mine", () => arrange("asMine")),
    button(open ? "Close the door" : "Open the door", () => arrange(open ? "close" : "open")),
    button(own_names ? "Names by us" : "Let them type names", () => arrange(own_names ? "givenNames" : "ownNames")),
    button("Save all as a zip", () => arrange("zip")),
    button("End", () => confirm("End the class? Everything that was given is deleted.") && arrange("end")),
  );
  return box;
}
