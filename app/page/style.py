"""The styles of a page that depend on its colours, and on which controls it has."""

from __future__ import annotations

from ..drawing.colors import Palette


def style_text(
    colors: Palette, dark: bool, sliders: list[tuple[str, str]], outlined: list[str], beside: str = ""
) -> str:
    """The styles in a palette's colours.

    Args:
        colors: the palette.
        dark: whether the page is dark.
        sliders: ids of sliders, each with that of the number box that stands in place of the slider's own.
        outlined: ids of buttons that are drawn as an outline.
        beside: id of a button that stands beside the control before it, as its icon.
    """
    rows = ",".join(f'div:has(>[id="{slider}"])' for slider, _ in sliders)
    boxes = ",".join(f'.mantine-NumberInput-root:has([id="{box}"])' for _, box in sliders)
    own = ",".join(f'div:has(>[id="{slider}"])>.mantine-InputWrapper-root' for slider, _ in sliders)
    rules = ""
    if sliders:
        rules = f"{own}{{display:none}}"
        rules += f"{rows}{{padding-right:5.6em}}{boxes}{{width:5.2em;margin:-1.75em 0 0 auto;z-index:4}}"
    root = {
        "text": colors.css("text"),
        "line": colors.css("grid_major"),
        "grid": colors.css("grid"),
        "brand": colors.css("driven"),
        "on-brand": "#0b1020" if dark else "#ffffff",
        "paper": colors.css("paper"),
        "key": "#1a2230" if dark else "#f6f8fb",
        "warn": "#ff922b" if dark else "#c2410c",
    }
    if outlined:
        buttons = ",".join(f'button[id="{button}"]' for button in outlined)
        rules += f":is({buttons}){{background:transparent;color:var(--softrod-text);"
        rules += "border:1px solid var(--softrod-text)}"
        # The library's own colour of the text under the pointer is that of a filled button.
        rules += f":is({buttons}):hover{{background:var(--softrod-key);color:var(--softrod-text)}}"
        rules += f":is({buttons}):disabled{{opacity:0.45}}"
    if beside:
        rules += f'div:has(+div>[id="{beside}"]){{padding-right:46px!important}}'
        rules += f'div:has(>[id="{beside}"]){{width:30px;margin:-34px 10px 0 auto!important}}'
        rules += f'[id="{beside}"]{{width:30px;height:26px!important;padding:0;font-size:0}}'
        rules += f'[id="{beside}"] .mantine-Button-section{{margin:0!important;font-size:14px}}'
        rules += f'[id="{beside}"] svg{{left:0!important}}'
    variables = ";".join(f"--softrod-{name}:{value}" for name, value in root.items())
    return f":root{{{variables}}}{rules}"
