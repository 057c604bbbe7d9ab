// When an attempt to connect is made, when a connection counts as dead, and what the page does meanwhile.
import assert from "node:assert/strict";
import { test } from "node:test";
import { become, canvas, key, pass, point, put, show, Target } from "./page.mjs";
import { awaySince, watchConnectionLoss } from "../../app/ui/away.js";
import { askedScene, serverPath, watchConnection } from "../../app/ui/viser/connection.js";
import { Attempts, Pulse } from "../../app/wire/pulse.js";
import { callAll } from "../../app/wire/channel.js";
import { listenToKeys } from "../../app/ui/hands/keys.js";
import { listenToPointer } from "../../app/ui/hands/pointer.js";
import { listenToPresses } from "../../app/ui/hands/presses.js";

test("an attempt to connect has its time, and another begins when it has failed", () => {
  const attempts = new Attempts();
  assert.equal(attempts.begin(0), true);
  assert.equal(attempts.begin(1000), false);
  assert.equal(attempts.begin(7000), false);
  assert.equal(attempts.begin(9000), true);
  attempts.end();
  assert.equal(attempts.begin(9001), true);
});

test("a reader that throws is reported, and keeps nothing from the others", () => {
  const [reported, heard] = [[], []];
  globalThis.reportError = (error) => reported.push(error.message);
  callAll([() => heard.push("one"), () => { throw new Error("broken"); }, (what) => heard.push(what)], "three");
  delete globalThis.reportError;
  assert.deepEqual([heard, reported], [["one", "three"], ["broken"]]);
});

/** What looks at the clock find, as [ms, what]; something comes at the times in `heard`. */
function looks(times, heard = [], pulse = new Pulse()) {
  const waiting = [...heard];
  return times.map((now) => {
    while (waiting.length && waiting[0] <= now) {
      waiting.shift();
      pulse.heard();
    }
    return pulse.look(now);
  });
}
const seconds = (from, to, every = 1) => Array.from({ length: (to - from) / every + 1 }, (_, i) => 1000 * (from + every * i));

test("a connection that says something now and then is well", () => {
  assert.deepEqual(new Set(looks(seconds(0, 60), seconds(0, 60)).slice(1)), new Set(["well"]));
  // At rest it is asked every other second, and answers.
  const found = looks(seconds(0, 60), seconds(0, 60, 2));
  assert.ok(!found.includes("silent") && !found.includes("dead"));
});

test("silence is asked about, then said within ten seconds, then ended", () => {
  const found = looks(seconds(0, 20));
  const [ask, silent, dead] = ["ask", "silent", "dead"].map((what) => found.indexOf(what, 1));
  assert.ok(1 < ask && ask <= 3 && ask < silent && silent < 10 && silent < dead && dead < 20, String(found));
});

test("a page that is looked at seldom, or stood still, does not blame the server", () => {
  for (const every of [3, 60, 3600]) {
    const found = looks(seconds(0, 40 * every, every));
    assert.deepEqual(new Set(found), new Set(["ask"]));
  }
  // Then it is in front again, and the answer to what it asked comes late, but comes.
  const pulse = new Pulse();
  looks([0, 1000, 90_000, 91_000, 92_000], [], pulse);
  pulse.heard();
  assert.equal(pulse.look(93_000), "well");
});

test("a connection that ended while the page stood is replaced within seven seconds after it", () => {
  const pulse = new Pulse();
  looks(seconds(0, 6), seconds(0, 2), pulse);
  const found = looks(seconds(1000, 1010), [], pulse);
  assert.deepEqual(found.slice(0, 5), ["ask", "well", "ask", "ask", "ask"]);
  assert.equal(found.indexOf("dead"), 5);
  // One that says something is well again, and has the usual time.
  const lively = new Pulse();
  assert.ok(!looks([0, ...seconds(1000, 1012)], [1_000_500], lively).includes("dead"));
});

test("a path that is slow, and not dead, gets more time from one connection to the next", () => {
  const pulse = new Pulse();
  const found = looks(seconds(0, 300), [], pulse);
  const ends = found.flatMap((what, i) => (what === "dead" ? [i] : []));
  const between = ends.map((end, i) => end - (ends[i - 1] ?? 0));
  assert.ok(between[1] > 1.5 * between[0] && between.at(-1) < 60, String(between));
  // Once a path has been well for a minute, the next silence is a short one again.
  const after = looks(seconds(301, 380), seconds(301, 360), pulse);
  assert.ok(after.includes("dead") && after.indexOf("dead") < 75, String(after));
});

test("the server's address has the page's name, its controls, and at first its scene", () => {
  assert.equal(serverPath("ab", "", true), "/at/ab");
  assert.equal(serverPath("ab", "?fixedDpr=1&controls=play,keys", true), "/at/ab?controls=play%2Ckeys");
  assert.equal(serverPath("ab", "?s=AB12&controls=", true), "/at/ab?s=AB12&controls=");
  assert.equal(serverPath("ab", "?s=AB12&controls=", false), "/at/ab?controls=");
  assert.equal(askedScene("?controls=play&scene=lesson-hooke"), "scene=lesson-hooke");
});

/** What the page has its worker do, since this was asked last: what is sent in short, or what else it is to do. */
const posted = [];
const asked = () => posted.splice(0).map(({ type, message, server }) => (message?.text ? JSON.parse(message.text).do : (message?.type ?? server ?? type)));
globalThis.Worker = class extends Target {
  postMessage(message) {
    posted.push(message);
  }
};
watchConnection(watchConnectionLoss(), () => true);
listenToPresses();
listenToKeys();
listenToPointer();
const worker = new window.Worker("");
window.__viserMutable.sendMessage = (message) => worker.postMessage({ type: "send", message });
const comes = (type = "message") => worker.dispatchEvent(new MessageEvent("message", { data: { type } }));
const banner = () => document.querySelector(".softrod-banner").textContent;
/** Lets seconds go by, in each of which the server says something, or answers what it is asked, or is silent. */
function live(seconds, server = () => {}) {
  for (let i = 0; i < seconds; i++) {
    pass(1000);
    server();
  }
}
const answer = () => asked().includes("BeatMessage") && comes();

test("a page at rest, in the background or asleep for an hour raises no alarm", () => {
  comes("connected");
  live(60, answer);
  assert.deepEqual([banner(), awaySince()], ["", Infinity]);
  pass(3.6e6);
  assert.ok(asked().includes("BeatMessage"), "it asks for a sign of life");
  live(3, answer);
  assert.deepEqual([banner(), document.documentElement.hasAttribute("data-softrod-away")], ["", false]);
});

test("a stall ends what is under way, and nothing that is pressed meanwhile is done, neither then nor later", () => {
  show([[100, 100], [500, 400]]);
  const button = put("button");
  let clicks = 0;
  button.addEventListener("click", () => (clicks += 1));
  const click = () => button.dispatchEvent(new PointerEvent("click", { bubbles: true }));
  point("down", { x: 500, y: 400 });
  key("ArrowRight");
  comes();
  asked();
  live(3, comes);
  assert.deepEqual(new Set(asked()), new Set(["keys"]), "it asks for nothing while something comes");
  live(6);
  assert.equal(banner(), "");
  asked();
  live(2);
  assert.ok(banner().startsWith("Not connected") && awaySince() < Infinity);
  const end = asked().filter((what) => what !== "BeatMessage");
  assert.deepEqual(end.slice(-2).sort(), ["drop", "keys"], "the drag and the key end while they can");
  point("move", { x: 600, y: 400 });
  key("ArrowRight", {}, "keyup");
  key("r");
  key("ArrowLeft");
  click();
  window.__viserMutable.sendMessage({ text: "{}" });
  live(3);
  assert.deepEqual([new Set(asked()), clicks], [new Set(["BeatMessage"]), 0]);
  for (const [name, more] of [["Tab"], ["F5"], ["c", { ctrlKey: true }]]) assert.ok(!key(name, more).defaultPrevented, name);
  comes();
  assert.deepEqual([banner(), awaySince()], ["", Infinity]);
  point("move", { x: 610, y: 400 });
  pass(200);
  assert.deepEqual(asked(), [], "the same connection goes on, the drag does not");
  key("r");
  click();
  assert.deepEqual([asked(), clicks], [["perform"], 1]);
});

test("a connection that is dead is given up for a new one, which is told what it needs before anything is said", () => {
  worker.postMessage({ type: "set_server", server: "ws://here" });
  const [first] = asked();
  assert.match(first, /^ws:\/\/here\/at\/[0-9a-f]{32}$/);
  comes("connected");
  become();
  live(13);
  const since = awaySince();
  key("r");
  assert.ok(!asked().includes("perform"));
  live(3);
  assert.ok(banner().startsWith("Not connected"));
  assert.equal(awaySince(), since);
  // viser's page begins a new attempt; a second one waits until that has had its time.
  assert.deepEqual(asked().filter((what) => what !== "BeatMessage"), [first]);
  worker.postMessage({ type: "retry" });
  live(4);
  assert.deepEqual(asked(), []);
  comes("connected");
  assert.equal(banner(), "");
  key("r");
  assert.deepEqual(asked(), [], "the server has not said yet how things are");
  become();
  key("r");
  assert.deepEqual(asked(), ["perform"]);
  comes("closed");
  live(1);
  assert.deepEqual(asked(), [first], "one that was there and is lost is replaced at once");
});
