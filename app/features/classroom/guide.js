// @ts-check
/**
 * What a teacher says and does in each phase of a step, from the step's own words.
 *
 * The order is that of peer instruction: where a class is split, pupils talk in pairs and are asked again; what is right is told
 * after it ran (Crouch and Mazur 2001, American Journal of Physics 69, 970).
 *
 * @typedef {import("../../wire/wire.js").Asking} Asking
 */
import { say } from "../../words/words.js";

/** The sentences of a text. @param {string} text */
export const sentencesOf = (text) => text.match(/[^.?!؟]+(?:[.?!؟](?!\s|$)[^.?!؟]*)*[.?!؟]*\s*/g)?.map((one) => one.trim()) ?? [];

/** What a question says is so, and what it asks: its last sentence, which the choices may complete. @param {string} question */
export function partsOf(question) {
  const sentences = sentencesOf(question);
  const asked = sentences.at(-1) ?? "";
  return { given: sentences.slice(0, -1).join(" "), asked: !asked || /[.?!؟]$/.test(asked) ? asked : `${asked} …` };
}

/**
 * What to say, in words that pupils can be told as they are, and what to do meanwhile.
 *
 * @param {Asking} asking
 * @returns {{say: string, do: string}}
 */
export function guide({ phase, round, question, because, predict, do: task, collects, runs }) {
  const { given, asked } = partsOf(question);
  const seconds = String(predict);
  switch (phase) {
    case "lobby":
      return { say: say("guide-lobby"), do: say("guide-lobby.do") };
    case "show":
      return { say: given || say("guide-show"), do: say(question && !runs ? "guide-show.before" : "guide-show.do") };
    case "ask": {
      if (round > 0) return { say: say("guide-again"), do: say("guide-again.do") };
      const drag = predict > 0 ? say("guide-drag", { seconds }) : "";
      return { say: [asked, drag].filter(Boolean).join(" "), do: say("guide-ask") };
    }
    case "results":
      return round > 0 ? { say: say("guide-changed"), do: say("guide-changed.do") } : { say: say("guide-results"), do: say("guide-results.do") };
    case "run":
      return { say: runs ? say("guide-run-new", { runs }) : say("guide-run"), do: predict > 0 ? say("guide-run-stops", { seconds }) : say("guide-run.do") };
    case "reveal":
      return { say: say("guide-reveal"), do: say(predict > 0 ? "guide-reveal.predicted" : "guide-reveal.do") };
    case "explain":
      return { say: say("class-why"), do: say("guide-explain", { because }) };
    case "try":
      return { say: task, do: say("guide-try") };
    default:
      return collects ? { say: say("guide-collect", { collects }), do: say("guide-plot") } : { say: say("class-hand-in"), do: say("guide-collected") };
  }
}
