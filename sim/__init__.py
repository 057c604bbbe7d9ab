"""softrod's solver: scenes of masses, linear springs and angular springs, and their motion.

It does not depend on the page; `import sim` is enough to use it in a script:

    import sim

    simulation = sim.Simulation(sim.load_scene("tutorial-3.3"))
    simulation.keys = {"right"}
    simulation.advance(1.0)
    print(simulation.positions)
"""

from .analysis.equilibrium import equilibrium
from .analysis.predictability import Predictability, predictability
from .analysis.tuning import Tuning, Vibration, tuning
from .analysis.vibrations import Vibrations, vibrations
from .design.fit import Fit, fit
from .design.keep_shape import DesignError, keep_shape
from .design.measurements import Measurement, read_measurements
from .design.sensitivity import Sensitivity, sensitivities
from .design.tune import damp_vibration, make_stable
from .design.wishes import Design, set_wishes
from .errors import InputError, SceneError, SettingError
from .motion.energy import Energies
from .motion.many import Run, run_many
from .motion.moment import Moment
from .motion.quantities import KINDS as QUANTITIES
from .motion.quantities import Quantity, quantity
from .motion.recording import Recording
from .motion.simulation import Divergence, Simulation
from .scene.makers import (
    air_balloon,
    box,
    bridge,
    cloth,
    flag_pole,
    girder,
    hair_tuft,
    hand,
    heart,
    jelly,
    polygon,
    rod,
    rope,
    swimmer,
    tree,
    walker,
    water_balloon,
    worm,
)
from .scene.parts import Beat, JointMuscle, SpringMuscle
from .scene.recipes.creatures import Hand, Heart, Swimmer, Walker, Worm
from .scene.recipes.outlines import AirBalloon, Box, Polygon, WaterBalloon
from .scene.recipes.plants import HairTuft, Tree
from .scene.recipes.rods import Rod
from .scene.recipes.sheets import Cloth, FlagPole, Jelly
from .scene.recipes.trusses import Bridge, Girder
from .scene.surroundings import Contact, Gas, Ground, Liquid, Medium, Wall, Wind
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
from .store.files import list_scenes, load_scene, save_scene

__all__ = [
    "QUANTITIES",
    "AirBalloon",
    "Anchor",
    "AngularSpring",
    "ArrowKeys",
    "Beat",
    "Box",
    "Bridge",
    "Circle",
    "Cloth",
    "Contact",
    "Design",
    "DesignError",
    "Divergence",
    "Energies",
    "Fit",
    "FlagPole",
    "Gas",
    "Girder",
    "Ground",
    "HairTuft",
    "Hand",
    "Heart",
    "InputError",
    "Integrator",
    "Jelly",
    "JointMuscle",
    "LinearSpring",
    "Liquid",
    "Mass",
    "Measurement",
    "Medium",
    "Moment",
    "Polygon",
    "Pose",
    "Predictability",
    "Quantity",
    "Recording",
    "Rod",
    "Rope",
    "Run",
    "Scene",
    "SceneError",
    "Sensitivity",
    "SettingError",
    "Simulation",
    "SpringMuscle",
    "Swimmer",
    "Tree",
    "Tuning",
    "Vibration",
    "Vibrations",
    "View",
    "Walker",
    "Wall",
    "WaterBalloon",
    "Wind",
    "Worm",
    "air_balloon",
    "box",
    "bridge",
    "cloth",
    "damp_vibration",
    "equilibrium",
    "fit",
    "flag_pole",
    "girder",
    "hair_tuft",
    "hand",
    "heart",
    "jelly",
    "keep_shape",
    "list_scenes",
    "load_scene",
    "make_stable",
    "polygon",
    "predictability",
    "quantity",
    "read_measurements",
    "rod",
    "rope",
    "run_many",
    "save_scene",
    "sensitivities",
    "set_choice",
    "set_value",
    "set_wishes",
    "swimmer",
    "tree",
    "tuning",
    "validate",
    "vibrations",
    "walker",
    "water_balloon",
    "worm",
]
