"""Who is compared. A module or class of an engine has

- `NAME`: for people, and for `--engines`;
- `missing()`: why it cannot be asked here, or nothing;
- `ladders(name)`: what it does with a scene of `scenes`; none where it cannot do it.
"""

from __future__ import annotations

import importlib
import importlib.util
from typing import Any


def lacking(*packages: str) -> str:
    """Which of some packages are not installed, as a sentence; empty where all are."""
    absent = [name for name in packages if importlib.util.find_spec(name) is None]
    return f"{' and '.join(absent)} {'is' if len(absent) == 1 else 'are'} not installed" if absent else ""


def package(name: str) -> Any:
    """A package of the extra `peers`, which may not be there when types are checked."""
    return importlib.import_module(name)
