// @ts-check
/** Written by `python -m app.stage.looks`; app/stage/looks.py says what each is. */
export const SHARPNESS = 4.0;
export const LAYERS = {
  "grid": {"color": "grid", "opacity": 1.0, "width": 1.0, "round": false},
  "major": {"color": "line", "opacity": 1.0, "width": 1.0, "round": false},
  "medium": {"color": "liquid", "opacity": 0.1, "width": 0.0, "round": false},
  "ripple": {"color": "liquid", "opacity": 0.45, "width": 1.3, "round": true},
  "ground": {"color": "text", "opacity": 0.07, "width": 0.0, "round": false},
  "grain": {"color": "text", "opacity": 0.4, "width": 1.6, "round": true},
  "wall": {"color": "text", "opacity": 0.1, "width": 0.0, "round": false},
  "hatch": {"color": "text", "opacity": 0.55, "width": 1.2, "round": false},
  "surface": {"color": "text", "opacity": 1.0, "width": 2.0, "round": false},
  "rail": {"color": "text", "opacity": 0.3, "width": 5.0, "round": true},
  "skin": {"color": "text", "opacity": 0.13, "width": null, "round": true},
  "gas": {"color": "brand", "opacity": 0.12, "width": 0.0, "round": false},
  "liquid": {"color": "liquid", "opacity": 0.35, "width": 0.0, "round": false},
  "wind": {"color": "text", "opacity": 0.35, "width": 1.4, "round": true},
};
export const ARROW = 2.4;
export const RESTS = 0.4;
export const WORKS = 0.05;
export const ARC_BEYOND = 7.0;
export const ARC_OPEN = 1.3;
export const ARC_HEAD = 9.0;
export const HEAD = 10.0;
export const SIDE = 4.2;
export const DENSE = 5.0;
export const HATCH = 13.0;
export const STROKE = 8.0;
export const STREAKS = 150.0;
export const STREAK = 44.0;
export const PARTS = 8;
export const POINT = 4.0;
export const RIPPLES = 90.0;
export const RIPPLE = 20.0;
export const CREST = 2.4;
export const GRAINS = 36.0;
export const GRAIN = 3.0;
export const FILL = 0.8;
export const SHINE = 0.22;
export const RING = 1.75;
export const PIN = 2.0;
export const WEDGE = 2.6;
export const FULL_DEVIATION = 30.0;
export const WIDEST = 1.2;
export const THINNEST = 0.5;
export const THICKEST = 1.2;
export const YIELDED = 0.002;
export const CREASE = 0.34;
export const ROPE = 0.5;
export const ROPE_PIECES = 12;
export const BELLY = 1.25;
export const HALO = 1.7;
export const BREATH = 0.25;
export const GHOST_WIDTH = 0.025;
export const MARGIN = 1.04;
export const NEAR = 0.2;
export const STRIP = 0.05;
export const SPEEDS = [0.125, 0.25, 0.5, 1.0, 2.0, 4.0];
export const FRACTIONS = {
  "0.125": "⅛",
  "0.25": "¼",
  "0.5": "½",
};
export const ICONS = {
  "play": "M7 4v16l13-8z",
  "pause": "M6 4h4v16H6zM14 4h4v16h-4z",
  "reset": "M12 5V1L7 6l5 5V7a5 5 0 1 1-5 5H5a7 7 0 1 0 7-7z",
};
export const LINK_PATH = "/s";
