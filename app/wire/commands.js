// @ts-check
/** The table of commands. Made by `uv run python -m tests.page.generate` from app/wire/commands.py. */

/**
 * @typedef {object} Row see app/wire/commands.py
 * @property {string} label
 * @property {string} [word]
 * @property {string[]} keys as `pressed` in key_table.js has them: "ctrl shift z"
 * @property {string} [shown] the first of them, as it is shown
 * @property {string} [hint]
 * @property {string} [needs]
 * @property {string} [icon]
 * @property {string} [where]
 * @property {boolean} [page] whether the page's script does it
 */
/** @type {Record<import("./wire.js").CommandName, Row>} */
export const COMMANDS = {
  play: {"label": "Play or pause", "keys": [" "], "shown": "Space", "icon": "M7 4v16l13-8z"},
  step: {"label": "1 step", "word": "Step", "keys": ["n"], "shown": "N", "icon": "M6 5v14l9-7zM16 5h2v14h-2z"},
  steps: {"label": "10 steps", "keys": ["shift n"], "shown": "Shift N"},
  back: {"label": "Back 1 frame", "word": "Frame", "keys": [","], "shown": ",", "icon": "M18 5v14l-9-7zM6 5h2v14H6z"},
  forward: {"label": "Forward 1 frame", "word": "Frame", "keys": ["."], "shown": ".", "icon": "M6 5v14l9-7zM16 5h2v14h-2z"},
  second: {"label": "Back 1 second", "word": "1 s", "keys": ["j"], "shown": "J", "icon": "M20 5v14l-8-7zM11 5v14l-8-7z"},
  before: {"label": "Go back to just before it exploded", "word": "Go back to just before it", "keys": []},
  reset: {"label": "Reset", "word": "Reset", "keys": ["r"], "shown": "R", "icon": "M12 5V1L7 6l5 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z"},
  pause: {"label": "Pause", "word": "Pause", "keys": ["Escape"], "shown": "Esc", "icon": "M6 4h4v16H6zM14 4h4v16h-4z"},
  run: {"label": "Play", "keys": []},
  forget: {"label": "Take the line away", "keys": []},
  follow: {"label": "Follow the pointer, or stop", "keys": ["f"], "shown": "F"},
  ownBody: {"label": "The body's own values", "keys": []},
  plot: {"label": "Plot the joint's angle", "keys": ["g"], "shown": "G", "needs": "measure"},
  stopwatch: {"label": "Stopwatch", "keys": ["t", "l"], "shown": "T", "where": "own"},
  energy: {"label": "Energy: follow it, or stop", "keys": [], "needs": "solver"},
  foretell: {"label": "Predictability: measure it, or stop", "keys": [], "needs": "solver"},
  ownSolver: {"label": "The solver's own values", "keys": []},
  share: {"label": "Share this scene by a link", "keys": [], "needs": "files", "page": true},
  video: {"label": "Measure in a video", "keys": [], "needs": "files", "page": true},
  picture: {"label": "Picture of the page (PNG)", "keys": ["i"], "shown": "I", "page": true},
  gallery: {"label": "Choose another scene", "keys": ["o"], "shown": "O", "needs": "chooser", "page": true},
  anew: {"label": "Open this scene anew", "keys": [], "needs": "chooser"},
  muscle: {"label": "Muscle", "keys": ["u"], "shown": "U", "hint": "Springs and joints that move to a beat; again, and they are none any more", "needs": "edit"},
  modes: {"label": "Modes", "keys": ["v"], "shown": "V", "hint": "how the body can swing, and how much of each is in its motion", "needs": "modes"},
  mute: {"label": "Sound of the modes, or silence", "keys": ["m"], "shown": "M", "needs": "modes", "page": true},
  race: {"label": "Race against another body", "keys": ["a"], "shown": "A", "hint": "all on this terrain, started together", "needs": "chooser", "page": true},
  leaveRace: {"label": "Leave the race", "keys": [], "needs": "chooser"},
  lesson: {"label": "Make a lesson", "keys": [], "hint": "steps with a question, a goal, sliders and plots", "needs": "edit"},
  edit: {"label": "Edit", "word": "Edit", "keys": ["e"], "shown": "E", "hint": "Build and change the body", "needs": "edit", "icon": "M4 20l1-4L16 5l3 3L8 19zM14 7l3 3", "page": true},
  undo: {"label": "Undo the last change of the body", "word": "Undo", "keys": ["ctrl z"], "shown": "Ctrl Z", "icon": "M9 7L4 12l5 5M4 12h10a5 5 0 0 1 0 10h-2"},
  redo: {"label": "Do again what was undone", "word": "Redo", "keys": ["ctrl y"], "shown": "Ctrl Y", "icon": "M15 7l5 5-5 5M20 12H10a5 5 0 0 0 0 10h2"},
  hand: {"label": "Hand", "keys": ["h"], "shown": "H", "hint": "Take hold of masses and drag them", "icon": "M8 12V5.5a1.5 1.5 0 0 1 3 0V11m0-1V4.5a1.5 1.5 0 0 1 3 0V11m0-5a1.5 1.5 0 0 1 3 0v7c0 4-2 7-6 7-3 0-4-1-5.500-4l-2-3.500a1.500 1.500 0 0 1 2.500-1.500L8 14", "where": "edit"},
  build: {"label": "Build", "keys": ["b"], "shown": "B", "hint": "Click for a mass, drag from mass to mass for a spring", "icon": "M6 18a2.500 2.500 0 1 0 0-.01zM18 8a2.500 2.500 0 1 0 0-.01zM8 16l8-7M18 15v6M15 18h6", "where": "edit"},
  joint: {"label": "Joint", "keys": ["k"], "shown": "K", "hint": "Point at a mass and click a corner for an angular spring", "icon": "M5 19L19 6M5 19h15M11 13.500a8 8 0 0 1 2.500 5.500", "where": "edit"},
  select: {"label": "Select", "keys": ["s"], "shown": "S", "hint": "Click parts, or drag a frame around them", "icon": "M5 4l14 7-6 2-2 6z", "where": "edit"},
  cut: {"label": "Cut", "keys": ["c"], "shown": "C", "hint": "Draw a line through springs", "icon": "M6 8a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM6 20a2 2 0 1 0 0-4 2 2 0 0 0 0 4zM7.700 7.200L19 18M7.700 16.800L19 6", "where": "edit"},
  pin: {"label": "Pin", "keys": ["p"], "shown": "P", "hint": "Fix the masses where they are, or release them", "where": "edit"},
  remove: {"label": "Delete", "keys": ["Delete", "Backspace"], "shown": "Delete", "hint": "Delete what is selected", "where": "edit"},
  duplicate: {"label": "Duplicate", "keys": ["ctrl d"], "shown": "Ctrl D", "hint": "Add a copy next to it", "where": "edit"},
  copy: {"label": "Copy", "keys": ["ctrl c"], "shown": "Ctrl C", "where": "edit"},
  all: {"label": "Select all", "keys": ["ctrl a"], "shown": "Ctrl A", "where": "edit"},
  mirror: {"label": "Mirror", "keys": [], "hint": "Left becomes right", "where": "edit"},
  corners: {"label": "Corners", "keys": [], "hint": "Add angular springs at all corners, at rest as they are", "where": "edit"},
  triangulate: {"label": "Triangulate", "keys": [], "hint": "Add springs until there are only triangles", "where": "edit"},
  rest: {"label": "Rest as is", "keys": [], "hint": "Set rest lengths and rest angles to the present ones", "where": "edit"},
  keep: {"label": "Keep this shape", "keys": [], "hint": "Set springs and joints so that they hold the body as it is now", "where": "edit"},
  stiffen: {"label": "Keep it, stiffer", "keys": [], "hint": "The same, with as much stiffness as that needs", "where": "edit"},
  fit: {"label": "Show the whole scene", "keys": ["0"], "shown": "0", "page": true},
  chase: {"label": "Camera goes with the body", "keys": [], "hint": "with both, in a race; pan and zoom as ever", "needs": "view", "page": true},
  larger: {"label": "Larger, for a projector", "keys": ["p"], "shown": "P", "page": true},
  dark: {"label": "Dark", "keys": [], "needs": "view"},
  meter: {"label": "Stability bar", "keys": [], "hint": "always, not only where the time step is near its limit", "needs": "view"},
  gizmos: {"label": "Arrows at held masses", "keys": [], "hint": "to drag them along one axis", "needs": "view"},
  palette: {"label": "Find anything", "keys": ["ctrl k"], "shown": "Ctrl K", "page": true},
  help: {"label": "Help", "keys": [], "needs": "help"},
  access: {"label": "Access and language", "keys": [], "hint": "language, letters as keys, larger, less motion", "needs": "view", "page": true},
  describe: {"label": "Describe the body", "keys": ["d"], "shown": "D", "hint": "in words, also what changed"},
  body: {"label": "The body by keys", "keys": ["Tab"], "shown": "Tab", "where": "own"},
  lengths: {"label": "Every spring longer, shorter", "keys": ["↑ ↓"], "shown": "↑ ↓", "where": "held"},
  angles: {"label": "Every rest angle up, down", "keys": ["→ ←"], "shown": "→ ←", "where": "held"},
};
