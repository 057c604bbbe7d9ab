// @ts-check
/** Starts softrod's part of the page; viser's page has the panel, the nodes and the connection. */
import { watchConnectionLoss } from "../../ui/away.js";
import { loadClassroom } from "../../features/classroom/classroom.js";
import { fitted, isSettled, keepFlat } from "../../stage/camera.js";
import { addChase } from "../../stage/chase.js";
import { drawBody, shown } from "../../stage/canvas.js";
import { askedScene, watchConnection } from "../../ui/viser/connection.js";
import { addEdgeArrow } from "../../stage/edge.js";
import { addEmpty } from "../../stage/empty.js";
import { charts, clearPanel, drawPanel } from "../../ui/gui/gui.js";
import { showHud } from "../../ui/hud.js";
import { hasKept, keepOnlyOf, resume, watchAddress } from "../../ui/kept/keep.js";
import { keepAddress, listenToLinks, openLink, takeLink } from "../../ui/kept/links.js";
import { addKeyMarks } from "../../stage/key_marks.js";
import { addLoads } from "../../stage/load_marks.js";
import { canDraw, showFault, endLoading, offerReload, viserScript, watchGraphics } from "../../ui/viser/loading.js";
import { addOverlay } from "../../stage/overlay.js";
import { onMarksRedraw } from "../../stage/sight.js";
import { identify } from "../../ui/owner.js";
import { sounds } from "../../ui/loudspeaker.js";
import { listenToCommands, provide } from "../../wire/perform.js";
import { addPaper } from "../../stage/paper.js";
import { listenToPresses } from "../../ui/hands/presses.js";
import { listenToTaps } from "../../ui/hands/taps.js";
import { addUnderlay } from "../../stage/underlay.js";
import * as seen from "../../ui/viser/seen.js";
import { isKnown, project, render, viserCanvas, whenViser } from "../../ui/viser/viser.js";
import { onMessage, send } from "../../wire/channel.js";
import { say } from "../../words/words.js";
import { FEATURES } from "./features.js";

/** Seconds within which viser's page makes its hook, if ever. */
const PATIENCE = 20;

identify();
takeLink();
keepAddress();
keepOnlyOf(new URLSearchParams(location.search).get("room") || askedScene(location.search));
const lineChanged = watchConnectionLoss();
let isSilent = false;
watchConnection(
  (line) => {
    lineChanged(line);
    // A connection that was only silent goes on; a new one declares its own controls.
    if (line === "connected" && !isSilent) clearPanel();
    isSilent = line === "silent";
  },
  () => !hasKept(),
);
/** @type {ReturnType<typeof setTimeout> | undefined} */
let late;
let addClassroom = () => {};
whenViser((viser) => {
  clearTimeout(late);
  if (!isKnown(viser)) {
    showFault(say("ui-other-viser"));
    return;
  }
  endLoading();
  watchGraphics();
  drawBody(viser);
  showHud();
  drawPanel();
  listenToCommands();
  keepFlat();
  addChase(); // before everything that is drawn where the camera looks
  listenToPresses();
  listenToTaps();
  addOverlay(); // before others, which stop the press that removes its hint
  const drawEdgeArrow = addEdgeArrow();
  addUnderlay();
  addLoads();
  addKeyMarks();
  for (const { commands, begin } of FEATURES) {
    provide(commands);
    begin();
  }
  resume(openLink);
  listenToLinks();
  watchAddress();
  addPaper();
  const heading = document.querySelector("main > h1");
  onMessage("pageState", ({ title }) => {
    if (heading) heading.textContent = title || "softrod";
    document.title = title ? `${title} · softrod` : "softrod";
  });
  addClassroom();
  addEmpty();
  onMarksRedraw(drawEdgeArrow); // last: it stands where nothing else does
  // For the browser tests.
  const tested = { shown, fitted, isSettled, send, charts, sounds, canvas: viserCanvas, project, render, ...seen };
  Object.assign(window, { __softrod: tested });
});
if (canDraw()) {
  Promise.all([viserScript(), loadClassroom()]).then(([script, add]) => {
    addClassroom = add;
    late = setTimeout(() => showFault(say("ui-other-viser")), 1e3 * PATIENCE);
    document.head.append(script);
  }, offerReload);
} else {
  showFault(say("ui-needs-webgl"));
}
