// @ts-check
/** The table of commands. Made by `uv run python -m tests.page.generate` from the features. */

/**
 * @typedef {import("../words/keys.js").Plain} Key of a text
 *
 * @typedef {object} Row see app/ui/commands.py
 * @property {Key} label
 * @property {Key} [word]
 * @property {Key} [hint]
 * @property {string[]} keys as `pressed` in key_table.js has them: "ctrl shift z"
 * @property {string} [shown] the first of them, as it is shown
 * @property {string} [needs]
 * @property {string} [icon]
 * @property {string} [where]
 * @property {boolean} [page] whether the page's script does it
 */
/** @type {Record<import("./wire.js").CommandName, Row>} */
export const COMMANDS = {
  play: {"label": "command-play", "keys": [" "], "shown": "Space", "icon": "M7 4v16l13-8z"},
  step: {"label": "command-step", "word": "command-step.word", "keys": ["n"], "shown": "N", "icon": "M6 5v14l9-7zM16 5h2v14h-2z"},
  steps: {"label": "command-steps", "keys": ["shift n"], "shown": "Shift N"},
  back: {"label": "command-back", "word": "command-back.word", "keys": [","], "shown": ",", "icon": "M18 5v14l-9-7zM6 5h2v14H6z"},
  forward: {"label": "command-forward", "word": "command-forward.word", "keys": ["."], "shown": ".", "icon": "M6 5v14l9-7zM16 5h2v14h-2z"},
  second: {"label": "command-second", "word": "command-second.word", "keys": ["j"], "shown": "J", "icon": "M20 5v14l-8-7zM11 5v14l-8-7z"},
  before: {"label": "command-before", "word": "command-before.word", "keys": []},
  reset: {"label": "command-reset", "word": "command-reset.word", "keys": ["r"], "shown": "R", "icon": "M12 5V1L7 6l5 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z"},
  pause: {"label": "command-pause", "word": "command-pause.word", "keys": ["Escape"], "shown": "Esc", "icon": "M6 4h4v16H6zM14 4h4v16h-4z"},
  run: {"label": "command-run", "keys": []},
  forget: {"label": "command-forget", "keys": []},
  follow: {"label": "command-follow", "keys": ["f"], "shown": "F"},
  ownBody: {"label": "command-own-body", "keys": []},
  plot: {"label": "command-plot", "keys": ["g"], "shown": "G", "needs": "measure"},
  hear: {"label": "command-hear", "hint": "command-hear.hint", "keys": ["h"], "shown": "H"},
  hearLive: {"label": "command-hear-live", "keys": ["shift h"], "shown": "Shift H"},
  stopwatch: {"label": "command-stopwatch", "keys": ["t", "l"], "shown": "T", "where": "own"},
  energy: {"label": "command-energy", "keys": [], "needs": "solver"},
  foretell: {"label": "command-foretell", "keys": [], "needs": "solver"},
  ownSolver: {"label": "command-own-solver", "keys": []},
  share: {"label": "command-share", "keys": [], "needs": "files", "page": true},
  video: {"label": "command-video", "keys": [], "needs": "files", "page": true},
  picture: {"label": "command-picture", "keys": ["i"], "shown": "I", "page": true},
  gallery: {"label": "command-gallery", "keys": ["o"], "shown": "O", "needs": "chooser", "page": true},
  anew: {"label": "command-anew", "keys": [], "needs": "chooser"},
  muscle: {"label": "command-muscle", "hint": "command-muscle.hint", "keys": ["u"], "shown": "U", "needs": "edit"},
  modes: {"label": "command-modes", "hint": "command-modes.hint", "keys": ["v"], "shown": "V", "needs": "modes"},
  mute: {"label": "command-mute", "keys": ["m"], "shown": "M", "needs": "modes", "page": true},
  race: {"label": "command-race", "hint": "command-race.hint", "keys": ["a"], "shown": "A", "needs": "chooser", "page": true},
  leaveRace: {"label": "command-leave-race", "keys": [], "needs": "chooser"},
  lesson: {"label": "command-lesson", "hint": "command-lesson.hint", "keys": [], "needs": "edit"},
  edit: {"label": "command-edit", "word": "command-edit.word", "hint": "command-edit.hint", "keys": ["e"], "shown": "E", "needs": "edit", "icon": "M4 20l1-4L16 5l3 3L8 19zM14 7l3 3", "page": true},
  cross: {"label": "command-cross", "hint": "command-cross.hint", "keys": ["x"], "shown": "X", "needs": "edit", "page": true},
  undo: {"label": "command-undo", "word": "command-undo.word", "keys": ["ctrl z"], "shown": "Ctrl Z", "icon": "M9 7L4 12l5 5M4 12h10a5 5 0 0 1 0 10h-2"},
  redo: {"label": "command-redo", "word": "command-redo.word", "keys": ["ctrl y"], "shown": "Ctrl Y", "icon": "M15 7l5 5-5 5M20 12H10a5 5 0 0 0 0 10h2"},
  hand: {"label": "command-hand", "hint": "command-hand.hint", "keys": ["q"], "shown": "Q", "icon": "M8 12V5.5a1.5 1.5 0 0 1 3 0V11m0-1V4.5a1.5 1.5 0 0 1 3 0V11m0-5a1.5 1.5 0 0 1 3 0v7c0 4-2 7-6 7-3 0-4-1-5.500-4l-2-3.500a1.500 1.500 0 0 1 2.500-1.500L8 14", "where": "edit"},
  build: {"label": "command-build", "hint": "command-build.hint", "keys": ["b"], "shown": "B", "icon": "M6 18a2.500 2.500 0 1 0 0-.01zM18 8a2.500 2.500 0 1 0 0-.01zM8 16l8-7M18 15v6M15 18h6", "where": "edit"},
  joint: {"label": "command-joint", "hint": "command-joint.hint", "keys": ["k"], "shown": "K", "icon": "M5 19L19 6M5 19h15M11 13.500a8 8 0 0 1 2.500 5.500", "where": "edit"},
  select: {"label": "command-select", "hint": "command-select.hint", "keys": ["s"], "shown": "S", "icon": "M5 4l14 7-6 2-2 6z", "where": "edit"},
  cut: {"label": "command-cut", "hint": "command-cut.hint", "keys": ["c"], "shown": "C", "icon": "M6 8a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM6 20a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM7.700 7.200L19 18M7.700 16.800L19 6", "where": "edit"},
  pin: {"label": "command-pin", "hint": "command-pin.hint", "keys": ["p"], "shown": "P", "where": "edit"},
  remove: {"label": "command-remove", "hint": "command-remove.hint", "keys": ["Delete", "Backspace"], "shown": "Delete", "where": "edit"},
  duplicate: {"label": "command-duplicate", "hint": "command-duplicate.hint", "keys": ["ctrl d"], "shown": "Ctrl D", "where": "edit"},
  copy: {"label": "command-copy", "keys": ["ctrl c"], "shown": "Ctrl C", "where": "edit"},
  all: {"label": "command-all", "keys": ["ctrl a"], "shown": "Ctrl A", "where": "edit"},
  mirror: {"label": "command-mirror", "hint": "command-mirror.hint", "keys": [], "where": "edit"},
  corners: {"label": "command-corners", "hint": "command-corners.hint", "keys": [], "where": "edit"},
  triangulate: {"label": "command-triangulate", "hint": "command-triangulate.hint", "keys": [], "where": "edit"},
  rest: {"label": "command-rest", "hint": "command-rest.hint", "keys": [], "where": "edit"},
  keep: {"label": "command-keep", "hint": "command-keep.hint", "keys": [], "where": "edit"},
  stiffen: {"label": "command-stiffen", "hint": "command-stiffen.hint", "keys": [], "where": "edit"},
  fit: {"label": "command-fit", "keys": ["0"], "shown": "0", "page": true},
  chase: {"label": "command-chase", "hint": "command-chase.hint", "keys": [], "needs": "view", "page": true},
  larger: {"label": "command-larger", "keys": ["z"], "shown": "Z", "page": true},
  dark: {"label": "command-dark", "keys": [], "needs": "view"},
  meter: {"label": "command-meter", "hint": "command-meter.hint", "keys": [], "needs": "view"},
  gizmos: {"label": "command-gizmos", "hint": "command-gizmos.hint", "keys": [], "needs": "view"},
  palette: {"label": "command-palette", "keys": ["ctrl k"], "shown": "Ctrl K", "page": true},
  help: {"label": "command-help", "keys": [], "needs": "help"},
  access: {"label": "command-access", "hint": "command-access.hint", "keys": [], "needs": "view", "page": true},
  describe: {"label": "command-describe", "hint": "command-describe.hint", "keys": ["d"], "shown": "D", "page": true},
  describeBody: {"label": "command-describe-body", "hint": "command-describe-body.hint", "keys": ["shift d"], "shown": "Shift D"},
  body: {"label": "command-body", "keys": ["Tab"], "shown": "Tab", "where": "own"},
  lengths: {"label": "command-lengths", "keys": ["↑ ↓"], "shown": "↑ ↓", "where": "held"},
  angles: {"label": "command-angles", "keys": ["→ ←"], "shown": "→ ←", "where": "held"},
};
