"""A GLB file, which is glTF 2.0 in one piece: a tree in JSON, and the arrays that it names."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..stage.sketch import Floats

FLOAT, UINT = 5126, 5125
"""Types of components, as glTF numbers them."""

_KINDS = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}
_VERTICES, _INDICES = 34962, 34963


class GlbFile:
    """Collects what a file has; everything is named by its index.

    Attributes:
        tree: the JSON object, for what has no method here.
    """

    def __init__(self) -> None:
        self.tree: dict[str, Any] = {"asset": {"version": "2.0", "generator": "softrod"}}
        self._data = bytearray()

    def add(self, kind: str, **fields: Any) -> int:
        """Another object of a kind, such as `nodes`."""
        every = self.tree.setdefault(kind, [])
        every.append(fields)
        return len(every) - 1

    def geometry(self, vertices: Floats, faces: NDArray[np.int64], normals: Floats) -> dict[str, Any]:
        """The attributes and indices of a mesh, which primitives may share.

        Args:
            vertices, normals: (k, 3).
            faces: (m, 3).
        """
        attributes = {
            "POSITION": self.array(vertices, bounds=True, target=_VERTICES),
            "NORMAL": self.array(normals, target=_VERTICES),
        }
        indices = self.array(faces.reshape(-1, 1), UINT, target=_INDICES)
        return {"attributes": attributes, "indices": indices}

    def array(self, rows: NDArray[Any], kind: int = FLOAT, bounds: bool = False, target: int = 0) -> int:
        """The accessor of (k, n) numbers.

        Args:
            rows: as many numbers as a type of glTF has.
            kind: of components.
            bounds: whether their least and greatest stand in the file.
            target: what they are for, where that is a mesh.
        """
        data = np.ascontiguousarray(rows, np.dtype("<f4") if kind == FLOAT else np.dtype("<u4"))
        view = {"buffer": 0, "byteOffset": len(self._data), "byteLength": data.nbytes}
        self._data += data.tobytes()
        number = self.add("bufferViews", **view, **({"target": target} if target else {}))
        fields: dict[str, Any] = {"bufferView": number, "componentType": kind, "count": len(data)}
        if bounds:
            fields |= {"min": data.min(0).tolist(), "max": data.max(0).tolist()}
        return self.add("accessors", **fields, type=_KINDS[data.shape[1]])

    def bytes(self) -> bytes:
        """The file."""
        self.tree["buffers"] = [{"byteLength": len(self._data)}]
        text = json.dumps(self.tree, allow_nan=False, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = b"".join(
            len(chunk).to_bytes(4, "little") + name + chunk
            for name, chunk in ((b"JSON", text), (b"BIN\0", bytes(self._data)))
        )
        return b"glTF" + (2).to_bytes(4, "little") + (12 + len(chunks)).to_bytes(4, "little") + chunks
