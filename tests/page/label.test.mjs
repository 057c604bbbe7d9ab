// Where a word stands beside a body.
import assert from "node:assert/strict";
import { test } from "node:test";
import { freePlace } from "../../app/stage/label.js";

const [ABOVE, BELOW, RIGHT] = [{ x: 100, y: 50 }, { x: 100, y: 150 }, { x: 200, y: 100 }];
/** A spring along the line y, from x = 0 to 150. */
const along = (y) => [0, y, 150, y];

test("the first place that no spring crosses is taken", () => {
  assert.equal(freePlace([ABOVE, BELOW, RIGHT], [0, 1], along(100), [], []), 0);
  assert.equal(freePlace([ABOVE, BELOW, RIGHT], [0, 1], along(55), [], []), 1);
  assert.equal(freePlace([ABOVE, BELOW, RIGHT], [0, 1, 2, 3], [...along(55), ...along(140)], [], []), 2);
});

test("a spring that ends beside it leaves a place free, and one that stands on end does not", () => {
  assert.equal(freePlace([RIGHT, ABOVE], [0, 1], along(100), [], []), 0);
  assert.equal(freePlace([RIGHT, ABOVE], [0, 1], [205, 0, 205, 300], [], []), 1);
});

test("other words take their places; where none is free it is the first", () => {
  const words = { left: 0, right: 120, top: 0, bottom: 60 };
  assert.equal(freePlace([ABOVE, BELOW], [], [], [], [words]), 1);
  assert.equal(freePlace([ABOVE, BELOW], [], [], [], [{ left: 0, right: 300, top: 0, bottom: 300 }]), 0);
});

test("a word stands on no mass, however large that is drawn", () => {
  assert.equal(freePlace([ABOVE, BELOW], [], [100, 90], [20], []), 0);
  assert.equal(freePlace([ABOVE, BELOW], [], [100, 90], [30], []), 1);
});

test("a large word needs more room", () => {
  assert.equal(freePlace([ABOVE, BELOW], [0, 1], along(100), [], [], { x: 60, y: 60 }), 0);
  assert.equal(freePlace([RIGHT, ABOVE], [0, 1], along(100), [4, 4], [], { x: 60, y: 30 }), 1);
});
