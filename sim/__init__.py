"""softrod's solver: scenes of masses, linear springs and angular springs, and their motion.

Nothing here knows of the page; `import sim` is enough to use it in a script:

    import sim

    simulation = sim.Simulation(sim.load_scene("tutorial-3.3"))
    simulation.keys = {"right"}
    simulation.advance(1.0)
    print(simulation.positions)
"""

from .books import EnergyBook
from .equilibrium import Vibrations, equilibrium, vibrations
from .errors import InputError, SceneError, SettingError
from .files import list_scenes, load_scene, save_scene
from .rope import rope
from .scene import (
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
from .settings import set_choice, set_value
from .simulation import Divergence, Simulation
from .validate import validate

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
