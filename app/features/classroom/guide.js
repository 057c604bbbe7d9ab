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
export function guide({ phase, round, question, because, predict, do: task, collects, runs }) {
  const { given, asked } = partsOf(question);
  const drag = predict > 0 ? `Drag the pale body to where it will be ${predict} s after the start.` : "";
  switch (phase) {
    case "lobby":
      return { say: "Open the address on the wall, and type the four letters.", do: "Put the wall on the projector. Go on when all are here." };
    case "show":
      return { say: given || "Look at the body: what holds it, and what pulls it?", do: `Point at the parts. ${question && !runs ? "Do not press Play yet: it runs after the question." : "Press Play to let it go: what the question asks about comes later."}` };
    case "ask":
      if (round > 0) return { say: "Convince your neighbour, for a minute. Then answer again.", do: "Listen. Do not say which is right." };
      return { say: [asked, drag].filter(Boolean).join(" "), do: "Wait until everybody has answered. Do not say which is right." };
    case "results":
      if (round > 0) return { say: "Who has changed their mind, and why?", do: "Do not give the right answer yet: the run will show it." };
      return { say: "Who would like to say why they chose what they chose?", do: "Hear two who answered differently. Do not give the right answer yet." };
    case "run":
      return { say: runs ? `Watch what it does. This is new: ${runs}` : "Watch what it does.", do: predict > 0 ? `It stops at ${predict} s. Compare it with the predictions.` : "Let it run until everybody has seen what happens." };
    case "reveal":
      return { say: "That is the answer. Tell your neighbour why.", do: `The wall shows ${predict > 0 ? "the predictions beside the body, then " : ""}the right answer. Give it a moment before you speak.` };
    case "explain":
      return { say: "Why? Answer in one sentence.", do: `Star two answers: they go on the wall in the next phase. Then explain it in your own words: ${because}` };
    case "try":
      return { say: task, do: "Walk around. Raised hands show at the right." };
    default:
      return { say: collects ? `Hand in the ${collects}.` : "Hand in what you found.", do: collects ? "When most have, look at the class's plot together: what does it say? Press Show the law, if it is offered." : "When most have, put one of them on the wall." };
  }
}
