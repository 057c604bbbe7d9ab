// @ts-check
/** softrod's part of the page; viser's page has the panel, the nodes and the connection. */
import { mindAbsence } from "./away.js";
import { tellApart } from "./viser/axis_numbers.js";
import { addClassroom } from "./classroom/classroom.js";
import { addBodyKeys } from "./hands/body_keys.js";
import { fit, fitted, keepFlat } from "./body/camera.js";
import { addChase, toggleChase } from "./body/chase.js";
import { drawBody, shown } from "./body/canvas.js";
import { askedScene, watchConnection } from "./viser/connection.js";
import { mindDialogs } from "./viser/dialogs.js";
import { addEmpty } from "./body/empty.js";
import { showHud } from "./looks/hud.js";
import { hasKept, keepOnlyOf, resume } from "./kept/keep.js";
import { listenToKeys } from "./hands/keys.js";
import { keepAddress, listenToLinks, openLink, takeLink } from "./kept/links.js";
import { addLoads } from "./body/load_marks.js";
import { beginViser, canDraw, complain, endLoading, mindGraphics } from "./viser/loading.js";
import { restoreLooks, toggleProjector } from "./looks/looks.js";
import { addMenu } from "./looks/menu.js";
import { mindWidgets } from "./viser/widgets.js";
import { mindNumbers } from "./viser/numbers.js";
import { addOverlay } from "./body/overlay.js";
import { sayWhose } from "./owner.js";
import { listenToCommands, provide } from "../wire/perform.js";
import { listenToPointer } from "./hands/pointer.js";
import { addPaper } from "./body/paper.js";
import { listenToPresses } from "./hands/presses.js";
import { addUnderlay } from "./body/underlay.js";
import { addTransport } from "./time/transport.js";
import * as seen from "./viser/seen.js";
import { isKnown, whenViser } from "./viser/viser.js";
import { send } from "../wire/channel.js";
import { FEATURES } from "./features.js";

/** What the page does itself, of no feature. @type {Record<import("../wire/wire.js").PageCommands["core"], () => void>} */
const OWN = {
  fit: () => void fit(true),
  chase: () => toggleChase(),
  larger: () => toggleProjector(),
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
  mindWidgets();
  provide(OWN);
  listenToCommands();
  keepFlat();
  addChase(); // before what is drawn where the camera looks
  mindDialogs();
  listenToPresses();
  addOverlay(); // its hint goes with the first press, which others keep for themselves
  addUnderlay();
  addTransport(); // over which strips stand
  addLoads();
  // Before the keys and pointers of the body: a tool that is out has them first.
  for (const { commands, begin } of FEATURES) {
    provide(commands);
    begin();
  }
  listenToKeys();
  mindNumbers();
  listenToPointer();
  resume(openLink);
  listenToLinks();
  restoreLooks();
  addPaper();
  addClassroom();
  addMenu();
  addEmpty();
  addBodyKeys();
  // For the browser tests.
  Object.assign(window, { __softrod: { shown, fitted, send, ...seen } });
});
if (canDraw()) {
  late = setTimeout(() => complain(FAULT), 1e3 * PATIENCE);
  beginViser();
} else {
  complain(NO_WEBGL);
}
