// Every visible text of the page with too little contrast: WCAG 2.2, 1.4.3. Backgrounds and opacities are put over
// one another as the browser does; text over the body counts as text over the paper.
() => {
  const context = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
  const parse = (color) => {
    context.clearRect(0, 0, 1, 1);
    context.fillStyle = color;
    context.fillRect(0, 0, 1, 1);
    const [r, g, b, a] = context.getImageData(0, 0, 1, 1).data;
    return [r, g, b, a / 255];
  };
  const over = ([r, g, b, a], below) => [r, g, b].map((value, i) => value * a + below[i] * (1 - a));
  const brightness = (color) => {
    const [r, g, b] = color.map((value) => value / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const probe = document.body.appendChild(document.createElement("div"));
  probe.style.background = "var(--softrod-paper)";
  const paper = parse(getComputedStyle(probe).backgroundColor).slice(0, 3);
  probe.remove();
  const judge = (element, text) => {
    const chain = [];
    for (let at = element; at; at = at.parentElement) chain.unshift(getComputedStyle(at));
    let below = paper;
    let opacity = 1;
    for (const style of chain) {
      opacity *= Number(style.opacity);
      const [r, g, b, a] = parse(style.backgroundColor);
      below = over([r, g, b, a * opacity], below);
    }
    const style = chain.at(-1);
    const [r, g, b, a] = parse(element instanceof SVGElement ? style.fill : style.color);
    const [light, dark] = [over([r, g, b, a * opacity], below), below].map(brightness).sort((x, y) => y - x);
    const size = parseFloat(style.fontSize);
    const needed = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700) ? 3 : 4.5;
    const ratio = (light + 0.05) / (dark + 0.05);
    return { text: text.trim().slice(0, 40), ratio: Number(ratio.toFixed(2)), needed };
  };
  const found = [];
  const isShown = (element) =>
    element.checkVisibility({ opacityProperty: true, visibilityProperty: true }) &&
    element.getBoundingClientRect().width > 2 &&
    parseFloat(getComputedStyle(element).fontSize) > 0 &&
    !element.matches(":disabled, :disabled *, .softrod-hint *, option, style, script");
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const { parentElement, textContent } = walker.currentNode;
    if (parentElement && textContent?.trim() && isShown(parentElement)) found.push(judge(parentElement, textContent));
  }
  for (const input of document.querySelectorAll("input:not([type=range]), select")) {
    if (input.value && isShown(input) && input.type !== "checkbox") found.push(judge(input, input.value));
  }
  return found;
}
