"""What the tests have the page's browser do, in its own language."""

HARDWARE = """
  for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
    const real = prototype.getParameter;
    prototype.getParameter = function (name) {
      return name === 0x9246 ? "a graphics card" : real.call(this, name);  // UNMASKED_RENDERER_WEBGL
    };
  }
"""
"""Spares the test viser's word on software rendering, which would lie over the canvas."""

FORGET = """() => {
  Storage.prototype.setItem = () => {};
  sessionStorage.clear();
  localStorage.clear();
}"""

FRAMES = """count => new Promise(done => {
  const next = () => (count-- > 0 ? requestAnimationFrame(next) : done());
  next();
})"""

ROUGH = """
  const real = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return real.call(this, kind, { ...options, antialias: false });
  };
  const ask = requestAnimationFrame.bind(window);
  const calls = new Map();
  let last = 0, drawn = 0, asked = false;
  const draw = (time) => {
    asked = false;
    drawn = performance.now();
    const now = [...calls.values()];
    calls.clear();
    for (const call of now) call(time);
  };
  window.requestAnimationFrame = (call) => {
    calls.set(++last, call);
    if (!asked) setTimeout(() => ask(draw), drawn + 45 - performance.now());
    asked = true;
    return last;
  };
  window.cancelAnimationFrame = (number) => void calls.delete(number);
"""
"""What is most of a test's work in software is left out: edges are not smoothed, and frames come some 20
times a second, as on a slow phone."""
