"""The pose at rest that is shown while a slider moves."""

from __future__ import annotations

import time

import numpy as np

import sim
from app.session import commands
from app.session.rest_pose import SHOWN_FOR
from app.session.session import Session
from app.ui.view import picture_of
from sim.compiling.compiler import ENTRY_POINTS, fetch


def test_while_a_number_changes_its_pose_at_rest_is_the_pale_body() -> None:
    fetch(ENTRY_POINTS)
    now = [0.0]
    session = Session(sim.load_scene("rod"), clock=lambda: now[0])
    assert picture_of(session).ghost is None
    value = 3.0 * sim.settings.SETTINGS["angular_stiffness"].read(session.scene)
    commands.SetValue("angular_stiffness", value).apply(session, now[0])
    end = time.monotonic() + 60.0
    while picture_of(session).ghost is None and time.monotonic() < end:
        time.sleep(0.01)
    ghost = picture_of(session).ghost
    assert ghost is not None
    there = np.array(sim.equilibrium(session.scene).positions)
    assert np.abs(ghost - there).max() < 1e-3
    now[0] = 2.0 * SHOWN_FOR
    assert picture_of(session).ghost is None
    commands.SetValue("dt", 1e-3).apply(session, now[0])
    assert session.rest_pose_preview.positions(len(session.scene.masses), now[0]) is None
