// @ts-check
/** The dialog with an address of the scene, and its QR code. */
import { onMessage, send } from "../../wire/channel.js";
import { make, makeButton, makeDialog } from "../../ui/dialog.js";

/** Characters from which on a link may be cut: by some e-mail programs, and by messengers. */
const LONG = 2000;
const TOO_LONG = 8000;

/** What can be shared, and what it is good for. */
const KINDS = {
  short: ["A short address", "To type or to photograph: for a class. This server stores the scene, and has to run when it is opened."],
  long: ["A link that holds the scene", "To send and to keep: any softrod opens it, even next year. Nothing is stored on the server."],
};
/** Which controls there are for whoever opens it. */
const CONTROLS = {
  all: "All controls",
  play: "For a phone: play and drag only",
  sliders: "For a phone: with the scene's two main sliders",
};

/** What is to be known of a link. @param {string} link @returns {string} */
export function caution(link) {
  const size = `The link has ${link.length.toLocaleString("en")} characters`;
  if (link.length > TOO_LONG) return `${size}: many messengers cut links longer than 8,000. Send the scene as a file instead (Share, Download as a file).`;
  if (link.length > LONG) return `${size}: some e-mail programs cut links longer than 2,000.`;
  return "";
}

/** Whether an address is that of the visitor's own machine. @param {string} host */
export const isOwnMachine = (host) => /^(localhost|127\..*|\[::1\])$/.test(host);
const OWN_MACHINE =
  "This address is of this machine alone. For others to open it, start softrod with --host 0.0.0.0, or with --public-url behind a proxy.";

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
  element.append(make("legend", "softrod-tell", "What to share"));
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
  const { dialog, body } = makeDialog("Share this scene", "softrod-share");
  const renew = () => {
    said.textContent = "";
    const page = new URL(".", location.href).href;
    send({ do: "share", pose: withPose.checked, page, short: kind.isShort(), controls: /** @type {keyof typeof CONTROLS} */ (controls.value) });
  };
  const kind = kindChoice(renew);
  const label = make("label", "softrod-check");
  const withPose = make("input", "");
  withPose.type = "checkbox";
  label.append(withPose, "With the present pose");
  const controls = make("select", "");
  controls.ariaLabel = "Controls for whoever opens it";
  for (const [value, text] of Object.entries(CONTROLS)) controls.add(new Option(text, value));
  const field = make("textarea", "");
  field.readOnly = true;
  field.ariaLabel = "Link to this scene";
  field.spellcheck = false;
  const said = make("span", "softrod-said");
  said.setAttribute("role", "status");
  const copy = makeButton("Copy link", async () => (said.textContent = (await copied(field)) ? "Copied." : "Press Ctrl C to copy it."));
  copy.classList.add("softrod-first");
  const line = make("div", "softrod-dialog-line");
  line.append(copy, said);
  const warning = make("p", "softrod-caution");
  const local = make("p", "softrod-caution");
  const code = make("img", "softrod-qr");
  code.alt = "QR code of the link";
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
    local.textContent = link && isOwnMachine(new URL(link).hostname) ? OWN_MACHINE : "";
    if (qr) code.src = qr;
    code.hidden = !qr;
  });
  return () => {
    if (!dialog.open) dialog.showModal();
    copy.focus();
    renew();
  };
}
