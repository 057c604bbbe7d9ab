// @ts-check
/** softrod's part of the page; viser's page has the panel, the nodes and the connection. */
import { addArrows } from "./measure/arrow_marks.js";
import { mindAbsence } from "./away.js";
import { tellApart } from "./viser/axis_numbers.js";
import { addClassroom } from "./classroom/classroom.js";
import { addBodyKeys } from "./hands/body_keys.js";
import { fit, fitted, keepFlat } from "./body/camera.js";
import { addChase, toggleChase } from "./body/chase.js";
import { listenToClipboard } from "./edit/clipboard.js";
import { drawBody, shown } from "./body/canvas.js";
import { askedScene, watchConnection } from "./viser/connection.js";
import { addCoordinates } from "./measure/coordinates.js";
import { mindDialogs } from "./viser/dialogs.js";
import { listenToEdits } from "./edit/edit.js";
import { listenToEditKeys } from "./edit/edit_keys.js";
import { addEditMarks } from "./edit/edit_marks.js";
import { addEditStrip } from "./edit/edit_strip.js";
import { addEmpty } from "./body/empty.js";
import { addGallery, gallery } from "./scenes/gallery.js";
import { showHud } from "./looks/hud.js";
import { addInstruments } from "./measure/instruments.js";
import { hasKept, keepOnlyOf, resume } from "./files/keep.js";
import { listenToKeys } from "./hands/keys.js";
import { addLesson } from "./scenes/lesson.js";
import { addMaker } from "./making/maker.js";
import { keepAddress, listenToLinks, openLink, takeLink } from "./files/links.js";
import { listenToOpenFile } from "./files/open_file.js";
import { addLoads } from "./body/load_marks.js";
import { beginViser, canDraw, complain, endLoading, mindGraphics } from "./viser/loading.js";
import { restoreLooks, toggleProjector } from "./looks/looks.js";
import { showMeasures } from "./measure/measure.js";
import { addMenu } from "./looks/menu.js";
import { addMuscles } from "./muscles/muscle_strip.js";
import { mindWidgets } from "./viser/widgets.js";
import { mindNumbers } from "./viser/numbers.js";
import { addOverlay } from "./body/overlay.js";
import { sayWhose } from "./scenes/owner.js";
import { listenToCommands, provide } from "../wire/perform.js";
import { readPhases } from "./measure/phase.js";
import { listenToPointer } from "./hands/pointer.js";
import { addPaper } from "./body/paper.js";
import { listenToPresses } from "./hands/presses.js";
import { addShareDialog, openShareDialog } from "./files/share.js";
import { addUnderlay } from "./body/underlay.js";
import { addTexts } from "./scenes/texts.js";
import { hearTools } from "./measure/tools.js";
import { addMeasured } from "./measure/measured.js";
import { addTraces } from "./measure/trace.js";
import { addTracing } from "./edit/tracing.js";
import { addTransport } from "./time/transport.js";
import * as seen from "./viser/seen.js";
import { isKnown, whenViser } from "./viser/viser.js";
import { send } from "../wire/channel.js";
import { FEATURES } from "./features.js";
import { editing, setEditing } from "./edit/editing.js";
import { takePicture } from "./files/picture.js";

/** What the page does itself, of no feature. @type {Record<import("../wire/wire.js").PageCommands["core"], () => void>} */
const OWN = {
  gallery: () => gallery.open(),
  share: () => openShareDialog(),
  fit: () => void fit(true),
  chase: () => toggleChase(),
  larger: () => toggleProjector(),
  picture: () => void takePicture(),
  video: () => void window.open("video", "_blank", "noopener"),
  edit: () => setEditing(!editing.on),
};

/** Seconds after which viser's page has made its hook, or never will. */
const PATIENCE = 20;

const FAULT = "This page cannot draw: the viser page that it stands on is not the version that softrod knows.";
const NO_WEBGL =
  "softrod draws with WebGL 2, which this browser does not have or has switched off: allow hardware acceleration in its settings, or use another browser.";
sayWhose();
takeLink();
keepAddress();
keepOnlyOf(new URLSearchParams(location.search).get("room") || askedScene(location.search));
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
  mindGraphics();
  drawBody(viser);
  showHud();
  hearTools();
  mindWidgets();
  provide(OWN);
  listenToCommands();
  keepFlat();
  addChase(); // before what is drawn where the camera looks
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
  listenToOpenFile();
  restoreLooks();
  addTransport();
  addMuscles();
  for (const { commands, begin } of FEATURES) {
    provide(commands);
    begin();
  }
  addShareDialog();
  addUnderlay();
  addTraces();
  addMeasured();
  addLoads();
  addArrows();
  addCoordinates();
  addInstruments();
  addPaper();
  addLesson();
  addMaker();
  addClassroom();
  addTexts();
  addMenu();
  addEditMarks();
  addEditStrip(tracing);
  addEmpty();
  addBodyKeys();
  showMeasures();
  readPhases();
  // For the browser tests.
  Object.assign(window, { __softrod: { shown, fitted, send, ...seen } });
});
if (canDraw()) {
  late = setTimeout(() => complain(FAULT), 1e3 * PATIENCE);
  beginViser();
} else {
  complain(NO_WEBGL);
}
