"""The features of a page, in the order in which they start."""

from __future__ import annotations

from collections.abc import Mapping

from ...features.access.feature import AccessFeature
from ...features.classroom import messages  # noqa: F401  a class's roles receive them
from ...features.describe.feature import DescribeFeature
from ...features.edit.feature import EditFeature
from ...features.files.feature import FilesFeature
from ...features.fit.feature import FitFeature
from ...features.gallery.feature import GalleryFeature
from ...features.hands.feature import HandsFeature
from ...features.instruments.feature import InstrumentsFeature
from ...features.lesson.feature import LessonFeature
from ...features.making.feature import MakingFeature
from ...features.measure.feature import MeasureFeature
from ...features.modes.feature import ModesFeature
from ...features.muscles.feature import MusclesFeature
from ...features.play.feature import PlayFeature
from ...features.race.feature import RaceFeature
from ...features.reading.feature import ReadingFeature
from ...features.solver.feature import SolverFeature
from ...features.time.feature import TimeFeature
from ...features.view.feature import ViewFeature
from ...ui.commands import Row
from ...ui.feature import Feature

FEATURES: tuple[type[Feature], ...] = (
    TimeFeature,
    LessonFeature,
    PlayFeature,
    MeasureFeature,
    InstrumentsFeature,
    FitFeature,
    SolverFeature,
    FilesFeature,
    GalleryFeature,
    MusclesFeature,
    ModesFeature,
    RaceFeature,
    MakingFeature,
    EditFeature,
    ViewFeature,
    AccessFeature,
    ReadingFeature,
    DescribeFeature,
    HandsFeature,
)

COMMANDS: Mapping[str, Row] = {name: row for feature in FEATURES for name, row in feature.commands.items()}
"""Find anything by their names, in the order of the palette and the help."""

CONTROLS: Mapping[str, str] = {name: text for feature in FEATURES for name, text in feature.controls.items()}
"""All controls by their names, with descriptions."""
