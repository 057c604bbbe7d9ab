// @ts-check
/** The form in which a lesson is made, which is loaded when it is opened. */
import { onMessage, send } from "../../wire/channel.js";
import { hearLater } from "../../wire/later.js";
import { kept, store } from "../../ui/kept/storage.js";

/** Key under which the tab stores that the form is open. */
const STORED = "softrod-making";

const KINDS = /** @type {const} */ (["lessonForm", "lessonOffers", "lessonTaken", "versions", "link"]);

function begin() {
  hearLater(KINDS, (message) => message.tell === "lessonForm" && message.open, async () => {
    const { MakingForm } = await import("./form.js");
    const form = new MakingForm();
    return (message) => form.hear(message);
  });
  onMessage("lessonForm", ({ open }) => store(STORED, open ? "1" : ""));
  // After a reload or an outage the server has a new page, without a form.
  let page = "";
  onMessage("pageState", (state) => {
    if (state.page === page) return;
    page = state.page;
    if (kept(STORED) === "1") send({ do: "makeLesson", on: true });
  });
}

/** @type {import("../../ui/feature.js").Feature<"making">} */
export default { commands: {}, begin };
