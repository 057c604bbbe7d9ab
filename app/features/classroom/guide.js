// @ts-check
/**
 * What a teacher says and does in each phase of a step, from the step's own words. Texts only, without a page.
 *
 * The order is that of peer instruction: where a class is split, pupils talk in pairs and are asked again; what is right is told
 * after it ran (Crouch and Mazur 2001, American Journal of Physics 69, 970).
 *
 * @typedef {import("../../wire/wire.js").Asking} Asking
 */

/** The sentences of a text. @param {string} text */
export const sentencesOf = (text) => text.match(/[^.?!]+(?:[.?!](?!\s|$)[^.?!]*)*[.?!]*\s*/g)?.map((one) => one.trim()) ?? [];

/** What a question says is so, and what it asks: its last sentence, which the choices may complete. @param {string} question */
export function partsOf(question) {
  const sentences = sentencesOf(question);
  const asked = sentences.at(-1) ?? "";
  return { given: sentences.slice(0, -1).join(" "), asked: !asked || /[.?!]$/.test(asked) ? asked : `${asked} …` };
}

/**
 * What to say, in words that pupils can be told as they are, and what to do meanwhile.
 *
 * @param {Asking} asking
 * @returns {{say: string, do: string}}
 */
export function guide({ phase, round, question, because, predict, do: task, collects }) {
  const { given, asked } = partsOf(question);
  const drag = predict > 0 ? `Drag the pale body to where it will be, ${predict} s after it is let go.` : "";
  switch (phase) {
    case "lobby":
      return { say: "Open the address on the wall, and type the four letters.", do: "Put the wall on the projector. Go on when all are here." };
    case "show":
      return { say: given || "Look at the body: what holds it, and what pulls it?", do: "Point at the parts; press Play to let it go. All see what you do with the body." };
    case "ask":
      if (round > 0) return { say: "Convince your neighbour, for a minute. Then answer again.", do: "Listen, and do not tell which is right." };
      return { say: [asked, drag].filter(Boolean).join(" "), do: "Wait until all have answered, and do not tell which is right." };
    case "results":
      if (round > 0) return { say: "Who has changed their mind, and why?", do: "The right answer is not told yet: the run shows it." };
      return { say: "Who wants to say why they chose theirs?", do: "Hear two who answered differently. The right answer is not told yet." };
    case "run":
      return { say: "Watch what it does.", do: predict > 0 ? `It stands still at ${predict} s. Compare it with the predictions.` : "Let it run until all have seen it." };
    case "reveal":
      return { say: "So that is what it does. Tell your neighbour why.", do: "The wall shows the predictions beside it, then what is right. Give it a moment before you speak." };
    case "explain":
      return { say: "Write in one line: why is it so?", do: `Star two lines: they are on the wall as you go on. Then tell it in your own words. ${because}`.trim() };
    case "try":
      return { say: task, do: "Walk around. A hand that is up stands on its tile." };
    default:
      return { say: collects ? `Hand in the ${collects}.` : "Hand in what you found.", do: collects ? "When most have, look at the class's plot together: what does it say? If there is a button for it, show the law." : "When most have, put one of them on the wall." };
  }
}
