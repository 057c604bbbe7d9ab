"""Messages from a page that belong to no feature.

Any client can forge them: `messages.read` accepts only what is exactly declared here, and only finite
numbers. Whether a mass or a control exists is checked where a message is handled. Places are in the page's
world, see `stage.sketch.Mapping`."""

from __future__ import annotations

from typing import Annotated

from msgspec import Meta

from .messages import (
    Ask,
    CommandName,
    FromPage,
    OwnBody,
    TextKind,
)


class Perform(OwnBody, frozen=True):
    """Execute a command of the table, see `app.ui.commands`."""

    command: CommandName


class Visit(OwnBody, frozen=True):
    """A slider or a number box was focused: later changes are another step of undo."""


# ------------------------------------------------------------------------- long texts
class Part(FromPage, frozen=True):
    """A part of a text that is too long for one message.

    Attributes:
        kind: of the whole text: a saved page ("resume"), or one of a feature's `texts`.
        number: from 1.
        of: number of parts.
    """

    kind: TextKind
    number: Annotated[int, Meta(ge=1, le=99)]
    of: Annotated[int, Meta(ge=1, le=99)]
    letters: Annotated[str, Meta(max_length=48_000, pattern=r"^[\x21-\x7e]*$")]


# ------------------------------------------------------------------------- questions
class Unsent(Ask, frozen=True):
    """A text was too long to be sent, for a notice to the user."""

    what: TextKind


class Who(Ask, frozen=True):
    """Identifies the page's user: a secret of the browser, and the owner's key if it was opened with that.

    Attributes:
        teacher: the secret of the page's class, if it is the teacher's page.
    """

    visitor: Annotated[str, Meta(pattern=r"^[0-9a-f]{32}$")]
    owner: Annotated[str, Meta(max_length=100)] = ""
    teacher: Annotated[str, Meta(max_length=100)] = ""
