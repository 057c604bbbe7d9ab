// @ts-check
/** Controls of the tempo, and of the selected muscles' wave and how often it comes in a beat. */
import { send } from "../../wire/channel.js";
import { make, makeButton } from "../../ui/dialog.js";
import { say } from "../../words/words.js";

/** @typedef {import("./marks.js").Mark} Mark */

/** The slider's largest tempo, Hz, and its step. */
const FAST = 4;
const STEP = 0.05;
/** The largest tempo that can be typed, Hz. */
const MAX_TEMPO = 100;
/** Waves in a beat. */
const MAX_WAVES = 16;

/** @param {HTMLSelectElement} select @param {string} label @param {[string, string][]} options */
function fill(select, label, options) {
  select.ariaLabel = label;
  select.title = label;
  for (const [value, text] of options) select.add(new Option(text, value));
  return select;
}

export function tuning() {
  const label = make("label", "softrod-muscles-tempo", say("muscles-tempo"));
  const slider = make("input", "");
  Object.assign(slider, { type: "range", min: "0", max: String(FAST), step: String(STEP), ariaLabel: say("muscles-tempo") });
  const number = make("input", "");
  Object.assign(number, { type: "number", min: "0", max: String(MAX_TEMPO), step: "0.1", ariaLabel: say("muscles-tempo.hertz") });
  label.append(slider, number, "Hz");
  const visit = () => send({ do: "visit" });
  slider.addEventListener("pointerdown", visit);
  number.addEventListener("focus", visit);
  slider.addEventListener("input", () => {
    number.value = slider.value;
    send({ do: "tempo", frequency: Number(slider.value) });
  });
  number.addEventListener("change", () => {
    const frequency = Number(number.value);
    if (number.value === "" || !(frequency >= 0 && frequency <= MAX_TEMPO)) number.value = String(tempo);
    else send({ do: "tempo", frequency });
  });
  let tempo = 0;

  const some = make("span", "softrod-muscles-some");
  const wave = fill(make("select", ""), say("muscles-wave"), [["sine", say("muscles-wave.sine")], ["pulse", say("muscles-wave.pulse")]]);
  const often = fill(
    make("select", ""),
    say("muscles-often"),
    Array.from({ length: MAX_WAVES }, (_, k) => [String(k + 1), `${k + 1} ×`]),
  );
  wave.addEventListener("change", () => send({ do: "shapeMuscles", wave: wave.value === "pulse" ? "pulse" : "sine" }));
  often.addEventListener("change", () => send({ do: "shapeMuscles", per_beat: Number(often.value) }));
  const spread = makeButton(say("muscles-spread"), () => send({ do: "shapeMuscles", spread: true }), "");
  spread.title = say("muscles-spread.hint");
  some.append(wave, often, spread);

  /** @param {HTMLSelectElement} select @param {string[]} values */
  const choose = (select, values) => {
    if (document.activeElement === select) return;
    if (new Set(values).size === 1) [select.value] = values;
    else select.selectedIndex = -1;
  };
  return {
    elements: [label, some],
    /** @param {Mark[]} marks that are selected */
    show: (marks) => {
      some.hidden = !marks.length;
      spread.hidden = marks.length < 2;
      choose(wave, marks.map(({ pulse }) => (pulse ? "pulse" : "sine")));
      choose(often, marks.map(({ perBeat }) => String(perBeat)));
    },
    /** @param {number} frequency Hz, of single precision */
    showTempo: (frequency) => {
      tempo = Number(frequency.toPrecision(6));
      if (!slider.matches(":active")) slider.value = String(tempo);
      if (document.activeElement !== number) number.value = String(tempo);
    },
  };
}
