// When an attempt to connect is made, and when a connection counts as dead.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Attempts, askedScene, Pulse, serverPath } from "../../app/page/viser/connection.js";

test("an attempt to connect has its time, and another begins when it has failed", () => {
  const attempts = new Attempts();
  assert.equal(attempts.begin(0), true);
  assert.equal(attempts.begin(1000), false);
  assert.equal(attempts.begin(7000), false);
  assert.equal(attempts.begin(9000), true);
  attempts.end();
  assert.equal(attempts.begin(9001), true);
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
