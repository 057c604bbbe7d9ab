"""A page as a screen reader has it: the accessibility tree, what live regions say, and keys.

Nothing here knows of selectors, of places on the screen or of what is drawn.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any, TypeVar

from playwright.sync_api import Error, Page

T = TypeVar("T")

LIMIT = 60.0
"""Seconds after which something is given up that should be heard."""

_NAMED = ("button", "image", "link", "slider", "spinbutton", "textbox", "combobox", "DisclosureTriangle")
"""Roles whose names are read, and not what is inside."""

_CLICK = {"functionDeclaration": "function () { this.click() }", "userGesture": True}


@dataclass(eq=False)
class Node:
    """One node of the tree.

    Attributes:
        role: as ARIA calls it.
        name: what it is called.
        value: of a slider or a text field: as it is said, with its unit.
        about: the description that is read after the name.
        states: such as `pressed`, `expanded`, `checked`, `disabled`, `focused`, by their names.
        children: in the order of reading.
        parent: None for the page.
        id: by which it is acted upon.
    """

    role: str
    name: str
    value: str
    about: str
    states: dict[str, Any]
    id: int
    parent: Node | None = None
    children: list[Node] = field(default_factory=list)

    def __iter__(self) -> Iterator[Node]:
        """This node and all below it, in the order of reading."""
        yield self
        for child in self.children:
            yield from child

    @property
    def text(self) -> str:
        """All words in it, as they are read."""
        return re.sub(r"\s+", " ", " ".join(self.words())).strip() or self.name

    def words(self) -> Iterator[str]:
        """The words in it, piece by piece."""
        for child in self.children:
            if child.role == "StaticText" or child.role in _NAMED:
                yield f"{child.name} {child.value}" if child.value else child.name
            else:
                yield from child.words()

    def find(self, role: str, name: str | re.Pattern[str] = "") -> Node | None:
        """The first node below it with a role, and a name that is the same or matches."""
        return next((node for node in self if node.role == role and _fits(node.name, name)), None)

    def all(self, role: str) -> list[Node]:
        """All nodes below it with a role."""
        return [node for node in self if node.role == role]


def _fits(name: str, wanted: str | re.Pattern[str]) -> bool:
    return bool(wanted.search(name)) if isinstance(wanted, re.Pattern) else wanted in ("", name)


class Ear:
    """Somebody who uses a page by what is read to them.

    Attributes:
        heard: what live regions have said, in order.
    """

    def __init__(self, page: Page) -> None:
        self._wire = page.context.new_cdp_session(page)
        self._keys = page.keyboard
        self._wait = page.wait_for_timeout
        self._wire.send("Accessibility.enable")
        self._said: dict[int, str] = {}
        self.heard: list[str] = []
        self.look()
        self.heard.clear()

    # --------------------------------------------------------------------- what is there
    def look(self) -> Node:
        """The tree as it is now; what live regions say anew is heard."""
        raw = self._wire.send("Accessibility.getFullAXTree")["nodes"]
        known = {each["nodeId"]: each for each in raw}
        root = self._built(known, raw[0], None)[0]
        self._listen(root)
        return root

    def _built(self, known: dict[str, Any], raw: Any, parent: Node | None) -> list[Node]:
        children = [known[child] for child in raw.get("childIds", ()) if child in known]
        if raw.get("ignored") and parent is not None:
            return [node for child in children for node in self._built(known, child, parent)]
        states = {each["name"]: each["value"].get("value") for each in raw.get("properties", ())}
        value = raw.get("value", {}).get("value", "")
        node = Node(
            raw.get("role", {}).get("value", ""),
            # The space that keeps a number at its unit is read as any other.
            str(raw.get("name", {}).get("value", "")).replace("\u00a0", " "),
            str(states.get("valuetext") or value).replace("\u00a0", " "),
            str(raw.get("description", {}).get("value", "")),
            states,
            raw.get("backendDOMNodeId", 0),
            parent,
        )
        node.children = [one for child in children for one in self._built(known, child, node)]
        return [node]

    def _listen(self, root: Node) -> None:
        said: dict[int, str] = {}
        for node in root:
            if node.states.get("live") in ("polite", "assertive"):
                above = node.parent
                if above is not None and above.id in said:
                    continue
                # Words that are said again end with a space that does not break.
                said[node.id] = " ".join(node.words())
        for each, text in said.items():
            if text and text != self._said.get(each, ""):
                self.heard.append(re.sub(r"\s+", " ", text).strip())
        self._said = said

    def until(self, condition: Callable[[Node], T | None], what: str, limit: float = LIMIT) -> T:
        """Wait until something holds of the tree, and return it."""
        end = time.monotonic() + limit
        while True:
            found = condition(self.look())
            if found:
                return found
            if time.monotonic() > end:
                tree, last = outline(self.look()), self.heard[-5:]
                raise AssertionError(f"in {limit:g} s it did not come to this: {what}\n{tree}\nheard: {last}")
            self._wait(30.0)

    def find(self, role: str, name: str | re.Pattern[str] = "", limit: float = LIMIT) -> Node:
        """Wait for a node with a role and a name."""
        return self.until(lambda root: root.find(role, name), f"{role} {name!r}", limit)

    def hears(self, words: str, limit: float = LIMIT) -> str:
        """Wait until a live region says some words; return what it says, and forget what was before."""

        def found(_: Node) -> str:
            return next((text for text in self.heard if words in text), "")

        told = self.until(found, f"heard {words!r}", limit)
        del self.heard[: self.heard.index(told) + 1]
        return told

    def focused_in(self, root: Node) -> Node:
        """What has the focus in a tree; the page, if nothing else has."""
        return next((node for node in reversed(list(root)) if node.states.get("focused")), root)

    @property
    def focused(self) -> Node:
        """What has the focus."""
        return self.focused_in(self.look())

    def value(self, node: Node) -> str:
        """The value of a slider as it is said; Chromium's tree has it as a number alone."""
        told = self._wire.send("DOM.describeNode", {"backendNodeId": node.id})["node"].get("attributes", [])
        return dict(zip(told[::2], told[1::2], strict=True)).get("aria-valuetext", node.value)

    # --------------------------------------------------------------------- what is done
    def press(
        self,
        role: str,
        name: str | re.Pattern[str] = "",
        within: Callable[[Node], Node | None] = lambda root: root,
    ) -> None:
        """Have the screen reader activate a node: it gets the focus, and is clicked."""

        def done(root: Node) -> bool:
            place = within(root)
            node = place and place.find(role, name)
            if not node or node.states.get("disabled"):
                return False
            try:
                self.focus(node)
                found = self._wire.send("DOM.resolveNode", {"backendNodeId": node.id})
                self._wire.send("Runtime.callFunctionOn", {**_CLICK, "objectId": found["object"]["objectId"]})
            except Error:
                return False  # it was made anew meanwhile
            return True

        self.until(done, f"{role} {name!r} can be pressed")

    def focus(self, node: Node) -> None:
        """Give a node the focus, if it takes it."""
        if node.states.get("focusable"):
            self._wire.send("DOM.focus", {"backendNodeId": node.id})

    def key(self, *keys: str) -> None:
        """Press keys one after the other."""
        for key in keys:
            self._keys.press(key)

    def type(self, text: str) -> None:
        """Type a text."""
        self._keys.type(text)

    def tab_to(self, role: str, name: str | re.Pattern[str] = "", back: bool = False, most: int = 90) -> Node:
        """Press Tab until a node with that role and name has the focus."""
        for _ in range(most):
            self.key("Shift+Tab" if back else "Tab")
            node = self.focused
            if node.role == role and _fits(node.name, name):
                return node
        raise AssertionError(f"{role} {name!r} is not reached with the Tab key")


def outline(node: Node, depth: int = 0) -> str:
    """A tree as lines, for whoever reads why a test failed."""
    states = {
        key: value
        for key, value in node.states.items()
        if key
        in ("pressed", "expanded", "checked", "disabled", "focused", "selected", "live", "level", "modal")
        and value not in (False, "false")
    }
    own = (
        ""
        if node.role in ("none", "generic", "InlineTextBox")
        else (
            f"{'  ' * depth}{node.role} {node.name!r}"
            f"{f' = {node.value!r}' if node.value else ''}{f' ({node.about})' if node.about else ''}"
            f"{f' {states}' if states else ''}\n"
        )
    )
    if node.role == "StaticText" and node.parent is not None and node.parent.name == node.name:
        own = ""
    return own + "".join(outline(child, depth + bool(own)) for child in node.children)
