"""Modules of a script as one script: for a page that fetches few, a file that fetches none, or to be read.

It knows the forms of import and export that softrod's own modules use, and refuses others; it is no bundler
for scripts in general.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path

from .conditional import needed_lines

_NAMED = re.compile(r'^import \{([\w\s,]+)\} from "(\.[\w./-]+)";$', re.MULTILINE)
_WHOLE = re.compile(r'^import \* as (\w+) from "(\.[\w./-]+)";$', re.MULTILINE)
_DEFAULT = re.compile(r'^import (\w+) from "(\.[\w./-]+)";$', re.MULTILINE)
_LATER = re.compile(r'\bimport\("(\.[\w./-]+)"\)')
_AS = re.compile(r"(\w+) as (\w+)")
_EXPORT = re.compile(r"^export ((?:async )?function|const|class) (\w+)", re.MULTILINE)
_EXPORT_DEFAULT = re.compile(r"^export default ", re.MULTILINE)
_PRIVATE = re.compile(r"(?<=\.)#(?=[a-z])|^([ \t]*(?:(?:static|async|get|set) )*)#(?=[a-z])", re.MULTILINE)
_PLACE = re.compile(r"\bimport\.meta\.url\b")
_COMMENT = re.compile(r"[ \t]*/\*\*.*?\*/\n?|^[ \t]*//[^\n]*\n", re.DOTALL | re.MULTILINE)
_STYLE_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_SELECTORS = re.compile(r"(?<=[{};])[^{};@]*:is\([^{};]*(?=\{)|^[^{};@]*:is\([^{};]*(?=\{)")
_INDENT = re.compile(r"\n\s+")
_LEFT = re.compile(r"^(import|export)\b.*", re.MULTILINE)
_TYPE = re.compile(r'^ \* @typedef \{import\("\./[\w.]+"\)\.(\w+)\} \1\n', re.MULTILINE)
_HEAD = re.compile(r"^// @ts-check\n", re.MULTILINE)
_BLANK = re.compile(r"\n \*(?=\n \*/)")
_TOP = re.compile(
    r"^(?:async )?(?:const|let|class|function) (\w+|\[[\w, ]+\])|@typedef .*\} (\w+)", re.MULTILINE
)


class BundleError(ValueError):
    """A module has a form that is not known here."""


def bundle(start: Path, has: Mapping[str, bool] | None = None) -> str:
    """A module and all that it imports, as the text of one module without comments and indentation.

    Each of them becomes a function that returns what it exports. A module's own address is where it would be
    beside the first one. Private names of classes become ordinary ones, for browsers that do not know those.

    Args:
        start: the module.
        has: what is needed of the modules, see `app.conditional`; all if it is None.

    Raises:
        BundleError: a module imports or exports in another form, two import each other, or one loads another
            later.
    """
    text, *later = _bundles(start.resolve(), has).values()
    if later:
        raise BundleError(f"{start}: a script that is alone cannot load others later")
    return text


def bundles(start: Path) -> dict[Path, str]:
    """The same for a page that loads some modules later: by `import("./module.js")`, where it needs them.

    Returns:
        the texts by the paths of their modules: first that of the start, then those of what is loaded later,
        with all that only they import. They import the rest from the first, so each module is there once.

    Raises:
        BundleError: see `bundle`; or two that are loaded later import the same one, which the first does not.
    """
    return _bundles(start.resolve(), None)


def _bundles(start: Path, has: Mapping[str, bool] | None) -> dict[Path, str]:
    first = _Bundle(start, has)
    later = [_Bundle(path, has, first) for path in first.later]
    if any(one.later for one in later):
        raise BundleError(f"{start}: what is loaded later cannot load others")
    alone = [path for one in later for path in one.own]
    for path in alone:
        if alone.count(path) > 1:
            raise BundleError(f"{path}: several that are loaded later import it; the first one does not")
    return {one.start: one.text() for one in (first, *later)}


class _Bundle:
    """The modules that one imports, each once, after those that it needs.

    Args:
        start: the module.
        has: what is needed of them.
        first: what is loaded before; its modules are imported from there.

    Attributes:
        start: as above.
        later: the modules that are loaded later.
        own: the modules that are here.
    """

    def __init__(self, start: Path, has: Mapping[str, bool] | None, first: _Bundle | None = None) -> None:
        if first is not None and start in first.own:
            raise BundleError(f"{start}: it is loaded later, and imported at once")
        self.start, self.later, self.own = start, dict[Path, None](), {start}
        self._has, self._first = has, first
        self._names = {**(first._names if first else {}), start: "exported_by_none"}
        self._parts: dict[str, str] = {}
        self._taken: set[str] = set()
        self._given: set[str] = set()
        self._body, self._exported = self._included(start)

    def text(self) -> str:
        parts = [*self._parts.values(), self._body]
        if self._first is not None:
            parts.insert(
                0, f'import {{ {", ".join(sorted(self._taken))} }} from "{self._way(self._first.start)}";'
            )
            exported = (re.sub(r"(\w+): (\w+)", r"\2 as \1", name) for name in self._exported)
            parts.append(f"export {{ {', '.join(exported)} }};")
        elif self._given:
            parts.append(f"export {{ {', '.join(sorted(self._given))} }};")
        return _INDENT.sub("\n", "\n".join(parts))

    def _way(self, path: Path) -> str:
        """The relative address of a module."""
        way = Path(os.path.relpath(path, self.start.parent)).as_posix()
        return way if way.startswith(".") else f"./{way}"

    def _name(self, path: Path) -> str:
        """The variable that holds what a module exports; it is defined where it returns."""
        name = self._names.get(path)
        if self._first is not None and path in self._first.own - {self._first.start}:
            name = self._names[path]
            self._taken.add(name)
            self._first._given.add(name)
        elif name is None:
            plain = f"module_{path.stem}"
            same = sum(path.stem == other.stem for other in self._names)
            name = self._names[path] = f"{plain}_{same + 1}" if same else plain
            self.own.add(path)
            body, exported = self._included(path)
            self._parts[name] = (
                f"const {name} = (() => {{\n{body}\nreturn {{ {', '.join(exported)} }};\n}})();"
            )
        elif name not in self._parts:
            raise BundleError(f"{path}: it imports a module that imports it")
        return name

    def _included(self, path: Path) -> tuple[str, list[str]]:
        """The text of a module without its imports and exports, and what it exports."""
        text = _PRIVATE.sub(r"\1$", _COMMENT.sub("", _needed(path, self._has)))
        if any(line.replace(r"\`", "").count("`") % 2 for line in text.splitlines()):
            raise BundleError(f"{path}: a template of several lines is not known to the bundler")

        def other(where: str) -> str:
            return self._name((path.parent / where).resolve())

        def loaded(match: re.Match[str]) -> str:
            target = (path.parent / match[1]).resolve()
            self.later[target] = None
            return f'import("{self._way(target)}")'

        text = _LATER.sub(loaded, text)
        text = _NAMED.sub(
            lambda match: "const {" + _AS.sub(r"\1: \2", match[1]) + f"}} = {other(match[2])};", text
        )
        text = _WHOLE.sub(lambda match: f"const {match[1]} = {other(match[2])};", text)
        text = _DEFAULT.sub(lambda match: f"const {match[1]} = {other(match[2])}.default;", text)
        exported = [match[2] for match in _EXPORT.finditer(text)]
        text = _EXPORT.sub(r"\1 \2", text)
        if _EXPORT_DEFAULT.search(text):
            text = _EXPORT_DEFAULT.sub("const exported_ = ", text)
            exported.append("default: exported_")
        if left := _LEFT.search(text):
            raise BundleError(f"{path}: {left[0]!r} is not known to the bundler")
        place = Path(os.path.relpath(path, self.start.parent)).as_posix()
        return _PLACE.sub(f'new URL("{place}", import.meta.url).href', text), exported


def _needed(path: Path, has: Mapping[str, bool] | None) -> str:
    """The text of a module, or what is needed of it."""
    text = path.read_text(encoding="utf-8")
    return text if has is None else "\n".join((*needed_lines(text, has), ""))


def compact_style(*paths: Path) -> str:
    """The text of style sheets without comments and indentation."""
    text = "\n".join(path.read_text(encoding="utf-8") for path in paths)
    return _INDENT.sub("\n", _STYLE_COMMENT.sub("", text))


def without_is(style: str) -> str:
    """Style rules with their `:is()` written out, for browsers that do not know it."""
    return _SELECTORS.sub(lambda match: ", ".join(map(str.strip, _written_out(match[0]))) + " ", style)


def _written_out(selectors: str) -> list[str]:
    """The selectors of a list, none of which has an `:is()`."""
    found: list[str] = []
    for selector in _split(selectors):
        begin = selector.find(":is(")
        if begin < 0:
            found.append(selector)
            continue
        end, depth = begin + len(":is("), 1
        while depth:
            depth += {"(": 1, ")": -1}.get(selector[end], 0)
            end += 1
        for choice in _split(selector[begin + len(":is(") : end - 1]):
            found += _written_out(selector[:begin] + choice.strip() + selector[end:])
    return found


def _split(selectors: str) -> list[str]:
    """The selectors of a list, by the commas that are in no brackets."""
    parts, depth = [""], 0
    for letter in selectors:
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return parts


def joined(start: Path, has: Mapping[str, bool]) -> str:
    """A module and all that it imports, as the text of one module to be read: with comments and their types.

    It exports what the first one does.

    Args:
        start: the module.
        has: what is needed of the modules, see `app.conditional`.

    Raises:
        BundleError: a module imports or exports in another form, or two have the same name at their top.
    """
    parts: dict[Path, str] = {}
    start = start.resolve()
    _join(start, has, parts)
    parts = {path: _EXPORT.sub(r"\1 \2", text) if path != start else text for path, text in parts.items()}
    text = "\n".join(parts.values())
    if left := re.search(r'^import\b.*|.*\bimport\(".*', text, re.MULTILINE):
        raise BundleError(f"{start}: {left[0]!r} is not known to the bundler")
    plain = _EXPORT.sub(r"\1 \2", text)
    names = [name for match in _TOP.finditer(plain) for name in re.findall(r"\w+", match[1] or match[2])]
    if twice := {name for name in names if names.count(name) > 1}:
        raise BundleError(f"{start}: more than one module has {', '.join(sorted(twice))}")
    return re.sub(r"\n{3,}", "\n\n", text)


def _join(path: Path, has: Mapping[str, bool], parts: dict[Path, str]) -> None:
    """Adds the text of a module without its imports, after all that it needs."""
    text = _HEAD.sub("", _needed(path, has))
    for match in _NAMED.finditer(text):
        other = (path.parent / match[2]).resolve()
        if other not in parts:
            _join(other, has, parts)
    parts[path] = _BLANK.sub("", _TYPE.sub("", _NAMED.sub("", text))).strip() + "\n"
