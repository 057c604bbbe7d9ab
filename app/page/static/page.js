// What viser's page cannot do by itself: keys that are held, the pointer at every frame, a flat camera.
//
// It runs once per page. It talks to the server through one hidden text element, whose id is given to it,
// and hears from the server through the attributes of the element #softrod-state. It leans on viser's own
// test hook, window.__viserMutable; viser is pinned exactly, and the browser tests drive all of this.
(() => {
  const CHANNEL = "%CHANNEL%";
  if (window.__softrod) {
    window.__softrod.channel = CHANNEL;
    return;
  }
  const softrod = (window.__softrod = { channel: CHANNEL, held: new Set(), sequence: 0, fits: 0 });
  document.title = "softrod";
  const viser = () => window.__viserMutable;
  const state = () => document.getElementById("softrod-state")?.dataset ?? {};

  const send = (kind, payload) => {
    // The number makes every message differ from the one before, which viser would otherwise drop.
    const value = `${++softrod.sequence}|${kind}|${payload}`;
    viser()?.sendMessage?.({ type: "GuiUpdateMessage", uuid: softrod.channel, updates: { value } });
  };

  // ---------------------------------------------------------------- keys
  const ARROWS = { ArrowUp: "U", ArrowDown: "D", ArrowLeft: "L", ArrowRight: "R" };
  const ONCE = { Space: "play", KeyN: "step", KeyR: "reset", KeyF: "follow", Escape: "pause", Digit0: "fit" };
  const CAMERA_KEYS = new Set(["KeyW", "KeyA", "KeyS", "KeyD", "KeyQ", "KeyE"]);

  const isTyping = (target) =>
    target instanceof HTMLElement &&
    (target.isContentEditable ||
      target.tagName === "TEXTAREA" ||
      target.tagName === "SELECT" ||
      (target.tagName === "INPUT" && !["range", "checkbox", "radio", "button"].includes(target.type)));
  const dialogIsOpen = () => document.querySelector('[role="dialog"]') !== null;
  const mine = (event) => {
    event.preventDefault();
    event.stopImmediatePropagation();
  };
  const sendHeld = () => send("keys", [...softrod.held].join(""));
  const hold = (key) => {
    if (!softrod.held.has(key)) {
      softrod.held.add(key);
      sendHeld();
    }
  };
  const release = (key) => {
    if (softrod.held.delete(key)) sendHeld();
  };
  const releaseAll = () => {
    if (softrod.held.size) {
      softrod.held.clear();
      sendHeld();
    }
  };

  window.addEventListener(
    "keydown",
    (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target) || dialogIsOpen()) return;
      const arrow = ARROWS[event.key];
      if (arrow) {
        mine(event);
        hold(arrow);
        return;
      }
      if (CAMERA_KEYS.has(event.code)) {
        mine(event); // viser would move the camera
        return;
      }
      const once = ONCE[event.code];
      if (!once) return;
      // A button reached with the Tab key is pressed with Space, as everywhere.
      if (once === "play" && document.activeElement?.matches("button:focus-visible")) return;
      mine(event);
      if (event.repeat && once !== "step") return;
      if (once === "fit") fit();
      else send("do", once);
    },
    true,
  );
  window.addEventListener(
    "keyup",
    (event) => {
      const arrow = ARROWS[event.key];
      if (arrow) {
        release(arrow);
        if (!isTyping(event.target)) mine(event);
      }
    },
    true,
  );
  window.addEventListener("blur", releaseAll);
  document.addEventListener("visibilitychange", releaseAll);
  // The server forgets keys of which it hears nothing; so it hears of them as long as they are held.
  setInterval(() => softrod.held.size && sendHeld(), 150);

  // ---------------------------------------------------------------- the arrow pad, for touch screens
  const padKey = (event) => event.target.closest?.("[data-softrod-key]");
  document.addEventListener("pointerdown", (event) => {
    const button = padKey(event);
    if (!button) return;
    event.preventDefault();
    button.setPointerCapture(event.pointerId);
    button.classList.add("softrod-on");
    hold(button.dataset.softrodKey);
  });
  for (const kind of ["pointerup", "pointercancel", "lostpointercapture"]) {
    document.addEventListener(kind, (event) => {
      const button = padKey(event);
      if (!button) return;
      button.classList.remove("softrod-on");
      release(button.dataset.softrodKey);
    });
  }
  document.addEventListener("contextmenu", (event) => padKey(event) && event.preventDefault());

  // ---------------------------------------------------------------- the pointer
  let pointer = null; // last place over the canvas, in pixels of the window
  let pressed = false;
  let asked = false;

  // Where the pointer meets the plane z = 0, in the coordinates of the scene's nodes.
  const world = () => {
    const { canvas, camera, nodeRefFromName } = viser() ?? {};
    const root = nodeRefFromName?.[""];
    if (!canvas || !camera || !root || !pointer) return null;
    const box = canvas.getBoundingClientRect();
    const x = ((pointer.x - box.left) / box.width) * 2 - 1;
    const y = 1 - ((pointer.y - box.top) / box.height) * 2;
    const inverse = root.matrixWorld.clone().invert();
    const near = camera.position.clone().set(x, y, -1).unproject(camera).applyMatrix4(inverse);
    const far = camera.position.clone().set(x, y, 1).unproject(camera).applyMatrix4(inverse);
    const part = near.z / (near.z - far.z);
    return near.lerp(far, part);
  };
  const report = () => {
    asked = false;
    const place = world();
    if (place && Number.isFinite(place.x) && Number.isFinite(place.y)) {
      send("at", `${place.x.toFixed(6)},${place.y.toFixed(6)}`);
    }
  };
  const follows = () => state().follow === "1";
  window.addEventListener(
    "pointermove",
    (event) => {
      if (event.target !== viser()?.canvas && !pressed) return; // off the canvas it stays where it is
      pointer = { x: event.clientX, y: event.clientY };
      // At most once per animation frame, and only while somebody wants to know.
      if ((pressed || follows()) && !asked) {
        asked = true;
        requestAnimationFrame(report);
      }
    },
    true,
  );
  window.addEventListener(
    "pointerdown",
    (event) => {
      if (event.target !== viser()?.canvas) return;
      pressed = true;
      pointer = { x: event.clientX, y: event.clientY };
    },
    true,
  );
  for (const kind of ["pointerup", "pointercancel"]) {
    window.addEventListener(kind, () => (pressed = false), true);
  }

  // ---------------------------------------------------------------- the camera, seen from the front
  const flatten = (controls) => {
    const { ACTION } = controls.constructor;
    controls.minAzimuthAngle = controls.maxAzimuthAngle = controls.azimuthAngle;
    controls.minPolarAngle = controls.maxPolarAngle = Math.PI / 2;
    controls.mouseButtons.left = ACTION.TRUCK;
    controls.mouseButtons.right = ACTION.TRUCK;
    controls.mouseButtons.middle = ACTION.TRUCK;
    controls.touches.one = ACTION.TOUCH_TRUCK;
    controls.touches.two = ACTION.TOUCH_DOLLY_TRUCK;
    controls.touches.three = ACTION.TOUCH_TRUCK;
    controls.dollyToCursor = true;
  };
  // What lies over the canvas at the bottom: the sheet of the panel on a phone.
  const covered = (box) => {
    let top = box.bottom;
    for (const element of document.elementsFromPoint(box.left + box.width / 2, box.bottom - 4)) {
      if (element === viser().canvas || element.contains(viser().canvas)) break;
      const { top: edge, width } = element.getBoundingClientRect();
      if (width > 0.9 * box.width && edge > box.top + 0.2 * box.height) top = Math.min(top, edge);
    }
    return box.bottom - top;
  };
  // Show the scene's frame, whole, in the part of the canvas that can be seen.
  const fit = () => {
    const { canvas, camera, cameraControl: controls, nodeRefFromName } = viser() ?? {};
    const root = nodeRefFromName?.[""];
    const { width, height } = state();
    if (!canvas || !controls || !root || !(width > 0)) return false;
    const box = canvas.getBoundingClientRect();
    if (!(box.width > 0 && box.height > 0)) return false;
    const hidden = covered(box);
    const free = box.height - hidden;
    const perPixel = 1.04 * Math.max(width / box.width, height / free);
    const distance = (perPixel * box.height) / (2 * Math.tan((camera.fov * Math.PI) / 360));
    const low = -(perPixel * hidden) / 2;
    controls.minAzimuthAngle = -Infinity;
    controls.maxAzimuthAngle = Infinity;
    // From the nodes' coordinates to those of the camera.
    const eye = camera.position.clone().set(0, low, distance).applyMatrix4(root.matrixWorld);
    const target = camera.position.clone().set(0, low, 0).applyMatrix4(root.matrixWorld);
    controls.setLookAt(eye.x, eye.y, eye.z, target.x, target.y, target.z, false);
    controls.maxDistance = 20 * distance;
    controls.minDistance = distance / 200;
    controls.update(0);
    flatten(controls);
    softrod.fits += 1;
    return true;
  };
  let fitted = null;
  let flat = null;
  let size = "";
  setInterval(() => {
    const { canvas, cameraControl: controls } = viser() ?? {};
    if (!canvas || !controls) return;
    if (flat !== controls || controls.mouseButtons.left !== controls.constructor.ACTION.TRUCK) {
      flat = controls;
      flatten(controls);
    }
    const { scene, width } = state();
    const now = `${canvas.clientWidth}x${canvas.clientHeight}`;
    if (width > 0 && (fitted !== scene || size !== now) && fit()) {
      fitted = scene;
      size = now;
    }
  }, 100);
})();
