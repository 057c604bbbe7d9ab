"""Writes the constraints of pyproject.toml anew: the newest versions within the bounds of its dependencies.

Run it as `uv run python tests/constrain.py`, then `uv sync` and all tests.
"""

from __future__ import annotations

import re
import subprocess
import tempfile
import tomllib
from pathlib import Path

PYPROJECT = Path(__file__).parents[1] / "pyproject.toml"
EDITABLE = "editables"
"""What hatchling asks for beyond its own dependencies, to install a checkout."""


def rewritten(text: str, key: str, lines: list[str]) -> str:
    """The text of pyproject.toml with other lines in one of its lists."""
    listed = "".join(f'    "{line}",\n' for line in lines)
    content = f"{key} = [\n{listed}]" if lines else f"{key} = []"
    text, count = re.subn(
        rf"^{key} = \[(?:\n.*?^)?\]", lambda _: content, text, flags=re.MULTILINE | re.DOTALL
    )
    assert count == 1, f"pyproject.toml has no list {key}"
    return text


def resolved(folder: Path, *words: str, of: str | None = None) -> list[str]:
    """The lines "name==version ; marker" that a command of uv prints."""
    out = subprocess.run(
        ["uv", *words, "--quiet", "--no-header", "--no-annotate"],
        cwd=folder, input=of, stdout=subprocess.PIPE, text=True, check=True,
    ).stdout  # fmt: skip
    return [re.sub(r"\s*;\s*", "; ", line.strip()) for line in out.splitlines() if "==" in line]


def main() -> None:
    text = PYPROJECT.read_text(encoding="utf-8")
    build = [*tomllib.loads(text)["build-system"]["requires"], EDITABLE]
    # In a folder of its own, where neither old constraints nor a lock file hold anything back.
    for key in ("constraint-dependencies", "build-constraint-dependencies"):
        text = rewritten(text, key, [])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "pyproject.toml").write_text(text, encoding="utf-8")
        every = ("--all-extras", "--all-groups", "--no-emit-project", "--no-hashes")
        text = rewritten(text, "constraint-dependencies", resolved(folder, "export", *every))
        lines = resolved(
            folder, "pip", "compile", "--universal", "--python-version", "3.11", "-", of="\n".join(build)
        )
        text = rewritten(text, "build-constraint-dependencies", lines)
    PYPROJECT.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
