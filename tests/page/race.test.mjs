// A race in the page: who is first, in words, what a screen reader hears, the finish, and arrows to what is out of view.
import assert from "node:assert/strict";
import { test } from "node:test";
import { become, pass, put, show, tell } from "./page.mjs";
put("div", { class: "softrod-transport" });
import race from "../../app/features/race/race.js";
import { aheadText, middleOfWords } from "../../app/features/race/marks.js";
import { fullRace, lead, namesOf, verdict } from "../../app/features/race/words.js";

/** A race of a worm against a walker, to a finish that is 300 px away. */
const PAIR = { ways: [0, 0], arrived: [null, null], outs: ["", ""], masses: [2], more: true };
const racing = (more) => ({ on: true, names: ["Worm", "Walker"], finish: 300, lines: [500, 500], seconds: 4, ...PAIR, ...more });
const says = (more) => verdict(fullRace(racing(more)));
become({ unit: "px", playing: true });

test("the one that needs less time was first, or both at once", () => {
  assert.equal(says({ arrived: [5.21, 5.64] }), "Yours was first, by 0.43 s");
  assert.equal(says({ arrived: [5.64, 5.21] }), "Walker was first, by 0.43 s");
  assert.equal(says({ arrived: [5.21, 5.21] }), "Both at once, after 5.21 s");
});

test("what never arrives ends it as well", () => {
  assert.equal(says({ arrived: [5.21, null] }), "Yours is first, after 5.21 s");
  assert.equal(says({ arrived: [null, 5.21], outs: ["fell", ""] }), "Walker was first; yours fell");
  assert.equal(says({ arrived: [5.21, null], outs: ["", "exploded"] }), "Yours was first; Walker exploded");
  assert.equal(says({ outs: ["", "exploded"] }), "Walker exploded");
  assert.equal(says({ outs: ["fell", "exploded"] }), "Nobody was first: yours fell, Walker exploded");
  assert.equal(says({ outs: ["fell", "fell"] }), "Nobody was first: both fell");
});

test("until then the one that is nearer to the finish is ahead, to whichever side that is", () => {
  assert.equal(says({ ways: [120, 40] }), "Yours is ahead by 80 px");
  assert.equal(says({ ways: [120, 40], finish: -300 }), "Walker is ahead by 80 px");
  assert.equal(says({ ways: [120, 120.5] }), "Neither is ahead");
  assert.equal(says({ ways: [0.2, 0.1], finish: 1 }), "Yours is ahead by 0.1 px");
  assert.equal(lead(fullRace(racing({ ways: [-50, -20], finish: -300 }))), 30);
  assert.deepEqual(namesOf(fullRace(racing({ names: ["Worm", "Worm"] }))), ["Worm (yours)", "Worm (the other)"]);
});

test("of three, the first and the next are told, and what became of the rest", () => {
  const three = { names: ["Worm", "Walker", "Heart"], lines: [500, 500, 500], ways: [0, 0, 0], arrived: [null, null, null], outs: ["", "", ""], masses: [2, 1] };
  const of3 = (more) => says({ ...three, ...more });
  assert.equal(of3({ ways: [20, 90, 60] }), "Walker is ahead by 30 px");
  assert.equal(of3({ ways: [90, 90, 60] }), "None is ahead");
  assert.equal(of3({ ways: [20, 90, 60], outs: ["", "", "fell"] }), "Walker is ahead by 30 px");
  assert.equal(of3({ outs: ["exploded", "", "fell"] }), "Yours exploded, Heart fell");
  assert.equal(of3({ arrived: [null, 4.5, null] }), "Walker is first, after 4.50 s");
  assert.equal(of3({ arrived: [5, 4.5, null] }), "Walker was first, after 4.50 s");
  assert.equal(of3({ arrived: [5, 4.5, 6] }), "Walker was first, 0.50 s before yours");
  assert.equal(of3({ arrived: [5, 5, 6] }), "Yours and Walker at once, after 5.00 s");
  assert.equal(of3({ arrived: [5, null, null], outs: ["", "fell", "exploded"] }), "Yours was first; Walker fell, Heart exploded");
  assert.equal(of3({ outs: ["fell", "fell", "fell"] }), "Nobody was first: all fell");
  assert.equal(lead(fullRace(racing({ ...three, ways: [20, 90, 60] }))), -70);
  assert.deepEqual(namesOf(fullRace(racing({ ...three, names: ["Worm", "Heart", "Heart"] }))), ["Worm (yours)", "Heart 1", "Heart 2"]);
});

test("words do not go beyond the edges", () => {
  const view = { left: 0, right: 400 };
  assert.equal(middleOfWords(200, "120 px ahead", view), 200);
  const [first, last] = [0, 400].map((x) => middleOfWords(x, "120 px ahead", view));
  assert.ok(first > 50 && first < 70, `from ${first}`);
  assert.equal(last, 400 - first);
  assert.equal(aheadText(-120.4), "120 px behind");
});

const one = (name) => document.querySelector(name);
/** What a screen reader hears while the server tells this. */
function hears(...races) {
  const heard = [];
  const live = one(".softrod-race .softrod-tell");
  const before = live ? live.textContent : "";
  let last = before;
  for (const each of races) {
    tell("race", racing(each));
    pass(5000);
    const now = one(".softrod-race .softrod-tell").textContent;
    if (now !== last) heard.push((last = now));
  }
  return heard;
}

test("a screen reader hears who was first once, and hears it again after another race", async () => {
  race.begin();
  tell("race", { on: false });
  assert.equal(one(".softrod-race"), null, "it is loaded for a race only");
  tell("race", racing({ seconds: 0 }));
  await import("../../app/features/race/strip.js");
  await new Promise(setImmediate);
  assert.equal(one(".softrod-race .softrod-tell").textContent, "A race against Walker. Start (A).");
  const ran = [{ ways: [9, 5] }, { arrived: [5.2, null] }, { arrived: [5.2, 6.4] }, { arrived: [5.2, 6.4], seconds: 7, ways: [350, 301] }];
  assert.deepEqual(hears(...ran), ["Yours is ahead", "Yours was first, by 1.20 s"]);
  const bars = document.querySelectorAll(".softrod-race-row output").map((output) => output.textContent);
  assert.deepEqual(bars, ["5.20 s", "6.40 s"]);
  assert.deepEqual(hears({ seconds: 0 }, ...ran.slice(1)), ["", "Yours was first, by 1.20 s"]);
});

test("the finish is a line at its place, and an arrow where that is out of view", () => {
  show([[100, 300], [140, 300]], [[0, 1]]);
  tell("race", racing({ ways: [20, 0], lines: [500, 503] }));
  const [mine, theirs] = document.querySelectorAll(".softrod-finish");
  assert.match(mine.querySelector(".softrod-finish-line").getAttribute("d"), /^M500\.0 /);
  assert.equal(mine.querySelector("text").textContent, "Finish, 300 px");
  assert.deepEqual([mine, theirs].map(({ style }) => style.display), ["", "none"]);
  tell("race", racing({ ways: [20, 0], lines: [500, 560] }));
  assert.deepEqual([mine, theirs].map(({ style }) => style.display), ["", ""]);
  tell("race", racing({ ways: [20, 0], lines: [900, 900] }));
  assert.deepEqual([mine, theirs].map(({ style }) => style.display), ["none", "none"]);
  const arrow = one(".softrod-away.softrod-race-finish");
  assert.equal(arrow.style.display, "");
  assert.equal(arrow.querySelector("text").textContent, "Finish, 280 px ahead");
  assert.equal(one(".softrod-away.softrod-race-mine").style.display, "none");
  show([[-300, 300], [-260, 300]], [[0, 1]]);
  tell("race", racing({ ways: [20, 90] }));
  assert.equal(one(".softrod-away.softrod-race-mine").style.display, "");
  assert.equal(one(".softrod-away.softrod-race-mine").querySelector("text").textContent, "70 px behind");
});
