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

FRAMES = """count => window.softrodFrames
  ? window.softrodFrames(count)
  : new Promise(done => {
      const next = () => (count-- > 0 ? requestAnimationFrame(next) : done());
      next();
    })"""
"""Resolves after so many frames, which come as fast as they can while somebody waits for them."""

ROUGH = """
  const real = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    return real.call(this, kind, { ...options, antialias: false });
  };
  const ask = requestAnimationFrame.bind(window);
  const calls = new Map();
  let last = 0, drawn = 0, asked = false, timer, wanted = 0;
  const draw = (time) => {
    asked = false;
    drawn = performance.now();
    const now = [...calls.values()];
    calls.clear();
    for (const call of now) call(time);
  };
  const soon = () => {
    clearTimeout(timer);
    timer = setTimeout(() => ask(draw), wanted > 0 ? 0 : drawn + 45 - performance.now());
    asked = true;
  };
  window.requestAnimationFrame = (call) => {
    calls.set(++last, call);
    if (!asked) soon();
    return last;
  };
  window.cancelAnimationFrame = (number) => void calls.delete(number);
  window.softrodFrames = async (count) => {
    wanted += 1;
    if (asked) soon();
    for (; count > 0; count--) await new Promise(window.requestAnimationFrame);
    wanted -= 1;
  };
"""
"""What is most of a test's work in software is left out: edges are not smoothed, and frames come some 20
times a second, as on a slow phone, but for those that a test waits for."""

BLANK = """
  class Nothing {}
  const one = () => new Nothing();
  const constants = WebGL2RenderingContext;
  const answers = {
    VERSION: "WebGL 2.0",
    SHADING_LANGUAGE_VERSION: "WebGL GLSL ES 3.00",
    VENDOR: "nobody",
    RENDERER: "a graphics card",
    IMPLEMENTATION_COLOR_READ_TYPE: constants.HALF_FLOAT,
    VIEWPORT: new Int32Array(4),
    SCISSOR_BOX: new Int32Array(4),
  };
  const known = {
    getParameter: (name) => answers[Object.keys(answers).find((key) => constants[key] === name)] ?? 4096,
    getShaderPrecisionFormat: () => ({ rangeMin: 127, rangeMax: 127, precision: 23 }),
    getSupportedExtensions: () => [],
    getExtension: () => null,
    // A program that is linked, and has neither uniforms nor attributes.
    getProgramParameter: (_, name) => (name === constants.LINK_STATUS ? true : 0),
    getShaderParameter: () => true,
    getProgramInfoLog: () => "",
    getShaderInfoLog: () => "",
    getError: () => constants.NO_ERROR,
    checkFramebufferStatus: () => constants.FRAMEBUFFER_COMPLETE,
    isContextLost: () => false,
    getContextAttributes: () => ({ alpha: true, depth: true }),
    getAttribLocation: () => -1,
    fenceSync: one,
  };
  const { prototype } = constants;
  const shared = Object.create(prototype);
  for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(prototype))) {
    if (typeof value === "function") {
      const answer = known[name] ?? (name.startsWith("create") ? one : () => undefined);
      Object.defineProperty(shared, name, { value: answer });
    }
  }
  const contexts = new WeakMap();
  const context = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, options) {
    if (kind !== "webgl2") return context.call(this, kind, options);
    if (!contexts.has(this)) {
      const made = Object.create(shared, {
        canvas: { value: this },
        drawingBufferWidth: { get: () => this.width },
        drawingBufferHeight: { get: () => this.height },
      });
      for (const name of ["drawingBufferColorSpace", "unpackColorSpace"]) {
        Object.defineProperty(made, name, { value: "srgb", writable: true });
      }
      contexts.set(this, made);
    }
    return contexts.get(this);
  };
"""
"""A WebGL that draws nothing. Software draws for half of a test's time, and few tests look at pixels; camera,
places and what lies under the pointer are computed without it."""
