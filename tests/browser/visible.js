// What of a page can be seen and pressed, by words, roles and places alone, so that it serves any page.
// Evaluates to an object: pressables(), small(least), crowded(least), covered(),
// sideways(), unreached(within), cut(), zooms(), plain(names); each entry is plain data.
(() => {
  const PRESSABLE =
    "button, a[href], input:not([type=hidden]), select, textarea, summary, [role=button], [role=tab], [role=switch], " +
    "[role=slider], [role=checkbox], [role=radio], [role=link], [role=menuitem], [role=menuitemradio], " +
    "[role=menuitemcheckbox], [role=option], [role=combobox]";
  const LAYER = "dialog[open]:modal, [role=dialog][aria-modal=true], [role=alertdialog]";
  const tidy = (text) => (text ?? "").replace(/\s+/g, " ").trim();

  const isShown = (element) => {
    if (!element.checkVisibility({ opacityProperty: true, visibilityProperty: true, contentVisibilityAuto: true })) return false;
    const { width, height } = element.getBoundingClientRect();
    return width > 1 && height > 1;
  };

  // The part of the window in which an element can be seen: what each ancestor that clips leaves of it. With
  // `scrolls`, an ancestor that scrolls clips, too: what can be scrolled to is there, but not now. Without, nothing
  // outside of it clips: whoever scrolls sees the whole.
  const room = (element, scrolls) => {
    const box = { left: -1e6, top: -1e6, right: 1e6, bottom: 1e6, scroller: false };
    let [across, down] = [true, true];
    if (scrolls) Object.assign(box, { left: 0, top: 0, right: innerWidth, bottom: innerHeight });
    for (let at = element; at && at !== document.documentElement && at !== document.body; at = at.parentElement) {
      const style = getComputedStyle(at);
      const { left, top, right, bottom } = at.getBoundingClientRect();
      const clips = (value) => value === "hidden" || value === "clip" || (scrolls && value !== "visible");
      if (style.display === "inline" || style.display === "contents" || at instanceof SVGElement) continue;
      if (across && clips(style.overflowX)) (box.left = Math.max(box.left, left)), (box.right = Math.min(box.right, right));
      if (down && clips(style.overflowY)) (box.top = Math.max(box.top, top)), (box.bottom = Math.min(box.bottom, bottom));
      const scrollable = (value) => value === "auto" || value === "scroll";
      if (scrollable(style.overflowX)) box.scroller = true;
      across &&= scrolls || !scrollable(style.overflowX);
      down &&= scrolls || !scrollable(style.overflowY);
      if (style.position === "fixed") break;
    }
    return box;
  };

  // Words: those that are seen, the name for screen readers, and the tooltip. Own label before all.
  const named = (element) => {
    const by = tidy(element.getAttribute("aria-labelledby"))
      .split(" ")
      .map((id) => id && document.getElementById(id)?.innerText)
      .join(" ");
    const labels = [...(element.labels ?? [])].map((label) => label.innerText).join(" ");
    return tidy(element.ariaLabel || by || labels || element.getAttribute("alt") || element.placeholder || "");
  };
  const seenWords = (element) =>
    tidy(element.matches("input[type=button], input[type=submit]") ? element.value : element.matches("select, input, textarea") ? "" : element.innerText);
  const tip = (element) => tidy(element.title || element.closest("[title]")?.title || element.dataset.tip);
  const words = (element) => seenWords(element) || named(element) || tip(element) || `<${element.localName}>`;
  const kindOf = (element) => element.role || (element.localName === "input" ? element.type : element.localName);

  const front = () => {
    const open = [...document.querySelectorAll(LAYER)].filter(isShown);
    return open.at(-1) ?? document;
  };

  const pressed = (element) => getComputedStyle(element).pointerEvents !== "none" || element.labels?.length;
  const all = () => {
    const found = [...front().querySelectorAll(PRESSABLE)].filter(
      (element) => isShown(element) && pressed(element) && !element.closest("[inert]"),
    );
    // A thing that takes presses without saying so: the hand of the pointer begins at it, and words are in it.
    const known = new Set(found);
    for (const element of front().querySelectorAll("div, span, legend, label, p, li, td, th")) {
      if (getComputedStyle(element).cursor !== "pointer" || !tidy(element.innerText)) continue;
      if (element.parentElement && getComputedStyle(element.parentElement).cursor === "pointer") continue;
      if (element.closest(PRESSABLE) || element.querySelector(PRESSABLE) || element.closest("label")) continue;
      if (isShown(element) && element.innerText.length < 80) known.add(element);
    }
    return [...known];
  };

  // Of what belongs to an element: itself, what is in it, its labels, and a slider's whole track.
  const owns = (element, hit) => {
    if (!hit) return false;
    if (element === hit || element.contains(hit)) return true;
    if ([...(element.labels ?? [])].some((label) => label.contains(hit))) return true;
    if (element.closest("label")?.contains(hit)) return true;
    if (element.role !== "slider") return false;
    let track = element;
    while (track.parentElement && getComputedStyle(track.parentElement).cursor === "pointer") track = track.parentElement;
    return track.contains(hit) || [...hit.children].includes(element);
  };

  const state = (element) =>
    ["aria-pressed", "aria-checked", "aria-selected", "aria-expanded"].map((name) => element.getAttribute(name)).find(Boolean) ??
    (element.type === "checkbox" || element.type === "radio" ? String(element.checked) : null);

  // Whether it says, to eyes or to screen readers, that there is more behind it.
  const opens = (element) =>
    element.ariaExpanded === "false" ||
    (element.hasAttribute("aria-haspopup") && element.ariaHasPopup !== "false") ||
    element.matches("summary") ||
    !element.matches(PRESSABLE);

  const pressables = () => {
    const list = all();
    api.elements = list;
    return list.map((element, index) => {
      const { left, top, width, height } = element.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + height / 2];
      const clip = room(element.parentElement, true);
      const inView = x > clip.left && x < clip.right && y > clip.top && y < clip.bottom;
      return {
        index,
        kind: kindOf(element),
        seen: seenWords(element).slice(0, 120),
        name: named(element).slice(0, 120),
        tip: tip(element).slice(0, 160),
        words: words(element).slice(0, 60),
        box: [left, top, width, height].map(Math.round),
        inView,
        free: inView && owns(element, document.elementFromPoint(x, y)),
        disabled: element.matches(":disabled, [aria-disabled=true]"),
        state: state(element),
        opens: opens(element),
        value: element.value ?? element.getAttribute("aria-valuenow") ?? "",
      };
    });
  };

  const put = (element) => {
    const scrolled = [];
    for (let at = element.parentElement; at; at = at.parentElement) scrolled.push([at, at.scrollLeft, at.scrollTop]);
    element.scrollIntoView({ block: "center", inline: "nearest", behavior: "instant" });
    return () => scrolled.forEach(([at, left, top]) => at.scrollTo({ left, top, behavior: "instant" }));
  };

  // Targets with less than `least` px to hit, either way. Links within a sentence may be as high as its lines.
  const smalls = (least) =>
    all()
      .filter((element) => {
        const rects = [element, ...(element.labels ?? [])].map((one) => one.getBoundingClientRect());
        if (rects.some(({ width, height }) => width >= least - 0.5 && height >= least - 0.5)) return false;
        const text = tidy(element.innerText);
        const inSentence = element.localName === "a" && getComputedStyle(element).display === "inline";
        if (inSentence && tidy(element.parentElement?.innerText).length > text.length) return false;
        const back = put(element);
        const { left, top, width, height } = element.getBoundingClientRect();
        const [x, y] = [left + width / 2, top + height / 2];
        const [across, down] = [Math.max(width, least), Math.max(height, least)].map((size) => size / 2 - 1);
        // A box of that size somewhere about it is enough: it may reach further on one side.
        const reaches = (shiftX, shiftY) =>
          [-1, 1].every((i) =>
            [-1, 1].every((j) =>
              owns(element, document.elementFromPoint(x + shiftX + i * (width >= least ? width / 2 - 3 : across), y + shiftY + j * (height >= least ? height / 2 - 3 : down))),
            ),
          );
        const spare = (least - Math.min(width, height)) / 2;
        const steps = [0, -spare, spare];
        const found = !steps.some((shiftX) => steps.some((shiftY) => reaches(shiftX, shiftY)));
        back();
        return found;
      });
  const small = (least) => smalls(least).map(told);
  const told = (element) => {
    const { width, height } = element.getBoundingClientRect();
    return { kind: kindOf(element), words: words(element).slice(0, 60), more: `${Math.round(width)} x ${Math.round(height)}` };
  };

  // WCAG 2.2, 2.5.8: small targets whose circle of `least` px about their middle meets another target.
  const crowded = (least) => {
    const r = least / 2;
    const middle = ({ left, top, width, height }) => [left + width / 2, top + height / 2];
    const isSmall = new Set(smalls(least));
    const boxes = all().map((element) => [element, element.getBoundingClientRect()]);
    return [...isSmall]
      .filter((element) => {
        const [x, y] = middle(element.getBoundingClientRect());
        return boxes.some(([other, box]) => {
          if (other === element || other.contains(element) || element.contains(other)) return false;
          if ([...(element.labels ?? [])].some((label) => label.contains(other))) return false;
          const [ox, oy] = middle(box);
          if (isSmall.has(other) && Math.hypot(ox - x, oy - y) < least) return true;
          const [dx, dy] = [Math.max(box.left - x, 0, x - box.right), Math.max(box.top - y, 0, y - box.bottom)];
          return Math.hypot(dx, dy) < r;
        });
      })
      .map(told);
  };

  // Things that cannot be pressed in their middle, since something lies there. What has appeared since
  // `remember` may lie over what was there before.
  let before = null;
  const remember = () => void (before = new Set([...document.querySelectorAll("*")].filter(isShown)));
  const isNew = (element) => {
    if (!before) return false;
    for (let at = element; at; at = at.parentElement) if (!before.has(at)) return true;
    return false;
  };
  const covered = () => {
    const found = [];
    for (const element of all()) {
      const { left, top, width, height } = element.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + height / 2];
      const clip = room(element.parentElement, true);
      if (x <= clip.left || x >= clip.right || y <= clip.top || y >= clip.bottom) continue;
      const hit = document.elementFromPoint(x, y);
      if (owns(element, hit) || !hit || (isNew(hit) && !isNew(element))) continue;
      found.push({ kind: kindOf(element), words: words(element).slice(0, 60), more: `under ${words(hit.closest(PRESSABLE) ?? hit).slice(0, 40)}` });
    }
    return found;
  };

  // What scrolls sideways, but for what is drawn; and what can be pressed nowhere, wherever one scrolls.
  const sideways = () => {
    const found = [];
    const wide = document.scrollingElement;
    if (wide.scrollWidth > innerWidth + 1) found.push({ kind: "page", words: "", more: `${wide.scrollWidth} in ${innerWidth} px` });
    for (const element of front().querySelectorAll("*")) {
      if (element.scrollWidth <= element.clientWidth + 1 || !isShown(element) || element.matches("input, textarea, select")) continue;
      if (!["auto", "scroll"].includes(getComputedStyle(element).overflowX)) continue;
      found.push({ kind: element.className || element.localName, words: tidy(element.innerText).slice(0, 60), more: `${element.scrollWidth} in ${element.clientWidth} px` });
    }
    return found;
  };
  const unreached = (within) =>
    all()
      .filter((element) => !element.matches(":disabled") && element.closest(within))
      .map((element) => {
        const back = put(element);
        const { left, top, width, height } = element.getBoundingClientRect();
        const [x, y] = [left + width / 2, top + height / 2];
        const hit = document.elementFromPoint(x, y);
        const fault = owns(element, hit) ? null : { ...told(element), more: hit ? `under ${words(hit.closest(PRESSABLE) ?? hit).slice(0, 40)}` : "out of the window" };
        back();
        return fault;
      })
      .filter(Boolean);

  const cut = () => {
    const found = [];
    const tell = (element, text, more) => found.push({ kind: kindOf(element), words: tidy(text).slice(0, 60), more });
    const walker = document.createTreeWalker(front() === document ? document.body : front(), NodeFilter.SHOW_TEXT);
    const range = document.createRange();
    while (walker.nextNode()) {
      const node = walker.currentNode;
      const element = node.parentElement;
      if (!element || !tidy(node.textContent) || !isShown(element)) continue;
      if (element.matches("option, style, script, textarea, noscript, title") || element.closest("svg defs")) continue;
      range.selectNodeContents(node);
      const { left, right, top, bottom, width, height } = range.getBoundingClientRect();
      if (width < 1 || height < 1 || parseFloat(getComputedStyle(element).fontSize) < 1) continue;
      const clip = room(element, false);
      // Words for screen readers alone are clipped to a pixel.
      if (clip.right - clip.left < 3 || clip.bottom - clip.top < 3) continue;
      if (getComputedStyle(element).clip === "rect(0px, 0px, 0px, 0px)") continue;
      // What is wholly out of its room is put away, not cut; letters have some empty room above and below.
      if (right <= clip.left || left >= clip.right || bottom <= clip.top || top >= clip.bottom) continue;
      const spare = 0.2 * height;
      if (left < clip.left - 1 || right > clip.right + 1) tell(element, node.textContent, "cut at its side");
      else if (top < clip.top - spare || bottom > clip.bottom + spare) tell(element, node.textContent, "cut above or below");
      else if ((left < -1 || right > innerWidth + 1) && !clip.scroller) {
        if (right > 0 && left < innerWidth) tell(element, node.textContent, "out of the window");
      } else {
        const control = element.closest(PRESSABLE);
        if (!control || element.closest("svg")) continue;
        const own = control.getBoundingClientRect();
        if (getComputedStyle(control).display === "inline") continue;
        if (left < own.left - 1 || right > own.right + 1 || top < own.top - spare || bottom > own.bottom + spare) {
          tell(control, node.textContent, "out of its control");
        }
      }
    }
    // A value is no text of the page: its width is measured.
    const pen = new OffscreenCanvas(1, 1).getContext("2d");
    for (const input of document.querySelectorAll("input:not([type=range], [type=checkbox], [type=radio]), select")) {
      if (!isShown(input) || !front().contains(input)) continue;
      const text = input.localName === "select" ? tidy(input.selectedOptions[0]?.text) : input.value;
      const { fontWeight, fontSize, fontFamily, paddingLeft, paddingRight } = getComputedStyle(input);
      pen.font = `${fontWeight} ${fontSize} ${fontFamily}`; // the shorthand is empty where figures are tabular
      const free = input.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight);
      if (pen.measureText(text).width > free + 1) tell(input, `${named(input)} ${text}`, "longer than its box");
    }
    return found;
  };

  // Fields with letters below 16 px: browsers of phones zoom in to write in them.
  const zooms = () => {
    const fields = [...document.querySelectorAll("input:not([type=range], [type=checkbox], [type=radio]), select, textarea")];
    return fields
      .filter((field) => isShown(field) && front().contains(field) && parseFloat(getComputedStyle(field).fontSize) < 16)
      .map((field) => ({ kind: kindOf(field), words: named(field), more: getComputedStyle(field).fontSize }));
  };

  // Words in plain letters on a page in pseudo-English, whose own words have accents: what no message says. Names,
  // addresses, codes and what is in a language of its own are marked as such; names of quantities also stand in
  // sentences, and `names` has a pattern of these. A list is of no raw names of parts, though it marks them. Of the
  // units, "min" alone is long enough for a word.
  const plain = (names) => {
    const [quantity, part] = [new RegExp(names, "g"), /^(?:joint|mass|spring)\d+$/];
    const found = new Map();
    const look = (element, text) => {
      const isListed = element.localName === "option" && part.test(text);
      if (element.closest("[translate=no], code, script, style, noscript, [lang]:not(html)") && !isListed) return;
      if (!isShown(element.closest("select") ?? element)) return;
      const words = (text ?? "").replace(/https?:\S+|\d min\b/g, "").replace(quantity, "").match(/\p{L}+/gu) ?? [];
      if (words.some((word) => /^[A-Za-z]{3,}$/.test(word) && /[aceinouydgklrstz]/.test(word))) found.set(tidy(text), element);
    };
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) look(walker.currentNode.parentElement, walker.currentNode.data);
    for (const element of document.querySelectorAll("[aria-label], [aria-valuetext], [aria-description], [title], [placeholder], [alt]"))
      for (const name of ["aria-label", "aria-valuetext", "aria-description", "title", "placeholder", "alt"]) look(element, element.getAttribute(name));
    return [...found].map(([text, element]) => ({ kind: kindOf(element), words: text.slice(0, 100), more: element.closest("[class]")?.className?.toString().slice(0, 60) ?? "" }));
  };

  const api = { pressables, small, crowded, covered, sideways, unreached, cut, zooms, plain, remember, elements: [] };
  return (window.visibleThings = api);
})()
