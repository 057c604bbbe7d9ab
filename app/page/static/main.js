// @ts-check
/** softrod's part of the page; viser's page has the panel, the nodes and the connection. */
import { addArrows } from "./arrow_marks.js";
import { mindAbsence } from "./away.js";
import { tellApart } from "./axis_numbers.js";
import { addBodyKeys } from "./body_keys.js";
import { fitted, keepFlat } from "./camera.js";
import { listenToClipboard } from "./clipboard.js";
import { drawBody, shown } from "./canvas.js";
import { askedScene, watchConnection } from "./connection.js";
import { addCoordinates } from "./coordinates.js";
import { mindDialogs } from "./dialogs.js";
import { listenToEdits } from "./edit.js";
import { listenToEditKeys } from "./edit_keys.js";
import { addEditMarks } from "./edit_marks.js";
import { addEditStrip } from "./edit_strip.js";
import { addEmpty } from "./empty.js";
import { addGallery } from "./gallery.js";
import { showHud } from "./hud.js";
import { addInstruments } from "./instruments.js";
import { hasKept, keepOnlyOf, resume } from "./keep.js";
import { listenToKeys } from "./keys.js";
import { addLesson } from "./lesson.js";
import { keepAddress, listenToLinks, openLink, takeLink } from "./links.js";
import { addLoads } from "./load_marks.js";
import { beginViser, canDraw, complain, endLoading } from "./loading.js";
import { restoreLooks } from "./looks.js";
import { showMeasures } from "./measure.js";
import { addMenu } from "./menu.js";
import { nameControls } from "./names.js";
import { mindNumbers } from "./numbers.js";
import { addOverlay } from "./overlay.js";
import { sayWhose } from "./owner.js";
import { listenToCommands } from "./perform.js";
import { readPhases } from "./phase.js";
import { listenToPointer } from "./pointer.js";
import { addPaper } from "./paper.js";
import { listenToPresses } from "./presses.js";
import { addShareDialog } from "./share.js";
import { markControls } from "./roles.js";
import { addUnderlay } from "./underlay.js";
import { addTexts } from "./texts.js";
import { hearTools } from "./tools.js";
import { addTraces } from "./trace.js";
import { addTracing } from "./tracing.js";
import { addTransport } from "./transport.js";
import { isKnown, whenViser } from "./viser.js";

/** Seconds after which viser's page has made its hook, or never will. */
const PATIENCE = 20;

const FAULT = "This page cannot draw: the viser page that it stands on is not the version that softrod knows.";
const NO_WEBGL =
  "softrod draws with WebGL 2, which this browser does not have or has switched off: allow hardware acceleration in its settings, or use another browser.";
sayWhose();
takeLink();
keepAddress();
keepOnlyOf(askedScene(location.search));
watchConnection(mindAbsence(), () => !hasKept());
const plotsAreLoaded = tellApart();
/** @type {ReturnType<typeof setTimeout> | undefined} */
let late;
whenViser((viser) => {
  clearTimeout(late);
  plotsAreLoaded();
  if (!isKnown(viser)) {
    complain(FAULT);
    return;
  }
  endLoading();
  drawBody(viser);
  showHud();
  hearTools();
  markControls();
  listenToCommands();
  keepFlat();
  mindDialogs();
  listenToPresses();
  addOverlay(); // its hint goes with the first press, which others keep for themselves
  const tracing = addTracing();
  listenToEditKeys();
  listenToKeys();
  addGallery();
  mindNumbers();
  listenToEdits();
  listenToClipboard();
  listenToPointer();
  resume(openLink);
  listenToLinks();
  restoreLooks();
  addTransport();
  addShareDialog();
  addUnderlay();
  addTraces();
  addLoads();
  addArrows();
  addCoordinates();
  addInstruments();
  addPaper();
  addLesson();
  addTexts();
  addMenu();
  addEditMarks();
  addEditStrip(tracing);
  addEmpty();
  addBodyKeys();
  nameControls();
  showMeasures();
  readPhases();
  // For the browser tests.
  Object.assign(window, { __softrod: { shown, fitted } });
});
if (canDraw()) {
  late = setTimeout(() => complain(FAULT), 1e3 * PATIENCE);
  beginViser();
} else {
  complain(NO_WEBGL);
}
