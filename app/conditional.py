"""Texts of which only some lines are needed: templates of programs, and scripts of files.

`# ifdef NAME`, `# else` and `# endif` on lines of their own are directives; in scripts `// ifdef NAME`,
`// else` and `// endif`. They are those of the preprocessor in C, and comments in the other languages, so a
compiler and a linter read the texts as they are.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

_DIRECTIVE = re.compile(r" *(?:\* )?(?:#|//) (?P<word>ifdef (?P<asked>\w+)|else|endif)")


def needed_lines(text: str, has: Mapping[str, bool]) -> list[str]:
    """The lines of a text that are needed.

    Args:
        text: with directives.
        has: whether each NAME is needed.

    Raises:
        KeyError: a directive asks for a name that `has` lacks.
    """
    lines, shown = [], [True]
    for line in text.splitlines():
        match = _DIRECTIVE.fullmatch(line)
        if match is None:
            lines += [line] * all(shown)
        elif match["asked"]:
            shown.append(has[match["asked"]])
        elif match["word"] == "else":
            shown.append(not shown.pop())
        else:
            shown.pop()
    return lines
