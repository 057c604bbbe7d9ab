// @ts-check
/** Notices of the server, over the bar of time. One stays while the pointer or the focus is on it. */
import { takeOver } from "../../wire/channel.js";
import { addTeller, make, makeClose, overCanvas } from "../dialog.js";

/** Notices that are shown at a time; older ones go. */
const MAX_SHOWN = 3;
/** What stands at the lower edge of the canvas, which notices do not cover. */
const BELOW = ".softrod-dock, .softrod-menu-lid, .softrod-edit-bar";
/** Pixels between it and a notice. */
const GAP = 12;

/** @typedef {{title: string, body: string, color: string | null, auto_close_seconds: number | null}} Props */

/** Begins to show them. */
export function takeNotices() {
  const list = make("div", "softrod-notices");
  overCanvas().append(list);
  // What is said has no buttons.
  const tell = addTeller();
  /** @type {Map<string, HTMLElement>} */
  const shown = new Map();
  /** The notice that was said last. */
  let told = "";
  /** @param {string} id */
  const remove = (id) => {
    if (id === told && shown.has(id)) tell("");
    shown.get(id)?.remove();
    shown.delete(id);
  };
  /** @param {string} id @param {Props} props */
  const show = (id, { title, body, color, auto_close_seconds: seconds }) => {
    remove(id);
    const notice = make("div", "softrod-notice");
    notice.dataset.kind = color ?? "";
    const text = make("div", "softrod-notice-text");
    text.append(make("strong", "softrod-notice-title", title), make("p", "softrod-notice-body", body));
    const close = makeClose(() => remove(id));
    notice.append(text, close);
    const tops = [...document.querySelectorAll(BELOW)].map((element) => element.getBoundingClientRect()).filter(({ height }) => height);
    list.style.setProperty("--softrod-above", `${innerHeight - Math.min(innerHeight, ...tops.map(({ top }) => top)) + GAP}px`);
    list.append(notice);
    tell(/[.?!؟]$/.test(title) ? `${title} ${body}` : `${title}. ${body}`);
    told = id;
    shown.set(id, notice);
    for (const old of [...shown.keys()].slice(0, -MAX_SHOWN)) remove(old);
    if (seconds === null) return;
    /** @type {ReturnType<typeof setTimeout>} */
    let timer;
    const wait = () => {
      clearTimeout(timer);
      timer = setTimeout(() => {
        if (notice.matches(":hover, :focus-within")) wait();
        else if (shown.get(id) === notice) remove(id);
      }, 1e3 * seconds);
    };
    wait();
  };
  for (const kind of ["NotificationShowMessage", "NotificationUpdateMessage"]) {
    takeOver(kind, ({ uuid, props }) => show(uuid, /** @type {any} */ (props)));
  }
  takeOver("RemoveNotificationMessage", ({ uuid }) => remove(uuid));
}
