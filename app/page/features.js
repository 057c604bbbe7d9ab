// @ts-check
/** The features of the page. Made by `uv run python -m tests.page.generate` from app/page/features.py. */
import modes from "../features/modes/modes.js";
import race from "../features/race/race.js";

export const FEATURES = [modes, race];
