"""The folder of what is selected: its numbers, and what they and its buttons do to the body."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
import pytest

import sim
from app.features.edit import selection_panel
from app.features.edit.selection_panel import SelectionPanel, describe, label_of, numbers_of, options_of
from app.session import commands
from app.session.notices import Notice
from app.words import find
from sim.edit.edit import Selection
from sim.edit.muscles import give_muscles
from sim.edit.values import NUMBERS, STARTS, WAYS
from sim.scene.parts import JointMuscle, Motor, SpringMuscle
from tests.app.pages import SessionPage
from tests.app.panels import Client, page_of


class Page(SessionPage):
    """A session with the folder of its page, at 60 frames a second."""

    def __init__(self, scene: sim.Scene) -> None:
        super().__init__(scene)
        self.notices: list[Notice] = []
        client: Any = Client()
        self.made = client.gui
        self.panel = SelectionPanel(page_of(self.session, client, notify=self.notices.append))
        self.frames(1, commands.Play(False))

    def frames(self, count: int, *posts: commands.Command) -> None:
        for command in posts:
            self.session.post(command)
        for _ in range(count):
            super().frames(1)
            self.panel.tick()

    def select(
        self, masses: tuple[int, ...] = (), springs: tuple[int, ...] = (), joints: tuple[int, ...] = ()
    ) -> None:
        parts = Selection(*map(frozenset, (masses, springs, joints)))
        self.frames(1, commands.Select(lambda *_: parts))

    def shown(self) -> dict[str, object]:
        """What the boxes that are there show, by their labels."""
        return {one.label: one.value for one in self.made.there if one.kind == "number" and one.is_shown}

    def enter(self, label: str, value: object) -> None:
        self.made[label].enter(value)
        self.frames(10)

    @property
    def scene(self) -> sim.Scene:
        return self.session.simulation.capture().scene


def rope() -> sim.Scene:
    """Of four masses; one spring is stiffer."""
    scene = sim.rope(4, view=sim.View(frame=(0.0, 0.0, 600.0, 600.0)))
    springs = tuple(
        msgspec.structs.replace(spring, stiffness=20_000.0 if s == 1 else 10_000.0)
        for s, spring in enumerate(scene.linear_springs)
    )
    return msgspec.structs.replace(scene, bodies=(), linear_springs=springs)


@pytest.fixture(autouse=True)
def at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nobody is still typing when the next frame comes."""
    monkeypatch.setattr(selection_panel, "TOUCHED", -1.0)


def stiffnesses(page: Page) -> list[float]:
    return [spring.stiffness for spring in page.scene.linear_springs]


def test_nothing_is_made_until_something_is_selected_and_it_goes_with_the_selection() -> None:
    page = Page(rope())
    page.frames(20)
    assert page.made.there == []
    page.select(masses=(1, 2), springs=(0,))
    folder = page.made.there[0]
    assert (folder.label, folder.visible) == ("2 masses, 1 spring", True)
    forces, springs = ["Force x", "Force y"], ["Stiffness", "Damping", "Rest length"]
    places = ["Start x (middle)", "Start y (middle)"]
    assert list(page.shown()) == [*places, "Mass", "Radius", *forces, *springs]
    page.select(masses=(1,))
    assert list(page.shown()) == ["Start x", "Start y", "Mass", "Radius", *forces]
    page.select(masses=(1, 2), springs=(0,))
    count = len(page.made.there)
    page.select(joints=(0, 1))
    assert folder.label == "2 joints"
    assert list(page.shown()) == ["Joint stiffness", "Joint damping", "Rest angle"]
    assert not page.made["Masses"].visible
    page.select()
    assert not folder.visible
    assert len(page.made.there) == count


def test_a_number_that_differs_is_mixed_and_entering_one_sets_all_until_an_undo() -> None:
    page = Page(rope())
    page.select(springs=(0, 1))
    assert page.shown()["Stiffness (mixed)"] == pytest.approx(20_000.0)
    assert page.shown()["Stiffness (mixed)"] != 20_000.0, "viser would drop that number if it was typed"
    for typed in (3.0, 30.0, 300.0):
        page.made["Stiffness"].enter(typed)
        page.frames(5)
    assert stiffnesses(page) == [300.0, 300.0, 10_000.0]
    assert page.shown()["Stiffness"] == 300.0
    assert len(page.session.versions) == 1
    page.frames(10, commands.Undo())
    assert stiffnesses(page) == [10_000.0, 20_000.0, 10_000.0]
    assert page.shown()["Stiffness (mixed)"] == pytest.approx(20_000.0)
    # The same number of other parts is another step.
    page.enter("Stiffness", 5.0)
    page.select(springs=(2,))
    page.enter("Stiffness", 6.0)
    assert stiffnesses(page) == [5.0, 5.0, 6.0]
    assert len(page.session.versions) == 2


def test_a_mass_is_put_exactly_where_it_is_to_start() -> None:
    """A pendulum of 100 px at 30°."""
    page = Page(rope())
    page.frames(30, commands.Play())
    page.frames(1, commands.Play(False))
    page.select(masses=(3,))
    start, now = page.scene.masses[3].position, page.simulation.positions[3]
    assert (page.shown()["Start x"], page.shown()["Start y"]) == start
    page.enter("Start x", 350.0)
    page.enter("Start y", 86.60254)
    assert page.scene.masses[3].position == pytest.approx((350.0, 86.60254), abs=1e-12)
    # What moves now is moved by as much.
    moved = page.simulation.positions[3] - now
    assert moved == pytest.approx(np.subtract((350.0, 86.60254), start), abs=1e-9)
    assert page.scene.linear_springs == rope().linear_springs
    page.frames(10, commands.Reset())
    assert page.simulation.positions[3] == pytest.approx((350.0, 86.60254), abs=1e-12)
    assert len(page.session.versions) == 2
    page.frames(10, commands.Undo())
    assert page.scene.masses[3].position == (350.0, start[1])
    page.frames(10, commands.Undo())
    assert page.scene.masses[3].position == start


def test_several_masses_move_together_by_their_middle() -> None:
    page = Page(rope())
    page.select(masses=(1, 2, 3))
    before = np.array([mass.position for mass in page.scene.masses])
    middle = float((before[1, 1] + before[3, 1]) / 2.0)
    assert page.shown()["Start y (middle)"] == pytest.approx(middle)
    page.enter("Start y", 500.0)
    after = np.array([mass.position for mass in page.scene.masses])
    assert after[1:] - before[1:] == pytest.approx(np.full((3, 2), (0.0, 500.0 - middle)), abs=1e-9)
    assert after[0].tolist() == before[0].tolist()
    assert len(page.session.versions) == 1


def test_forces_are_set_and_taken_away() -> None:
    page = Page(rope())
    bare = page.scene.masses
    page.select(masses=(2, 3))
    page.enter("Force y", 500.0)
    page.select(masses=(3,))
    page.enter("Force x", -20.0)
    assert [mass.force for mass in page.scene.masses[2:]] == [(0.0, 500.0), (-20.0, 500.0)]
    page.select(masses=(2, 3))
    assert page.shown()["Force x (mixed)"] == pytest.approx(-20.0)
    assert page.shown()["Force y"] == 500.0
    page.enter("Force y", 2e15)
    assert page.scene.masses[2].force == (0.0, 500.0)
    page.enter("Force x", 0.0)
    page.enter("Force y", 0.0)
    assert page.scene.masses == bare
    page.frames(10, commands.Undo())
    assert [mass.force for mass in page.scene.masses[2:]] == [(0.0, 500.0)] * 2


def test_numbers_keep_their_proportions_if_they_are_to() -> None:
    page = Page(rope())
    page.select(springs=(0,))
    assert not page.made["Keep proportions"].visible
    page.select(springs=(0, 1))
    assert page.made["Keep proportions"].visible
    page.made["Keep proportions"].value = True
    page.enter("Stiffness", 4_000.0)
    assert stiffnesses(page) == [2_000.0, 4_000.0, 10_000.0]
    page.enter("Stiffness", 0.0)  # on its way to 0.5, which would leave no proportions
    page.enter("Stiffness", 0.5)
    assert stiffnesses(page) == [0.25, 0.5, 10_000.0]


def test_what_is_out_of_range_is_not_taken() -> None:
    page = Page(rope())
    page.select(masses=(2,))
    page.enter("Mass", -3.0)
    assert page.scene.masses[2].mass == 1.0
    assert page.shown()["Mass"] == 1.0
    assert page.session.notices == []


def test_what_does_not_go_together_is_one_sentence() -> None:
    page = Page(sim.load_scene("girder"))
    page.select(springs=(0,))
    page.enter("Strength", 1.0)
    (notice,) = page.session.notices
    assert notice.text == "Strength: 1 is below the yield force 280000"
    assert len(page.session.versions) == 0


def test_hardening_is_there_for_what_yields() -> None:
    scene = sim.load_scene("girder")
    some = Selection(springs=frozenset({0}))
    fields = [[each.of.field for each in numbers_of(each_scene, some)] for each_scene in (scene, rope())]
    assert fields[0][-3:] == ["strength", "yield_force", "hardening"]
    assert "hardening" not in fields[1]


def test_rest_angles_are_with_what_the_arrow_keys_did() -> None:
    page = Page(sim.load_scene("tutorial-3.3"))
    page.simulation.keys = {"right"}
    page.simulation.step(50)
    page.simulation.keys = set()
    page.select(joints=(2,))
    assert page.shown()["Rest angle"] == pytest.approx(5.0)
    page.enter("Rest angle", -20.0)
    rest = page.simulation.rest_angles
    assert rest[[1, 2, 3]] == pytest.approx([5.0, -20.0, 5.0])
    assert page.shown()["Rest angle"] == pytest.approx(-20.0)


def test_masses_are_pinned_let_go_and_deleted() -> None:
    page = Page(rope())
    held = {anchor.mass for anchor in page.scene.anchors}
    page.select(masses=(2, 3))
    page.enter("Masses", "Pin")
    assert {anchor.mass for anchor in page.scene.anchors} == held | {2, 3}
    page.enter("Masses", "Let go")
    assert {anchor.mass for anchor in page.scene.anchors} == held - {2, 3}
    page.made["Delete"].enter(None)
    page.frames(2)
    assert (len(page.scene.masses), len(page.scene.linear_springs)) == (2, 1)
    assert not page.made.there[0].visible
    page.frames(2, commands.Undo())
    assert len(page.scene.masses) == 4


def test_springs_and_joints_rest_as_they_are() -> None:
    """With all that makes a rest length and a rest angle: the factor and the shift of keys."""
    page = Page(sim.load_scene("tutorial-3.3"))
    simulation = page.simulation
    simulation.keys = {"up", "right"}
    simulation.step(80)
    simulation.keys = set()
    page.select(springs=(4,), joints=(4,))
    page.made["Rest as it is now"].enter(None)
    page.frames(1)
    way = np.diff(page.simulation.positions[4:6], axis=0)
    rest = page.scene.linear_springs[4].rest_length * page.simulation.rest_length_scale
    assert rest == pytest.approx(float(np.hypot(*way[0])))
    angles = page.simulation.angles, page.simulation.rest_angles
    assert angles[0][4] == pytest.approx(angles[1][4])
    assert abs(angles[0][5] - angles[1][5]) > 1e-3
    assert page.scene.linear_springs[5] == page.session.opened.linear_springs[5]


def test_a_mass_that_is_alone_has_nothing_that_could_rest() -> None:
    page = Page(sim.Scene(name="one", masses=(sim.Mass(position=(0.0, 0.0)),)))
    page.select(masses=(0,))
    page.made["Rest as it is now"].enter(None)
    page.frames(1)
    (notice,) = page.session.notices
    assert notice.text == "no spring and no joint is selected that could rest as it is"


def test_what_is_selected_in_words() -> None:
    parts = Selection(frozenset({1}), frozenset({1, 2}), frozenset({0, 4, 7}))
    assert describe(parts) == "1 mass, 2 springs, 3 joints"


def test_numbers_of_muscles_get_their_boxes_with_the_first_muscle() -> None:
    page = Page(rope())
    page.select(springs=(0, 1), joints=(0,))
    assert not any("uscle" in one.label for one in page.made.there)
    page.frames(1, commands.Change(lambda moment, selected: give_muscles(moment.scene, selected)))
    page.frames(10)
    assert page.shown()["Muscle amplitude"] == 0.2 and page.shown()["Joint muscle amplitude"] == 20.0
    page.enter("Muscle phase", 45.0)
    page.enter("Muscle waves per beat", 1.5)
    assert "1.5 is not a whole number" in page.session.notices[-1].text
    page.enter("Muscle waves per beat", 2.0)
    wanted = SpringMuscle(phase=45.0, per_beat=2)
    assert [spring.muscle for spring in page.scene.linear_springs[:2]] == [wanted] * 2
    page.select(masses=(1,))
    assert not any("uscle" in label for label in page.shown())


def test_masses_become_balls() -> None:
    page = Page(rope())
    page.select(masses=(1, 2))
    page.frames(1)
    assert page.made["Masses touch"].value == "no other mass"
    page.enter("Masses touch", "other balls")
    assert [mass.solid for mass in page.scene.masses[:4]] == [msgspec.UNSET, True, True, msgspec.UNSET]
    page.enter("Masses touch", "no other mass")
    assert page.scene.masses[1].solid is msgspec.UNSET


def test_masses_are_put_on_rails() -> None:
    page = Page(rope())
    page.select(masses=(1,))
    page.frames(1)
    page.enter("Masses move", "up and down on a rail")
    assert page.scene.masses[1].rail == (0.0, 1.0)
    page.frames(5)
    assert page.made["Masses move"].value == "up and down on a rail"
    page.enter("Masses move", "freely")
    assert page.scene.masses[1].rail is msgspec.UNSET


def test_keys_are_chosen_for_forces_muscles_and_motors() -> None:
    page = Page(rope())
    page.select(masses=(1, 2))
    page.frames(1)
    assert page.made["Forces act"].value == "always"
    page.enter("Forces act", "with the keys Up and Down")
    pushed = page.scene.masses[1]
    assert pushed.keys == "up-down" and pushed.force and pushed.force[1] < 0.0 == pushed.force[0]
    page.frames(5)
    page.enter("Force y", 0.0)
    assert page.scene.masses[1].keys is msgspec.UNSET is page.scene.masses[1].force
    page.select(springs=(0, 1), joints=(0,))
    assert not any("uscle" in one.label for one in page.made.there)
    page.frames(1, commands.Change(lambda moment, selected: give_muscles(moment.scene, selected)))
    page.frames(10)
    page.enter("Muscles work", "steadily, with the keys Left and Right")
    page.enter("Joint muscles work", "to the beat, with the keys Up and Down")
    page.enter("Joints turn", "by a motor, with the keys Up and Down")
    assert page.scene.linear_springs[0].muscle == SpringMuscle(keys="left-right", wave="steady")
    joint = page.scene.angular_springs[0]
    assert (joint.muscle, joint.motor) == (JointMuscle(keys="up-down"), Motor(keys="up-down"))
    page.frames(5)
    assert page.made["Muscles work"].value == "steadily, with the keys Left and Right"
    page.enter("Muscles work", "to the beat")
    assert page.scene.linear_springs[0].muscle == SpringMuscle()
    # A motor turns its joint at once: what would hold the angle gives way.
    page.select(joints=(1,))
    page.enter("Joints turn", "by a motor")
    assert page.scene.angular_springs[1].stiffness == 0.0
    page.select(springs=(2,))
    page.frames(1)
    assert not page.made["Muscles work"].is_shown


def test_springs_become_ropes_and_joints_stops() -> None:
    page = Page(rope())
    page.select(springs=(0, 1), joints=(0,))
    page.frames(1)
    springs, joints = page.made["Springs act"], page.made["Joints act"]
    assert (springs.value, joints.value) == ("both ways", "on both sides")
    page.enter("Springs act", "pulls only")
    page.enter("Joints act", "above its angle only")
    assert [spring.only for spring in page.scene.linear_springs] == ["pull", "pull", msgspec.UNSET]
    assert page.scene.angular_springs[0].only == "above"
    page.select(springs=(0, 2))
    page.frames(1)
    assert (springs.value, springs.options[0]) == ("mixed", "mixed")
    assert not joints.is_shown
    page.enter("Springs act", "mixed")  # nothing changes
    assert page.scene.linear_springs[0].only == "pull"
    page.enter("Springs act", "both ways")
    assert [spring.only for spring in page.scene.linear_springs] == [msgspec.UNSET, "pull", msgspec.UNSET]
    page.frames(1, commands.Undo())
    assert page.scene.linear_springs[0].only == "pull"


def test_numbers_and_ways_are_called_as_the_edits_call_them() -> None:
    for of in (*STARTS, *NUMBERS):
        assert label_of(of) == of.label
    for key, way in WAYS.items():
        assert options_of(key) == way.words
        assert find(f"way-{key.replace(' ', '-')}") and find(f"way-{key.replace(' ', '-')}.hint")
