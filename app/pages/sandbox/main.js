// @ts-check
/** softrod's part of the page; viser's page has the panel, the nodes and the connection. */
import { mindAbsence } from "../../ui/away.js";
import { tellApart } from "../../ui/viser/axis_numbers.js";
import { addClassroom } from "../../features/classroom/classroom.js";
import { fitted, keepFlat } from "../../stage/camera.js";
import { addChase } from "../../stage/chase.js";
import { drawBody, shown } from "../../stage/canvas.js";
import { askedScene, watchConnection } from "../../ui/viser/connection.js";
import { mindDialogs } from "../../ui/viser/dialogs.js";
import { addEdgeArrow } from "../../stage/edge.js";
import { addEmpty } from "../../stage/empty.js";
import { showHud } from "../../ui/hud.js";
import { hasKept, keepOnlyOf, resume } from "../../ui/kept/keep.js";
import { keepAddress, listenToLinks, openLink, takeLink } from "../../ui/kept/links.js";
import { addLoads } from "../../stage/load_marks.js";
import { beginViser, canDraw, complain, endLoading, mindGraphics } from "../../ui/viser/loading.js";
import { mindWidgets } from "../../ui/viser/widgets.js";
import { mindNumbers } from "../../ui/viser/numbers.js";
import { addOverlay } from "../../stage/overlay.js";
import { onMarksRedraw } from "../../stage/sight.js";
import { sayWhose } from "../../ui/owner.js";
import { listenToCommands, provide } from "../../wire/perform.js";
import { addPaper } from "../../stage/paper.js";
import { listenToPresses } from "../../ui/hands/presses.js";
import { addUnderlay } from "../../stage/underlay.js";
import * as seen from "../../ui/viser/seen.js";
import { isKnown, whenViser } from "../../ui/viser/viser.js";
import { send } from "../../wire/channel.js";
import { FEATURES } from "./features.js";

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
  listenToCommands();
  keepFlat();
  addChase(); // before what is drawn where the camera looks
  mindDialogs();
  listenToPresses();
  addOverlay(); // its hint goes with the first press, which others keep for themselves
  const drawEdgeArrow = addEdgeArrow();
  addUnderlay();
  addLoads();
  for (const { commands, begin } of FEATURES) {
    provide(commands);
    begin();
  }
  mindNumbers();
  resume(openLink);
  listenToLinks();
  addPaper();
  addClassroom();
  addEmpty();
  onMarksRedraw(drawEdgeArrow); // last: it stands where nothing else does
  // For the browser tests.
  Object.assign(window, { __softrod: { shown, fitted, send, ...seen } });
});
if (canDraw()) {
  late = setTimeout(() => complain(FAULT), 1e3 * PATIENCE);
  beginViser();
} else {
  complain(NO_WEBGL);
}
