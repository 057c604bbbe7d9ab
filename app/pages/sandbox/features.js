// @ts-check
/** The features of the page. Made by `uv run python -m tests.page.generate` from app/pages/sandbox/features.py. */
import time from "../../features/time/time.js";
import lesson from "../../features/lesson/lesson.js";
import measure from "../../features/measure/measure.js";
import instruments from "../../features/instruments/instruments.js";
import fit from "../../features/fit/fit.js";
import files from "../../features/files/files.js";
import gallery from "../../features/gallery/gallery.js";
import muscles from "../../features/muscles/muscles.js";
import modes from "../../features/modes/modes.js";
import race from "../../features/race/race.js";
import making from "../../features/making/making.js";
import edit from "../../features/edit/edit.js";
import view from "../../features/view/view.js";
import access from "../../features/access/access.js";
import reading from "../../features/reading/reading.js";
import describe from "../../features/describe/describe.js";
import hands from "../../features/hands/hands.js";

export const FEATURES = [time, lesson, measure, instruments, fit, files, gallery, muscles, modes, race, making, edit, view, access, reading, describe, hands];
