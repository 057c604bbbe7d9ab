// @ts-check
/** The dialog with an address of the scene, and its QR code. */
import { onMessage, send } from "../../wire/channel.js";
import { make, makeButton, makeDialog } from "../../ui/dialog.js";
import { say, language } from "../../words/words.js";

/** Characters from which on a link may be cut: by some e-mail programs, and by messengers. */
const LONG = 2000;
const TOO_LONG = 8000;

/** What can be shared, and what it is good for. */
const KINDS = {
  short: [say("share-short"), say("share-short.about")],
  long: [say("share-long"), say("share-long.about")],
};
/** Which controls there are for whoever opens it. */
const CONTROLS = {
  all: say("share-controls.all"),
  play: say("share-controls.play"),
  sliders: say("share-controls.sliders"),
};

/** What is to be known of a link. @param {string} link @returns {string} */
export function caution(link) {
  const count = link.length.toLocaleString(language);
  if (link.length > TOO_LONG) return say("share-long-mail.file", { count });
  return link.length > LONG ? say("share-long-mail", { count }) : "";
}

/** Whether an address is that of the visitor's own machine. @param {string} host */
export const isOwnMachine = (host) => /^(localhost|127\..*|\[::1\])$/.test(host);

/** Copies what stands in a field. @param {HTMLTextAreaElement} field @returns {Promise<boolean>} whether it could */
export async function copied(field) {
  try {
    await navigator.clipboard.writeText(field.value);
    return true;
  } catch {
    // Only a page of this machine or by TLS has a clipboard of its own; any other has the old way.
    field.select();
    return document.execCommand("copy");
  }
}

/**
 * A choice of what is shared, with a sentence for each.
 *
 * @param {() => void} changed
 */
function kindChoice(changed) {
  const element = make("fieldset", "softrod-kinds");
  element.append(make("legend", "softrod-tell", say("share-what")));
  for (const [value, [title, about]] of Object.entries(KINDS)) {
    const label = make("label", "softrod-check");
    const radio = make("input", "");
    Object.assign(radio, { type: "radio", name: "softrod-kind", value, checked: value === "short" });
    radio.addEventListener("change", changed);
    const text = make("span", "");
    text.append(make("b", "", title), make("small", "", about));
    label.append(radio, text);
    element.append(label);
  }
  return { element, isShort: () => element.querySelector("input:checked")?.getAttribute("value") === "short" };
}

/** Makes the dialog; what is returned opens it. */
export function makeShareDialog() {
  const { dialog, body } = makeDialog(say("share-title"), "softrod-share");
  const renew = () => {
    said.textContent = "";
    const page = new URL(".", location.href).href;
    send({ do: "share", pose: withPose.checked, page, short: kind.isShort(), controls: /** @type {keyof typeof CONTROLS} */ (controls.value) });
  };
  const kind = kindChoice(renew);
  const label = make("label", "softrod-check");
  const withPose = make("input", "");
  withPose.type = "checkbox";
  label.append(withPose, say("share-pose"));
  const controls = make("select", "");
  controls.ariaLabel = say("share-controls");
  for (const [value, text] of Object.entries(CONTROLS)) controls.add(new Option(text, value));
  const field = make("textarea", "");
  field.readOnly = true;
  field.ariaLabel = say("share-link");
  field.spellcheck = false;
  const said = make("span", "softrod-said");
  said.setAttribute("role", "status");
  const copy = makeButton(say("share-copy"), async () => {
    said.textContent = say((await copied(field)) ? "share-copy.copied" : "share-copy.keys");
  });
  copy.classList.add("softrod-first");
  const line = make("div", "softrod-dialog-line");
  line.append(copy, said);
  const warning = make("p", "softrod-caution");
  const local = make("p", "softrod-caution");
  const code = make("img", "softrod-qr");
  code.alt = say("share-link.code");
  body.append(kind.element, label, controls, field, line, warning, local, code);

  withPose.addEventListener("change", renew);
  controls.addEventListener("change", renew);
  field.addEventListener("focus", () => field.select());
  onMessage("link", ({ link, qr, problem }) => {
    field.value = link;
    field.rows = kind.isShort() ? 2 : 4;
    field.classList.toggle("softrod-short", kind.isShort());
    copy.disabled = !link;
    warning.textContent = problem || caution(link);
    local.textContent = link && isOwnMachine(new URL(link).hostname) ? say("share-own-machine") : "";
    if (qr) code.src = qr;
    code.hidden = !qr;
  });
  return () => {
    if (!dialog.open) dialog.showModal();
    copy.focus();
    renew();
  };
}
