"""softrod's solver: scenes of masses, linear springs and angular springs, and their motion.

It does not depend on the page; `import sim` is enough to use it in a script:

    import sim

    simulation = sim.Simulation(sim.load_scene("tutorial-3.3"))
    simulation.keys = {"right"}
    simulation.advance(1.0)
    print(simulation.positions)
"""

from .analysis.equilibrium import Vibrations, equilibrium, vibrations
from .errors import InputError, SceneError, SettingError
from .motion.energy import EnergyBook
from .motion.moment import Moment
from .motion.simulation import Divergence, Simulation
from .scene.files import list_scenes, load_scene, save_scene
from .scene.rope import rope
from .scene.types import (
    Anchor,
    AngularSpring,
    ArrowKeys,
    Circle,
    Integrator,
    LinearSpring,
    Mass,
    Pose,
    Rope,
    Scene,
    View,
)
from .scene.validate import validate
from .settings import set_choice, set_value

__all__ = [
    "Anchor",
    "AngularSpring",
    "ArrowKeys",
    "Circle",
    "Divergence",
    "EnergyBook",
    "InputError",
    "Integrator",
    "LinearSpring",
    "Mass",
    "Moment",
    "Pose",
    "Rope",
    "Scene",
    "SceneError",
    "SettingError",
    "Simulation",
    "Vibrations",
    "View",
    "equilibrium",
    "list_scenes",
    "load_scene",
    "rope",
    "save_scene",
    "set_choice",
    "set_value",
    "validate",
    "vibrations",
]
