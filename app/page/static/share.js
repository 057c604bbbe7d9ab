// @ts-check
/** The dialog with a link that holds the scene, and its QR code. */
import { make, makeButton, makeDialog } from "./dialog.js";
import { ask, onMail } from "./mail.js";

/** Characters from which on a link may be cut: by some e-mail programs, and by messengers. */
const LONG = 2000;
const TOO_LONG = 8000;

/** What is to be known of a link. @param {string} link @returns {string} */
export function caution(link) {
  const size = `The link has ${link.length.toLocaleString("en")} characters`;
  if (link.length > TOO_LONG) return `${size}: many messengers cut links longer than 8,000. Send the scene as a file instead (Files, Download).`;
  if (link.length > LONG) return `${size}: some e-mail programs cut links longer than 2,000.`;
  return "";
}

/** Whether an address is that of the visitor's own machine. @param {string} host */
export const isOwnMachine = (host) => /^(localhost|127\..*|\[::1\])$/.test(host);

/** Copies what stands in a field. @param {HTMLTextAreaElement} field @returns {Promise<boolean>} whether it could */
async function copied(field) {
  try {
    await navigator.clipboard.writeText(field.value);
    return true;
  } catch {
    // Only a page of this machine or by TLS has a clipboard of its own; any other has the old way.
    field.select();
    return document.execCommand("copy");
  }
}

/** Puts up the dialog, which opens when the server says so. */
export function addShareDialog() {
  const { dialog, body } = makeDialog("Share this scene", "softrod-share");
  const about = make("p", "", "The link itself holds the scene with its present settings. Nothing is kept on the server, and whoever opens it gets a copy.");
  const label = make("label", "softrod-check");
  const withPose = make("input", "");
  withPose.type = "checkbox";
  label.append(withPose, "With the present pose");
  const field = make("textarea", "");
  field.readOnly = true;
  field.rows = 4;
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
  body.append(about, label, field, line, warning, local, code);
  if (isOwnMachine(location.hostname)) {
    local.textContent = "This address is of this machine alone. For others to open the link, start softrod with --host 0.0.0.0 and open the page by the address that it prints.";
  }

  const renew = () => {
    said.textContent = "";
    ask({ do: "share", pose: withPose.checked, origin: location.origin });
  };
  withPose.addEventListener("change", renew);
  field.addEventListener("focus", () => field.select());
  onMail("share", () => {
    if (!dialog.open) dialog.showModal();
    copy.focus();
    renew();
  });
  onMail("link", ({ link = "", qr = "", problem = "" }) => {
    field.value = link;
    copy.disabled = !link;
    warning.textContent = problem || caution(link);
    if (qr) code.src = qr;
    code.hidden = !qr;
  });
}
