import assert from "node:assert/strict";
import test from "node:test";
import { withPoint } from "../../app/page/static/numbers.js";

test("a decimal comma becomes a point, and commas that part thousands stay", () => {
  assert.equal(withPoint(","), ".");
  assert.equal(withPoint("9,81"), "9.81");
  assert.equal(withPoint("9.81"), "9.81");
  assert.equal(withPoint("1,234.5"), "1,234.5");
  assert.equal(withPoint("1,234,567"), "1,234,567");
});
