"""The JSON Schema of scene files, generated from the types. `python -m sim.store.schema` writes it."""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import Any

import msgspec

from ..scene.types import FORMAT_VERSION, Scene
from .files import write_atomically

SCHEMA_PATH = Path(__file__).parents[2] / "schema" / f"scene-{FORMAT_VERSION}.schema.json"
"""The file to which the schema is written."""


def schema() -> dict[str, Any]:
    """Return the schema (draft 2020-12) that every scene file of this format satisfies.

    It covers types and ranges. References between parts (does spring 17 exist?) are checked by softrod only.
    """
    body = msgspec.json.schema(Scene)
    for definition in body["$defs"].values():
        definition["description"] = inspect.cleandoc(definition["description"])
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"softrod scene, format {FORMAT_VERSION}",
        **body,
    }


def schema_bytes() -> bytes:
    """Return the contents of the schema file."""
    return msgspec.json.format(msgspec.json.encode(schema()), indent=2) + b"\n"


if __name__ == "__main__":
    SCHEMA_PATH.parent.mkdir(exist_ok=True)
    write_atomically(SCHEMA_PATH, schema_bytes())
    print(f"wrote {SCHEMA_PATH}")
