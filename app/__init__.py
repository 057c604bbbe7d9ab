"""The softrod application: the page, its server and the command line; `app.show` is for notebooks."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import sim

    from .notebook import Shown


def show(scene: sim.Scene, width: int | str = "100%", height: int = 620) -> Shown:
    """Show a scene in the live page: in a notebook's cell, or else at an address that is printed.

        import app, sim

        shown = app.show(sim.load_scene("ring"))
        shown.scene()  # as it is now, with its pose
        shown.close()

    The server runs in the background of this process, and listens on this machine only, where the browser
    has to run, too.

    Args:
        scene: what the page shows first.
        width, height: of the frame in the notebook, px, or a width of CSS.

    Returns:
        What is shown; a notebook draws it, as the last line of a cell or by `display`.

    Raises:
        SceneError: the scene is not valid.
    """
    # Imported here: other parts of the package do not need viser, whose import takes a second.
    from .notebook import Shown

    return Shown(scene, width, height)
