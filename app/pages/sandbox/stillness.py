"""Decides whether a body stands still, and when texts and controls of its page have to be refreshed."""

from __future__ import annotations

READOUTS_EVERY = 0.1
"""Seconds between two updates of texts and sliders; more often would only flicker."""

RESTING_AFTER = 0.5
"""Seconds without visible movement after which the body counts as at rest."""


class Stillness:
    """Follows the movement of one page's body; times are wall time, s.

    Attributes:
        is_shown: the texts were refreshed at rest, so they need no more refreshing until something moves.
    """

    def __init__(self) -> None:
        self.is_shown = False
        self._moved_at = 0.0
        self._refresh_due = 0.0

    def move(self, now: float) -> None:
        """Note a visible movement."""
        self._moved_at = now

    def is_at_rest(self, now: float) -> bool:
        """Return True once the body has not moved for a while."""
        return now - self._moved_at > RESTING_AFTER

    def is_refresh_due(self, now: float, unsettled: bool) -> bool:
        """Return True if texts and controls are due for a refresh.

        Args:
            now: wall time, s.
            unsettled: a control will have more to show although nothing moves.
        """
        return now >= self._refresh_due and not (self.is_at_rest(now) and self.is_shown and not unsettled)

    def refresh(self, now: float, more_follows: bool) -> None:
        """Note that texts and controls are refreshed now.

        Args:
            now: wall time, s.
            more_follows: a computation will change them although the body is at rest.
        """
        self._refresh_due = now + READOUTS_EVERY
        self.is_shown = self.is_at_rest(now) and not more_follows
