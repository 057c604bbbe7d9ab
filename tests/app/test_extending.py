"""The feature that docs/extending.md builds is one, and no other file has to know of it."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

from tests.page.check import NODE

ROOT = Path(__file__).parents[2]
FILES = (
    "speed/messages.py",
    "speed/feature.py",
    "speed/speed.js",
    "words/en/speed.ftl",
    "words/de/speed.ftl",
)
TRY = """
import sys
from pathlib import Path

import app.features
import app.words

app.words.spoken.FOLDER = Path(sys.argv[1]) / "words"
app.features.__path__.append(sys.argv[1])
from app.features.speed.feature import SpeedFeature
from app.pages.sandbox import features

features.FEATURES = (*features.FEATURES, SpeedFeature)
features.COMMANDS = {**features.COMMANDS, **SpeedFeature.commands}
features.CONTROLS = {**features.CONTROLS, **SpeedFeature.controls}
from app.wire.from_page import Perform
from tests.app.whole import WholePage
from app.features.speed.messages import Fastest
from app.words import speaking
from tests import words
from tests.page import generate

assert 'import speed from "../../features/speed/speed.js";' in generate.features()
assert "export type Fastest = " in generate.types()
assert '"speed-says": "mass" | "speed";' in generate.keys_for_script()
assert 'speed: {"label": "command-speed", ' in generate.table()
assert "| Y | how fast the fastest mass is |" in generate.keys_list()
assert not list(words.wrong("de"))
page = WholePage("rope")
page.frames(5, Perform("speed"))
page.frames(5)
told = [one for one in page.client.mail.sent if type(one).__name__ == "Fastest"]
assert told[0].mass == -1, told
assert told[-1].speed > 0.0, told
assert "Speed" in [one.name for one in page.gui.there if one.kind == "command"]
"""


def test_the_guide_s_feature_is_one(tmp_path: Path) -> None:
    guide = (ROOT / "docs" / "extending.md").read_text(encoding="utf-8")
    section = guide.partition("## A feature\n")[2].partition("\n## ")[0]
    blocks = re.findall(r"^   ```\w+\n(.*?)^   ```", section, re.DOTALL | re.MULTILINE)
    folder = tmp_path / "speed"
    folder.mkdir()
    shutil.copytree(ROOT / "app" / "words", tmp_path / "words", ignore=shutil.ignore_patterns("*.py"))
    (folder / "__init__.py").touch()
    for name, block in zip(FILES, blocks, strict=True):
        (tmp_path / name).write_text(re.sub(r"^   ", "", block, flags=re.MULTILINE), encoding="utf-8")
    (test,) = re.findall(r"^```python\n(page = .*?)^```", section, re.DOTALL | re.MULTILINE)
    tried = subprocess.run(
        [sys.executable, "-c", TRY + test, str(tmp_path)],
        capture_output=True,
        text=True,
        cwd=ROOT,
        check=False,
    )
    assert tried.returncode == 0, tried.stderr


def test_a_new_command_may_have_any_letter_that_is_free(tmp_path: Path) -> None:
    for folder in ("app", "tests/page"):
        skipped = shutil.ignore_patterns("*.py", "__pycache__", "*.webp")
        shutil.copytree(ROOT / folder, tmp_path / folder, ignore=skipped)
    table = tmp_path / "app" / "wire" / "commands.js"
    text = table.read_text(encoding="utf-8")
    free = [letter for letter in "abcdefghijklmnopqrstuvwxyz" if f'"{letter}"' not in text]
    assert free
    anew, keys = '"command-anew", "keys": []', ", ".join(f'"{letter}"' for letter in free)
    assert anew in text
    table.write_text(text.replace(anew, f'"command-anew", "keys": [{keys}]'), encoding="utf-8")
    page = tmp_path / "tests" / "page"
    words, keys_test = f"--import={(page / 'words.mjs').as_uri()}", page / "keys.test.mjs"
    tried = subprocess.run([NODE, words, "--test", keys_test], capture_output=True, text=True, check=False)
    assert tried.returncode == 0, tried.stdout
