"""Writes what is made from the messages and commands in `app/wire`, and from the words in `app/words/en`.

`uv run python -m tests.page.generate` writes the types and the table of commands that the page's script has,
the keys of all texts, and the lists in the documents. A test says when they are old.
"""

from __future__ import annotations

import inspect
import json
import re
from pathlib import Path
from typing import Any

from fluent.syntax import ast
from fluent.syntax.visitor import Visitor
from msgspec import inspect as types_of

from app.pages.sandbox.features import COMMANDS, FEATURES
from app.pages.sandbox.requests import OWN_TEXTS
from app.ui.commands import key_lines, key_of, text_of
from app.ui.feature import Feature
from app.wire.messages import Event, FromPage, Numbers, State, ToPage, messages
from app.wire.sections import Section
from app.words import ENGLISH, entries

COMMAND = "uv run python -m tests.page.generate"
ROOT = Path(__file__).parents[2]
WIRE, PAGE = ROOT / "app" / "wire", ROOT / "app" / "pages" / "sandbox"
WORDS = ROOT / "app" / "words"
LETTERS = {"Space": " ", "Esc": "Escape"}
"""Keys that a browser calls otherwise than the help."""


def typescript(kind: types_of.Type) -> str:
    """A type as TypeScript writes it."""
    match kind:
        case types_of.StructType(cls):
            return cls.__name__
        case types_of.Metadata(inner, extra=extra):
            return extra["typescript"] if extra and "typescript" in extra else typescript(inner)
        case types_of.LiteralType(values):
            return " | ".join(map(json.dumps, values))
        case types_of.UnionType(types):
            return " | ".join(map(typescript, types))
        case types_of.VarTupleType(item):
            inner = typescript(item)
            return f"({inner})[]" if " " in inner and not inner.startswith("[") else f"{inner}[]"
        case types_of.TupleType(items):
            return f"[{', '.join(map(typescript, items))}]"
        case types_of.DictType(key, value):
            return f"Record<{typescript(key)}, {typescript(value)}>"
    names: dict[type, str] = {
        types_of.IntType: "number", types_of.FloatType: "number", types_of.StrType: "string",
        types_of.BoolType: "boolean", types_of.NoneType: "null", types_of.CustomType: "Float32Array",
    }  # fmt: skip
    return names[type(kind)]


def declared(kind: type, says: bool) -> str:
    """The type of a message, or of what is in one; fields with defaults need not be said by a page."""
    info: Any = types_of.type_info(kind)
    fields = [f"{info.tag_field}: {json.dumps(info.tag)}"] if info.tag_field else []
    for field in info.fields:
        optional = not field.required and (says or kind.__struct_config__.omit_defaults)  # type: ignore[attr-defined]
        fields.append(f"{field.encode_name}{'?' if optional else ''}: {typescript(field.type)}")
    return f"/** {first_sentence(kind)} */\nexport type {kind.__name__} = {{ {'; '.join(fields)} }};"


def first_sentence(kind: type) -> str:
    """The first paragraph of a class's docstring, on one line."""
    return " ".join((kind.__doc__ or "").split("\n\n")[0].split())


def parts_of(kinds: list[type]) -> list[type]:
    """The structures that are inside of some messages, and are none themselves."""
    found: dict[type, None] = {}

    def look(kind: types_of.Type) -> None:
        if isinstance(kind, types_of.StructType):
            if kind.cls not in kinds:
                found[kind.cls] = None
            for field in kind.fields:
                look(field.type)
        for name in ("types", "item_types"):
            for inner in getattr(kind, name, ()):
                look(inner)
        if inner := getattr(kind, "item_type", None):
            look(inner)

    for kind in kinds:
        look(types_of.type_info(kind))
    return list(found)


def types() -> str:
    """wire.d.ts."""
    says, tells = messages(FromPage), messages(ToPage)
    tables = {name_of(feature): feature.commands for feature in FEATURES}
    page = {of: [name for name, row in table.items() if row.does == "page"] for of, table in tables.items()}
    texts = [*OWN_TEXTS, *(kind for feature in FEATURES for kind in feature.texts)]
    commands = "; ".join(
        f"{of}: {' | '.join(map(json.dumps, names)) or 'never'}" for of, names in page.items()
    )
    received = "; ".join(f"{kind.__struct_config__.tag}: {kind.__name__}" for kind in tells)
    lines = [
        f"// Made by `{COMMAND}` from app/wire.",
        f"export type CommandName = {' | '.join(map(json.dumps, COMMANDS))};",
        "/** Texts that are too long for one message. */",
        f"export type TextKind = {' | '.join(map(json.dumps, texts))};",
        "/** Commands that the page's script does, by the features that they belong to. */",
        f"export type PageCommands = {{ {commands} }};",
        *(declared(kind, says=False) for kind in parts_of([*says, *tells])),
        *(declared(kind, says=True) for kind in says),
        f"export type FromPage = {' | '.join(kind.__name__ for kind in says)};",
        *(declared(kind, says=False) for kind in tells),
        f"export type ToPage = {' | '.join(kind.__name__ for kind in tells)};",
        *layout_types(),
        "/** Messages to the page, by their tags. */",
        f"export type Received = {{ {received} }};",
    ]
    return "\n".join(lines) + "\n"


def camel(name: str) -> str:
    """A name as the script has it: rest_length is restLength."""
    return re.sub(r"_(.)", lambda found: found[1].upper(), name)


def layouts() -> dict[str, tuple[Section, ...]]:
    """The sections of all arrays of numbers, by the tags of their messages."""
    kinds = messages(Numbers)
    return {str(kind.__struct_config__.tag): kind.sections for kind in kinds if kind.sections}  # type: ignore[attr-defined]


def layout_types() -> list[str]:
    """The types of arrays of numbers, for wire.d.ts."""
    lines = ["/** What is in arrays of numbers, by the tags of their messages. */", "export type Layouts = {"]
    for tag, sections in layouts().items():
        lines.append(f"  {tag}: {{")
        for section in sections:
            for name, doc in section.numbers.items():
                kind = "boolean" if name.endswith("?") else "number"
                lines.append(f"    /** {doc} */ {camel(name.rstrip('?'))}: {kind};")
            if not section.numbers:
                lines.append(f"    /** {section.doc} */ {camel(section.name)}: Float32Array;")
        lines.append("  };")
    return [*lines, "};"]


def layout_table() -> str:
    """layouts.js."""
    tables = {
        tag: [[camel(name) for name in section.numbers] or camel(section.name) for section in sections]
        for tag, sections in layouts().items()
    }
    rows = [f"  {tag}: {json.dumps(table)}," for tag, table in tables.items()]
    return "\n".join(
        (
            "// @ts-check",
            f"/** The sections of arrays of numbers. Made by `{COMMAND}` from the messages. */",
            "",
            "/**",
            ' * By the tags of messages: names of sections, or of the numbers of one; flags end in "?".',
            " *",
            ' * @type {Record<keyof import("./wire.js").Layouts, (string | string[])[]>}',
            " */",
            "export const LAYOUTS = {",
            *rows,
            "};",
            "",
        )
    )


def table() -> str:
    """commands.js."""
    rows = []
    for name, row in COMMANDS.items():
        fields = {
            "label": key_of(name),
            **{part: key_of(name, part) for part in ("word", "hint") if text_of(name, part)},
            "keys": [key_name(key) for key in row.keys],
            "shown": row.keys[0] if row.keys else "",
            "needs": row.needs,
            "icon": row.icon,
            "where": row.where,
            "page": row.does == "page",
        }
        kept = {key: value for key, value in fields.items() if value or key in ("label", "keys")}
        rows.append(f"  {name}: {json.dumps(kept, ensure_ascii=False)},")
    return "\n".join(
        (
            "// @ts-check",
            f"/** The table of commands. Made by `{COMMAND}` from the features. */",
            "",
            "/**",
            ' * @typedef {import("../words/keys.js").Plain} Key of a text',
            " *",
            " * @typedef {object} Row see app/ui/commands.py",
            " * @property {Key} label",
            " * @property {Key} [word]",
            " * @property {Key} [hint]",
            ' * @property {string[]} keys as `pressed` in key_table.js has them: "ctrl shift z"',
            " * @property {string} [shown] the first of them, as it is shown",
            " * @property {string} [needs]",
            " * @property {string} [icon]",
            " * @property {string} [where]",
            " * @property {boolean} [page] whether the page's script does it",
            " */",
            '/** @type {Record<import("./wire.js").CommandName, Row>} */',
            "export const COMMANDS = {",
            *rows,
            "};",
            "",
        )
    )


def name_of(feature: type[Feature]) -> str:
    """The name of a feature: that of its folder."""
    return feature.__module__.split(".")[-2]


def features() -> str:
    """features.js."""
    scripts = (Path(inspect.getfile(feature)).with_name(f"{name_of(feature)}.js") for feature in FEATURES)
    names = [script.stem for script in scripts if script.exists()]
    return "\n".join(
        (
            "// @ts-check",
            f"/** The features of the page. Made by `{COMMAND}` from app/pages/sandbox/features.py. */",
            *(f'import {name} from "../../features/{name}/{name}.js";' for name in names),
            "",
            f"export const FEATURES = [{', '.join(names)}];",
            "",
        )
    )


def key_name(key: str) -> str:
    """A key as the script calls it."""
    *modifiers, letter = key.split(" ")
    letter = LETTERS.get(letter, letter.lower() if len(letter) == 1 else letter)
    return " ".join((*map(str.lower, modifiers), letter))


def keys_list() -> str:
    """The keys, for docs/using.md."""
    return "\n".join(
        ("| key | |", "|---|---|", *(f"| {keys} | {what} |" for keys, what in key_lines(COMMANDS)))
    )


class _Places(Visitor):
    """Finds the places of a message, each with its name."""

    def __init__(self) -> None:
        self.names: dict[str, None] = {}

    def visit_VariableReference(self, node: ast.VariableReference) -> None:
        self.names[node.id.name] = None


def places(pattern: ast.Pattern) -> list[str]:
    """The names of what stands in a text's places."""
    found = _Places()
    found.visit(pattern)
    return list(found.names)


def texts() -> dict[str, list[str]]:
    """All texts that are said, by their keys, and the names of their places."""
    found = {}
    for name, entry in entries(ENGLISH).items():
        if entry.value is not None:
            found[name] = places(entry.value)
        for attribute in entry.attributes:
            found[f"{name}.{attribute.id.name}"] = places(attribute.value)
    return found


def keys_for_python() -> str:
    """keys.py."""
    rows = (f"    {json.dumps(key)}," for key in texts())
    return "\n".join(
        (
            f'"""The keys of all texts. Made by `{COMMAND}` from app/words/en."""',
            "",
            "from typing import Literal",
            "",
            "Key = Literal[",
            *rows,
            "]",
            "",
        )
    )


def keys_for_script() -> str:
    """keys.d.ts."""
    rows = (
        f"  {json.dumps(key)}: {' | '.join(map(json.dumps, names)) or 'never'};"
        for key, names in texts().items()
    )
    return "\n".join(
        (
            f"// Made by `{COMMAND}` from app/words/en.",
            "/** The keys of all texts, and the names of their places. */",
            "export type Words = {",
            *rows,
            "};",
            "/** The keys of texts in which nothing has to be put. */",
            "export type Plain = { [K in keyof Words]: Words[K] extends never ? K : never }[keyof Words];",
            "",
        )
    )


def messages_list() -> str:
    """All messages, for docs/wire.md."""
    return "\n\n".join(
        f"### {title}\n\n| | |\n|---|---|\n"
        + "\n".join(f"| `{kind.__struct_config__.tag}` | {first_sentence(kind)} |" for kind in kinds)
        for title, kinds in (
            ("From the page", messages(FromPage)),
            ("States sent to the page", messages(State)),
            ("Numbers sent to the page", messages(Numbers)),
            ("Events sent to the page", messages(Event)),
        )
    )


def between(path: Path, name: str, text: str) -> str:
    """A document with another text between the marks of that name."""
    begin, end = f"<!-- {name}: {COMMAND} -->\n", f"\n<!-- end of {name} -->"
    old = path.read_text(encoding="utf-8")
    assert begin in old and end in old, f"{path.name} has no place for {name}"
    return re.sub(f"(?s){re.escape(begin)}.*{re.escape(end)}", lambda _: begin + text + end, old)


def files() -> dict[Path, str]:
    """All that is made, and what is in it."""
    using, wire = ROOT / "docs" / "using.md", ROOT / "docs" / "wire.md"
    return {
        WIRE / "wire.d.ts": types(),
        WIRE / "commands.js": table(),
        WIRE / "layouts.js": layout_table(),
        PAGE / "features.js": features(),
        WORDS / "keys.py": keys_for_python(),
        WORDS / "keys.d.ts": keys_for_script(),
        using: between(using, "keys", keys_list()),
        wire: between(wire, "messages", messages_list()),
    }


def main() -> None:
    """Write them."""
    for path, text in files().items():
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
