"""kinetruss: mechanisms, parallel robots and adaptive structures made of bars.

Nouns (`Model`, `Bar`, `Tube`, ...) are frozen records; verbs live in the package of their question:
`kinematics`, `dynamics`, `strength`, `actuators`. Parts are imported when first used. `kernels` and `mechanics` are inside the
house: they may change without notice.
"""

from __future__ import annotations

import importlib
import sys
from functools import partial
from typing import Any

from kinetruss.late import late
from kinetruss.shelves import put_up

__version__ = "0.1.0"

_PACKAGES = (
    "actuators design dynamics errors exchange flexible io kinematics library model notebook report results runs "
    "statics strength studio units verification viewer "
)
_NAMES = {
    "model": (
        "BaseRotation Bearing Catalogue Compliance Condition Mission DOP853 Elastic EnergyMomentum Event Free GeneralizedAlpha "
        "GivenForce Hold "
        "Hinge Hub Joint Membrane Orthotropic PlanarBody Radau Rattle Solid Spring Taylor Coupling HingeDrive "
        "OffsetCoordinate Active "
        "Amplifier AngleDrive Bar Beam Body BodyCouple BodyForce ConstantRate CoordinateDrive CosineCoordinate Cyclic "
        "DriveLoad "
        "DriveTrain Bridge ExponentialInput Frame Gauge GaugeZero Gear General GimbalPose History LeadScrew "
        "LengthDrive LoadCase Material Measured Model Motor Node NodalForce Part PointMass PositionLoop Pressure Quintic "
        "Circle Combined Coordinates Docking Gimbal Pointing Positioning Reflecting Way "
        "Rectangle Rod Run Safety Sine SineInput Spline StepInput StepResponse TableInput TitleBlock Trapezoid Tube "
    ),
    "io": "read write",
    "kinematics": "check notes",
    "kinematics.conditions": "under",
    "dynamics.prescribed": "prepare",
    "runs": "run",
    "results": "Status",
    "errors": ("AnalysisError Fault FrozenError InputError Interrupted KinetrussError ModelError StoreError UnitError "),
}
_SHELVES = {
    "sections": ("sections", "SECTIONS"),
    "materials": ("materials", "MATERIALS"),
    "screws": ("drives", "SCREWS"),
    "gears": ("drives", "GEARS"),
    "motors": ("drives", "MOTORS"),
    "amplifiers": ("drives", "AMPLIFIERS"),
}
"""Table of a model -> module of the library and its table."""


def _shelf(module: str, table: str) -> Any:
    return getattr(importlib.import_module(f"kinetruss.library.{module}"), table)


for _table, _place in _SHELVES.items():
    put_up(_table, partial(_shelf, *_place))

__all__ = sorted([*(name for names in _NAMES.values() for name in names.split()), *_PACKAGES.split(), "__version__"])
__getattr__, __dir__ = late(__name__, _NAMES, _PACKAGES)


def load_ipython_extension(shell: Any) -> None:
    """``%load_ext kinetruss`` in a notebook: models, runs and results are shown as pictures."""
    importlib.import_module("kinetruss.notebook").register(shell)


if "IPython" in sys.modules and (_shell := sys.modules["IPython"].get_ipython()) is not None:
    load_ipython_extension(_shell)  # so that no notebook needs %load_ext
