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

PROJECT = """points => {
  const { camera, canvas, nodeRefFromName } = window.__viserMutable;
  const box = canvas.getBoundingClientRect();
  camera.updateMatrixWorld();
  return points.map(([x, y, z]) => {
    const p = camera.position.clone().set(x, y, z).applyMatrix4(nodeRefFromName[""].matrixWorld);
    p.project(camera);
    return [box.left + ((p.x + 1) / 2) * box.width, box.top + ((1 - p.y) / 2) * box.height];
  });
}"""

INSTANCES = """name => {
  let data = null;
  window.__viserMutable.nodeRefFromName[name]?.traverse(node => {
    if (node.isInstancedMesh && node.matricesTexture) {
      data = Array.from(node.matricesTexture._data.slice(0, 16 * node.instancesCount));
    }
  });
  return data;
}"""

CAMERA = """() => {
  const { camera, cameraControl } = window.__viserMutable;
  camera.updateMatrixWorld();
  const target = cameraControl.getTarget(camera.position.clone());
  return {
    matrix: camera.matrixWorld.toArray(),
    target: target.toArray(),
    azimuth: cameraControl.azimuthAngle,
    polar: cameraControl.polarAngle,
    distance: cameraControl.distance,
  };
}"""

FRAMES = """count => new Promise(done => {
  const next = () => (count-- > 0 ? requestAnimationFrame(next) : done());
  next();
})"""
