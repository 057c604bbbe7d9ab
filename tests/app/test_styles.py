"""What the page's styles must not do."""

from __future__ import annotations

import re
from pathlib import Path

import app.page

SHEETS = sorted(Path(app.page.__file__).parent.glob("**/*.css"))


def test_no_style_has_the_browser_search_the_whole_page() -> None:
    """With `:has` on what is always there, every change of a text restyled all of it, 5 ms each time."""
    assert SHEETS
    for sheet in SHEETS:
        text = re.sub(r"/\*.*?\*/", "", sheet.read_text(encoding="utf-8"), flags=re.DOTALL)
        for selector in re.findall(r"([^{}]+)\{", text):
            # Of what comes and goes, as notices, the first word alone is looked at.
            assert ":has(" not in selector or selector.strip().startswith(".mantine-Notification-root"), (
                selector
            )
