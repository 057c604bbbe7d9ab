"""Any scene and any file at all: valid and then simulated, or refused in one sentence."""

from __future__ import annotations

import json
import math
import re
from typing import Any, get_args

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

import sim
from sim import (
    Anchor,
    AngularSpring,
    ArrowKeys,
    Integrator,
    LinearSpring,
    Mass,
    Pose,
    Rope,
    Scene,
    SceneError,
    Simulation,
    validate,
)
from sim.scene.types import Circle, ForceLaw, Method
from sim.settings import SETTINGS, TEMPLATES, set_value
from sim.store.files import decode_scene, encode_scene
from tests.amount import examples
from tests.sim.builders import PRESETS

# Derandomised: a run of the tests must not depend on luck. The search is over the same examples each time.
often = settings(
    max_examples=examples(250),
    derandomize=True,
    database=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)


def between(low: float, high: float) -> st.SearchStrategy[float]:
    """Any number of a range: mostly a usual one, sometimes an end of the range or a number of any size."""
    usual = st.floats(max(low, -500.0), min(high, 500.0))
    return st.one_of(usual, st.floats(low, high), st.sampled_from([low, high]))


coordinates = between(-1e6, 1e6)
vectors = st.tuples(coordinates, coordinates)
angles = between(-180.0, 180.0)
stiffnesses = st.one_of(st.floats(0.0, 2e4), between(0.0, 1e9), between(0.0, 1e15))
dampings = between(0.0, 1e6)
circles = st.none() | st.builds(
    Circle,
    radius=between(0.0, 1e4),
    frequency=st.one_of(st.floats(-3.0, 3.0), between(-100.0, 100.0)),
    ramp=between(1e-3, 100.0),
)


@st.composite
def bodies(draw: st.DrawFn) -> dict[str, Any]:
    """Masses, springs, joints and anchors that refer to each other as they should, mostly."""
    n = draw(st.integers(1, 7))
    pairs = st.tuples(st.integers(0, n - 1), st.integers(0, n - 1)).filter(lambda pair: pair[0] != pair[1])
    ends = draw(st.lists(pairs, max_size=9, unique_by=frozenset)) if n > 1 else []
    sharing = [
        (a, b) for a in range(len(ends)) for b in range(len(ends)) if a != b and set(ends[a]) & set(ends[b])
    ]
    joined = draw(st.lists(st.sampled_from(sharing), max_size=9, unique_by=frozenset)) if sharing else []
    held = draw(st.lists(st.integers(0, n - 1), max_size=n, unique=True))
    masses = st.builds(
        Mass,
        position=vectors,
        velocity=vectors,
        mass=st.one_of(st.floats(0.1, 10.0), between(1e-6, 1e6)),
        radius=between(1e-3, 1e4),
    )
    return {
        "masses": tuple(draw(st.lists(masses, min_size=n, max_size=n))),
        "linear_springs": tuple(
            LinearSpring(
                a=a,
                b=b,
                stiffness=draw(stiffnesses),
                damping=draw(between(0.0, 1e6)),
                rest_length=draw(between(0.0, 1e6)),
            )
            for a, b in ends
        ),
        "angular_springs": tuple(
            AngularSpring(
                a=a,
                b=b,
                stiffness=draw(stiffnesses),
                damping=draw(st.just(0.0) | dampings),
                rest_angle=draw(angles),
            )
            for a, b in joined
        ),
        "anchors": tuple(
            Anchor(mass=mass, driven=i == 0, circle=draw(circles)) for i, mass in enumerate(held)
        ),
    }


ropes = st.builds(
    Rope,
    masses=st.integers(2, 12),
    length=between(1e-3, 1e6),
    start=vectors,
    offset=between(-1000.0, 1000.0),
    # Shorter directions are tested apart.
    direction=vectors.filter(lambda v: v == (0.0, 0.0) or math.hypot(*v) > 1e-100),
    stiffness=stiffnesses,
    damping=between(0.0, 1e6),
    angular_stiffness=stiffnesses,
    angular_damping=st.just(0.0) | dampings,
    rest_angle=angles,
    joints=st.booleans(),
    held=st.lists(st.integers(0, 13), max_size=3).map(tuple),
    driven=st.none() | st.integers(0, 13),
    circle=circles,
)

surroundings: st.SearchStrategy[dict[str, Any]] = st.fixed_dictionaries(
    {
        "name": st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=60),
        # Spaces within brackets are tested apart.
        "description": st.text(st.characters(exclude_categories=["Cs"], exclude_characters="["), max_size=80),
        "gravity": vectors,
        "air_friction": between(0.0, 1000.0),
        "rest_length_scale": between(0.01, 100.0),
        "force_law": st.sampled_from(get_args(ForceLaw)),
        "integrator": st.builds(
            Integrator,
            method=st.sampled_from(get_args(Method)),
            dt=st.one_of(st.floats(1e-4, 1e-2), between(1e-6, 1.0)),
            tolerance=st.one_of(st.floats(1e-3, 1.0), between(1e-12, 1e3)),
        ),
        "arrow_keys": st.none()
        # Intervals far shorter than the step are tested apart.
        | st.builds(
            ArrowKeys,
            rest_length_factor=between(1.0, 2.0),
            rest_angle_step=between(0.0, 90.0),
            interval=between(1.0, 10.0),
        ),
    }
)


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    """Scenes of which a good part is valid, and the rest wrong in one thing or two."""
    body: dict[str, Any] = draw(st.one_of(bodies(), st.fixed_dictionaries({"bodies": st.tuples(ropes)})))
    scene = Scene(**body, **draw(surroundings))
    if draw(st.integers(0, 3)) == 0:
        template = draw(st.sampled_from(TEMPLATES))
        joints = tuple(replace(j, rest_angle=float(template)) for j in scene.angular_springs)
        scene = replace(scene, bodies=(), angular_springs=joints, template=template)
    if draw(st.integers(0, 3)) == 0:
        n = len(scene.masses)
        positions, velocities = (draw(st.lists(vectors, min_size=n, max_size=n)) for _ in range(2))
        scene = replace(scene, pose=Pose(positions=tuple(positions), velocities=tuple(velocities)))
    return scene


def is_valid(scene: Scene) -> bool:
    """Whether it validates; if not, the sentence must be one, and name a field."""
    try:
        validate(scene)
    except SceneError as error:
        assert "\n" not in str(error)
        field = re.match(r"(\w+)[\w.\[\]]*: .", str(error))
        assert field, str(error)
        assert field[1] in Scene.__struct_fields__
        return False
    return True


def is_fine(simulation: Simulation) -> None:
    """Whatever has happened, every number that comes out is one."""
    assert np.isfinite(simulation.positions).all()
    assert np.isfinite(simulation.velocities).all()
    # An anchor on a circle is where its center and its phase put it, to rounding.
    assert np.abs(simulation.positions).max() <= 1e6 + 1e-9
    assert np.abs(simulation.velocities).max() <= 1e9
    assert np.isfinite(simulation.angles).all()
    assert (np.abs(simulation.rest_angles) <= 180.0).all()
    assert math.isfinite(simulation.time)


ATTEMPTS = 500
"""Steps that a method may try in one call: stiff bodies and small tolerances would take others for ever."""


def go_on(simulation: Simulation, steps: int) -> int:
    """Do some steps. They are fewer only where the body has run away, or no attempts are left."""
    simulation.stats()
    done = simulation.step(steps, attempts=ATTEMPTS)
    if done < steps and simulation.divergence is None:
        assert simulation.stats().work >= ATTEMPTS
    return done


# ------------------------------------------------------------------------- scenes
@often
@given(scenes(), st.sets(st.sampled_from(["up", "down", "left", "right"])), st.integers(1, 200))
def test_what_validates_simulates(scene: Scene, keys: set[str], steps: int) -> None:
    if not is_valid(scene):
        return
    simulation = Simulation(scene)
    is_fine(simulation)
    simulation.keys = keys
    done = go_on(simulation, steps)
    is_fine(simulation)
    assert done < steps or simulation.divergence is None
    if simulation.divergence is not None:
        assert "\n" not in str(simulation.divergence)
        assert 0 <= simulation.divergence.mass < len(scene.masses)
    assert simulation.stability().limit > 0.0
    # What the page would save of it can be opened again.
    validate(simulation.scene)
    saved = replace(simulation.scene, pose=simulation.pose())
    if is_valid(saved):
        assert decode_scene(encode_scene(saved), "scene") == saved


@often
@given(scenes(), vectors, st.booleans())
def test_the_pointer_may_go_anywhere(scene: Scene, to: tuple[float, float], at_once: bool) -> None:
    if not is_valid(scene):
        return
    simulation = Simulation(scene)
    mass = len(scene.masses) - 1
    simulation.grab(mass)
    (simulation.move if at_once else simulation.lead)(mass, to)
    goes_round = any(anchor.mass == mass and anchor.circle is not None for anchor in scene.anchors)
    if go_on(simulation, 20) == 20 and not goes_round:
        assert tuple(simulation.positions[mass]) == to
    is_fine(simulation)
    simulation.release(mass)
    go_on(simulation, 20)
    is_fine(simulation)
    simulation.reset()
    assert simulation.divergence is None
    is_fine(simulation)


@often
@given(st.sampled_from(PRESETS), st.sampled_from(sorted(SETTINGS)), st.floats())
def test_a_setting_is_made_or_refused(preset: str, key: str, value: float) -> None:
    scene = sim.load_scene(preset)
    try:
        changed = set_value(scene, key, value)
    except sim.SettingError as error:
        assert str(error).startswith(f"{key}: ")
        assert "\n" not in str(error)
        return
    assert validate(changed) is changed
    # Speed and direction of the wind are kept as a vector.
    assert SETTINGS[key].read(changed) == pytest.approx(value, rel=1e-12, abs=1e-9)


# ------------------------------------------------------------------------- files
def opens_or_refuses(data: bytes) -> None:
    try:
        scene = decode_scene(data, "file")
    except SceneError as error:
        assert str(error).startswith("file: ")
        assert "\n" not in str(error)
        return
    assert validate(scene) is scene
    assert decode_scene(encode_scene(scene), "file") == scene


@often
@given(
    st.binary(max_size=200) | st.text(max_size=100).map(lambda text: text.encode("utf-8", "surrogatepass"))
)
def test_random_bytes(data: bytes) -> None:
    opens_or_refuses(data)


scalars = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.integers(-(10**40), 10**40),
    st.floats(allow_nan=False, allow_infinity=False),
    st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=8),
)
junk = st.recursive(
    scalars,
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(st.sampled_from(["a", "mass", "masses"]), inner, max_size=3)
    ),
    max_leaves=6,
)

FILES = [encode_scene(sim.load_scene(preset)) for preset in ("tutorial-3.1", "tutorial-3.2", "box", "ring")]


def routes(value: Any, route: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    """The way to every value in decoded JSON."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [route] + [deeper for key, item in inner for deeper in routes(item, (*route, key))]


@often
@given(st.data())
def test_valid_files_with_some_values_replaced(data: st.DataObject) -> None:
    raw = json.loads(data.draw(st.sampled_from(FILES)))
    for _ in range(data.draw(st.integers(1, 2))):
        *route, last = data.draw(st.sampled_from(routes(raw)[1:]))
        target = raw
        for step in route:
            target = target[step]
        if isinstance(target, dict) and data.draw(st.booleans()):
            del target[last]
        else:
            target[last] = data.draw(junk)
    opens_or_refuses(json.dumps(raw).encode())


@often
@given(
    st.sampled_from(FILES),
    st.lists(st.tuples(st.integers(0, 10_000), st.integers(0, 255)), max_size=4),
    st.data(),
)
def test_valid_files_with_some_bytes_changed(
    file: bytes, changes: list[tuple[int, int]], data: st.DataObject
) -> None:
    changed = bytearray(file)
    for offset, byte in changes:
        changed[offset % len(changed)] = byte
    start = data.draw(st.integers(0, len(changed)))
    del changed[start : start + data.draw(st.integers(0, 12))]
    opens_or_refuses(bytes(changed))
