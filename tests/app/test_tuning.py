"""Tuning in a page: what is told, when it is found out, and edits that undo takes back."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
from msgspec.structs import replace

import sim
from app.features.solver import tuning_panel
from app.features.solver.job import MAX_MASSES, worker
from app.features.solver.tuning_panel import TuningAnalysis, TuningPanel, Wished
from app.session import commands
from app.session.notices import Notice
from app.ui import readouts
from sim.analysis.tuning import Numbers
from sim.compiling.compiler import ENTRY_POINTS, fetch
from sim.design.tune import as_far_as_stable, damp_springs, edit_of, with_numbers
from sim.edit.edit import Selection
from sim.errors import InputError
from sim.motion.stability import largest_step
from tests.app.pages import SessionPage
from tests.app.panels import Client, page_of

SCENE = sim.load_scene("tutorial-3.3")
EULER = sim.Integrator(method="symplectic_euler", dt=1e-3)


def found(analysis: TuningAnalysis, scene: sim.Scene) -> TuningAnalysis:
    """The analysis, after it has found out."""
    fetch(ENTRY_POINTS)
    end = time.monotonic() + 60.0
    while analysis.busy and time.monotonic() < end:
        analysis.look(scene)
        time.sleep(0.01)
    assert not analysis.busy
    return analysis


def test_a_scene_is_told_of_once_it_has_settled(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[sim.Scene] = []
    tuning = sim.tuning

    def counted(scene: sim.Scene) -> sim.Tuning:
        asked.append(scene)
        return tuning(scene)

    monkeypatch.setattr(sim, "tuning", counted)
    analysis = TuningAnalysis()
    assert analysis.busy
    for k in range(5):  # as while a key is held
        analysis.look(replace(SCENE, rest_length_scale=1.0 + 0.01 * k))
    assert not asked
    found(analysis, SCENE)
    assert asked == [SCENE]
    assert analysis.tuning is not None
    assert analysis.tuning.stable_steps == tuning(SCENE).stable_steps
    other = replace(SCENE, gravity=(0.0, 100.0))
    analysis.look(other)
    assert analysis.busy
    assert found(analysis, other).scene is other


def test_large_bodies_and_defects_end_the_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    large = sim.rope(masses=MAX_MASSES + 1)
    assert f"at most {MAX_MASSES} masses" in found(TuningAnalysis(), large).trouble

    def defect(scene: sim.Scene) -> sim.Tuning:
        raise RuntimeError("a defect")

    monkeypatch.setattr(sim, "tuning", defect)
    assert "an error" in found(TuningAnalysis(), SCENE).trouble


def test_nothing_is_compiled_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tuning_panel, "is_ready", lambda names: False)
    analysis = TuningAnalysis()
    for _ in range(3):
        analysis.look(SCENE)
    assert analysis.busy
    assert analysis.trouble == "comes when it is compiled"


def test_the_table_has_what_there_is_with_units() -> None:
    told = sim.tuning(SCENE)
    text = readouts.tuning_table(SCENE, told, None)
    assert "slowest vibration</td><td>0.478 Hz, 2.09 s, undamped" in text
    assert "slowest elastic one</td><td>2.17 Hz, 0.46 s, damping ratio 0.027" in text
    assert "sag under gravity</td><td>13.2 px, mass 11" in text
    assert "calm after</td><td>6.18 s, to a tenth" in text
    text = readouts.tuning_table(SCENE, told, None, sim.sensitivities(SCENE))
    assert "1 % more stiffness of the springs</td><td>0.13 px less sag, 0.5\u00a0% faster" in text
    assert "1 % more gravity</td><td>0.13 px more sag" in text
    undamped = sim.set_value(sim.set_value(SCENE, "linear_damping", 0.0), "angular_damping", 0.0)
    assert "calm after</td><td>never" in readouts.tuning_table(undamped, sim.tuning(undamped), None)
    assert "Symplectic Euler</td><td>stable to 5.1 ms" in text
    assert "fastest spring alone</td><td>22.5 Hz, 44.4 ms, damping ratio 0.28" in text
    assert "spring 0 alone</td><td>15.9 Hz, 62.8 ms, damping ratio 0.2<" in readouts.tuning_table(
        SCENE, told, 0
    )
    free = replace(SCENE, anchors=(), bodies=())
    text = readouts.tuning_table(free, sim.tuning(free), None)
    assert "sag" not in text
    assert "Nothing holds mass 0, so it falls." in text
    evil = replace(SCENE, view=sim.View(unit="<b>"))
    assert "<b>" not in readouts.tuning_table(evil, sim.tuning(evil), None)


# ------------------------------------------------------------------------- edits
def test_a_body_is_made_stable_and_undo_takes_it_back() -> None:
    page = SessionPage(SCENE)
    session = page.session
    page.frames(20, commands.SetValue("dt", 0.008))
    origin = session.simulation.scene
    page.frames(0, commands.Play(False))
    posed = replace(origin, pose=session.simulation.pose())
    made = sim.make_stable(posed)
    assert made is not posed
    where, at = session.simulation.positions.copy(), session.simulation.time
    edit = partial(edit_of, partial(with_numbers, numbers=Numbers.of(made)), posed, label="Made stable")
    page.frames(1, commands.Play(False), commands.Change(lambda moment, _: edit(scene=moment.scene)))
    assert (session.simulation.positions == where).all()
    assert session.simulation.time == at
    assert session.versions.undoable == "Made stable"
    stiffness = [s.stiffness for s in made.linear_springs]
    assert [s.stiffness for s in session.scene.linear_springs] == stiffness
    assert session.simulation.stability().limit > 0.008
    page.frames(1, commands.Undo())
    assert session.scene.linear_springs == origin.linear_springs
    assert session.scene.angular_springs == origin.angular_springs
    page.frames(1, commands.Redo())
    assert [s.stiffness for s in session.scene.linear_springs] == stiffness
    # What was changed meanwhile is not overwritten.
    page.frames(1, commands.Undo(), commands.SetValue("linear_stiffness", 777.0))
    page.frames(1, commands.Change(lambda moment, _: edit(scene=moment.scene)))
    assert {s.stiffness for s in session.scene.linear_springs} == {777.0}
    assert "changed meanwhile" in session.notices[-1].text


def test_damping_goes_as_far_as_the_time_step_bears() -> None:
    damped = sim.damp_vibration(SCENE)
    assert largest_step(damped, "symplectic_euler") < 0.0025
    made = as_far_as_stable(SCENE, damped)
    assert 0.0025 <= largest_step(made, "symplectic_euler") <= 1.03 * 0.0025
    assert [s.stiffness for s in made.linear_springs] == [s.stiffness for s in SCENE.linear_springs]
    before, after, most = (sim.tuning(scene).elastic for scene in (SCENE, made, damped))
    assert before is not None and after is not None and most is not None
    assert before.damping_ratio < after.damping_ratio < most.damping_ratio
    auto = replace(SCENE, integrator=sim.Integrator())
    assert as_far_as_stable(auto, sim.damp_vibration(auto)) == sim.damp_vibration(auto)
    with pytest.raises(InputError, match="too long for the body as it is"):
        long = replace(SCENE, integrator=replace(SCENE.integrator, dt=0.01))
        as_far_as_stable(long, sim.damp_vibration(long))


def test_selected_springs_are_damped_each_by_itself() -> None:
    page = SessionPage(SCENE)
    some = Selection(springs=frozenset({0, 4}))
    page.frames(
        1,
        commands.Select(lambda *_: some),
        commands.Change(lambda moment, selected: damp_springs(moment.scene, selected.springs)),
    )
    damping = [s.damping for s in page.session.scene.linear_springs]
    # One mass of spring 0 is held.
    assert (damping[0], damping[4]) == pytest.approx((200.0, 2.0 * 5000.0**0.5))
    assert damping[1:4] == [40.0] * 3
    assert page.session.versions.undoable == "2 springs critically damped"
    page.frames(1, commands.Undo())
    assert page.session.scene.linear_springs == SCENE.linear_springs


# ------------------------------------------------------------------------- what is wished
class WishPage(SessionPage):
    """A session with the tuning of its page, which is shown."""

    def __init__(self, scene: sim.Scene) -> None:
        fetch(ENTRY_POINTS)
        super().__init__(scene)
        self.notices: list[Notice] = []
        client: Any = Client()
        self.made = client.gui
        self.panel = TuningPanel(page_of(self.session, client, notify=self.notices.append), 0.0)
        self.panel.build(True)
        self.frames(1, commands.Play(False))
        self.made["Tuning"].enter(True)
        self.settle()

    @property
    def text(self) -> str:
        return self.made.text()

    def settle(self) -> None:
        """Frames, as long as there is more to show."""
        end = time.monotonic() + 60.0
        for least in range(1000000):
            self.frames(1)
            self.panel.refresh()
            if least and not self.panel.waits:
                return
            assert time.monotonic() < end
            time.sleep(0.005)

    def wish(self, label: str, value: float) -> None:
        self.made[label].enter(value)
        self.settle()


ROD = sim.rod(masses=8, gravity=(0.0, 1000.0))


def calm_after(scene: sim.Scene) -> float:
    elastic = sim.tuning(scene).elastic
    assert elastic is not None
    return elastic.calm_after


def frequency_of(scene: sim.Scene) -> float:
    elastic = sim.tuning(scene).elastic
    assert elastic is not None
    return elastic.frequency


@pytest.mark.parametrize(
    ("label", "factor", "does"),
    [
        ("Calm after", 0.6, calm_after),
        ("Sag", 0.7, lambda scene: sim.tuning(scene).sag),
        ("Stable step", 1.3, lambda scene: sim.tuning(scene).stable_steps["symplectic_euler"]),
    ],
)
def test_a_typed_number_is_what_the_body_then_does(
    label: str, factor: float, does: Callable[[sim.Scene], float]
) -> None:
    page = WishPage(replace(ROD, integrator=EULER))
    session, box = page.session, page.made[label]
    origin, told = session.scene, does(session.scene)
    assert box.visible
    assert box.value == float(f"{told:.3g}")  # what the table tells
    page.wish(label, float(f"{factor * told:.3g}"))
    wished = pytest.approx(factor * told, rel=0.02)
    assert does(session.scene) == wished
    assert box.value == wished
    assert "cannot be had" not in page.text
    assert session.versions.undoable
    # A second one is a step by itself.
    page.wish(label, 1.2 * factor * told)
    assert len(session.versions) == 2
    page.frames(2, commands.Undo())
    assert does(session.scene) == wished
    page.frames(2, commands.Undo())
    assert session.scene.linear_springs == origin.linear_springs
    assert session.scene.angular_springs == origin.angular_springs
    page.settle()
    assert box.value == float(f"{told:.3g}")
    page.made[label].enter(-1.0)
    assert box.value == float(f"{told:.3g}")


def test_sliders_make_it_stiff_and_calm() -> None:
    scene = replace(SCENE, integrator=sim.Integrator())
    page = WishPage(scene)
    session, before = page.session, sim.tuning(scene).elastic
    assert before is not None
    assert page.made["Sag"].visible
    assert not page.made["Stable step"].visible  # its method has no limit
    page.wish("Soft – stiff", 2.0 * before.frequency)
    after = sim.tuning(session.scene).elastic
    assert after is not None
    assert after.frequency == pytest.approx(2.0 * before.frequency, rel=0.01)
    assert after.damping_ratio == pytest.approx(before.damping_ratio, rel=0.05)  # as bouncy as before
    # What is dragged through is one step.
    page.wish("Soft – stiff", 3.0 * before.frequency)
    assert frequency_of(session.scene) == pytest.approx(3.0 * before.frequency, rel=0.01)
    assert len(session.versions) == 1
    page.wish("Bouncy – calm", 0.3)
    calm = sim.tuning(session.scene).elastic
    assert calm is not None
    assert calm.damping_ratio == pytest.approx(0.3, rel=0.05)
    page.frames(2, commands.Undo(), commands.Undo())
    assert session.scene.linear_springs == SCENE.linear_springs


def test_what_cannot_be_had_is_said_until_the_body_changes() -> None:
    # A rope that is pulled aside swings there however stiff it is.
    page = WishPage(sim.rope(masses=8, driven=0, gravity=(1000.0, 0.0)))
    sag = sim.tuning(page.session.scene).sag
    assert sag is not None
    page.wish("Sag", 0.2 * sag)
    assert f"A sag of {0.2 * sag:.3g} px cannot be had by stiffness and damping; the nearest is" in page.text
    assert page.made["Sag"].value == pytest.approx(sag, rel=0.1)
    page.frames(2, commands.Undo())
    page.settle()
    assert "cannot be had" not in page.text


def test_a_later_wish_says_which_older_ones_it_discards() -> None:
    page = WishPage(sim.rod(masses=3, gravity=(0.0, 1000.0)))
    page.wish("Calm after", 0.5)
    page.wish("Sag", 0.5 * page.made["Sag"].value)
    assert "No longer as wished: Calm after 0.5 s." in page.text


def test_what_is_no_longer_as_wished_is_told_once_but_again_while_a_slider_is_dragged() -> None:
    wished, rod = Wished(), sim.rod(masses=3, integrator=EULER)
    soft = sim.set_value(rod, "angular_stiffness", 1000.0)
    step = sim.tuning(rod).stable_steps["symplectic_euler"]
    assert wished.discarded_by("calm_after", calm_after(rod), "calm", rod) == []
    assert wished.discarded_by("dt", step, "step", rod) == []
    for _ in range(2):
        assert wished.discarded_by("frequency", frequency_of(soft), "soft", soft) == ["calm"]
    assert wished.discarded_by("sag", 1.0, "sag", soft) == []


def test_a_wish_is_said_to_be_worked_on_at_once_also_while_it_waits() -> None:
    page, others = WishPage(ROD), threading.Event()

    def wait() -> None:
        others.wait(10.0)

    worker.submit(wait)
    try:
        page.made["Calm after"].enter(0.5)
        page.panel.refresh()
        assert "is being found out" in page.text and "slowest vibration" in page.text
    finally:
        others.set()
    page.settle()
    assert "is being found out" not in page.text


def test_a_step_that_is_borne_anyhow_changes_nothing() -> None:
    page = WishPage(SCENE)
    page.wish("Stable step", 0.004)
    assert "It is stable at 4 ms as it is, so nothing was changed." in page.text
    assert page.session.versions.undoable == ""


def test_its_buttons_make_it_stable_and_damp_it_as_far_as_its_step_bears() -> None:
    page = WishPage(SCENE)
    session = page.session

    def press(label: str, *before: commands.Command) -> str:
        """What is to be undone then."""
        page.frames(1, *before)
        page.settle()
        page.wish(label, math.nan)
        return session.versions.undoable

    stable, damp = "Make it stable at this time step", "Critically damp"
    assert press(stable) == ""
    assert (page.notices[-1].title, page.notices[-1].text[-20:]) == ("It is stable", "Nothing was changed.")
    assert press(stable, commands.SetValue("dt", 0.008)) == "Made stable at 8 ms"
    assert session.stability.limit > 0.008
    page.frames(1, commands.Undo())
    assert session.scene.linear_springs == SCENE.linear_springs
    assert press(damp, commands.SetValue("dt", 0.0025)) == "Damped as far as 2.5 ms allows"
    assert page.notices[-1].title == "Not critical yet"
    page.frames(1, commands.Undo())
    assert press(damp, commands.SetChoice("method", "auto")) == "Critically damped"
    assert stable not in page.made, "a method that needs no help"
    assert "damping ratio 1" in page.text


def test_a_body_that_has_exploded_is_not_made_stable_in_the_pose_it_was_torn_into() -> None:
    page = WishPage(SCENE)
    page.frames(
        1, commands.SetChoice("method", "symplectic_euler"), commands.SetValue("linear_stiffness", 1e9)
    )
    page.frames(60, commands.Play(True))
    assert page.session.simulation.divergence is not None
    page.wish("Make it stable at this time step", math.nan)
    assert page.notices[-1].title == "It cannot be made stable"
    assert "has exploded" in page.notices[-1].text
    # As it advises: what is to be mended is still there.
    page.frames(1, commands.BackBeforeDivergence())
    assert page.session.scene.linear_springs[0].stiffness == 1e9


def test_what_has_nothing_to_do_with_it_is_not_offered() -> None:
    page = WishPage(replace(ROD, gravity=(0.0, 0.0)))
    assert not page.made["Sag"].visible
    assert page.made["Calm after"].visible
    page.made["Tuning"].enter(False)
    page.settle()
    assert not page.made["Calm after"].visible
    assert page.text == ""


def test_how_long_it_takes_is_that_of_the_wish() -> None:
    design = sim.set_wishes(ROD, calm_after=0.5)
    assert calm_after(design.scene) == pytest.approx(design.reached["calm_after"], rel=1e-9)
    undamped = sim.set_value(sim.set_value(ROD, "linear_damping", 0.0), "angular_damping", 0.0)
    assert calm_after(replace(undamped, air_friction=0.0)) == math.inf
