"""kinetruss: mechanisms, parallel robots and adaptive structures made of bars.

Nouns (`Model`, `Bar`, `Tube`, ...) are frozen records; verbs live in the package of their question:
`kinematics`, `dynamics`, `strength`, `actuators`. Parts are imported when first used. `kernels` and `mechanics` are inside the
house: they may change without notice.
"""

from __future__ import annotations

import importlib
import sys
from functools import partial
from typing import TYPE_CHECKING, Any

from kinetruss.late import late
from kinetruss.shelves import put_up

if TYPE_CHECKING:
    from kinetruss import (
        actuators as actuators,
        design as design,
        dynamics as dynamics,
        errors as errors,
        exchange as exchange,
        flexible as flexible,
        gradients as gradients,
        io as io,
        kinematics as kinematics,
        library as library,
        model as model,
        notebook as notebook,
        report as report,
        results as results,
        runs as runs,
        statics as statics,
        strength as strength,
        studies as studies,
        studio as studio,
        units as units,
        verification as verification,
        viewer as viewer,
    )
    from kinetruss.dynamics.prepared import prepare as prepare
    from kinetruss.errors import (
        AnalysisError as AnalysisError,
        Fault as Fault,
        FrozenError as FrozenError,
        InputError as InputError,
        Interrupted as Interrupted,
        KinetrussError as KinetrussError,
        ModelError as ModelError,
        StoreError as StoreError,
        UnitError as UnitError,
    )
    from kinetruss.gradients.derivatives import (
        Response as Response,
        check_gradient as check_gradient,
        gradient as gradient,
        value_and_gradient as value_and_gradient,
    )
    from kinetruss.io import read as read, write as write
    from kinetruss.kinematics import check as check, notes as notes
    from kinetruss.kinematics.conditions import under as under
    from kinetruss.model import (
        DOP853 as DOP853,
        Active as Active,
        Amplifier as Amplifier,
        AngleDrive as AngleDrive,
        Asce7 as Asce7,
        Bar as Bar,
        BaseRotation as BaseRotation,
        Beam as Beam,
        Bearing as Bearing,
        Body as Body,
        BodyCouple as BodyCouple,
        BodyForce as BodyForce,
        Bridge as Bridge,
        Catalogue as Catalogue,
        Circle as Circle,
        Combination as Combination,
        Combined as Combined,
        Compliance as Compliance,
        Condition as Condition,
        ConstantRate as ConstantRate,
        CoordinateDrive as CoordinateDrive,
        Coordinates as Coordinates,
        CosineCoordinate as CosineCoordinate,
        Coupling as Coupling,
        Cyclic as Cyclic,
        Cylinder as Cylinder,
        DeflectionLimit as DeflectionLimit,
        DistanceCoordinate as DistanceCoordinate,
        Docking as Docking,
        DriveLoad as DriveLoad,
        DriveTrain as DriveTrain,
        Elastic as Elastic,
        En1990 as En1990,
        EnergyMomentum as EnergyMomentum,
        Event as Event,
        ExponentialInput as ExponentialInput,
        Frame as Frame,
        Free as Free,
        Gauge as Gauge,
        GaugeZero as GaugeZero,
        Gear as Gear,
        General as General,
        GeneralizedAlpha as GeneralizedAlpha,
        Gimbal as Gimbal,
        GimbalPose as GimbalPose,
        GivenForce as GivenForce,
        Hinge as Hinge,
        HingeDrive as HingeDrive,
        History as History,
        Hold as Hold,
        Hub as Hub,
        Joint as Joint,
        LeadScrew as LeadScrew,
        LengthDrive as LengthDrive,
        Link as Link,
        LoadCase as LoadCase,
        Material as Material,
        Measured as Measured,
        MemberCouple as MemberCouple,
        MemberLoad as MemberLoad,
        MemberPointCouple as MemberPointCouple,
        MemberPointForce as MemberPointForce,
        Membrane as Membrane,
        Mission as Mission,
        Model as Model,
        Motor as Motor,
        NodalForce as NodalForce,
        Node as Node,
        OffsetCoordinate as OffsetCoordinate,
        OptimumLimit as OptimumLimit,
        OptimumTask as OptimumTask,
        OptimumVariable as OptimumVariable,
        Orthotropic as Orthotropic,
        Part as Part,
        PlanarBody as PlanarBody,
        Pointing as Pointing,
        PointMass as PointMass,
        Positioning as Positioning,
        PositionLoop as PositionLoop,
        Pressure as Pressure,
        Quantity as Quantity,
        Quintic as Quintic,
        Radau as Radau,
        Rattle as Rattle,
        Rectangle as Rectangle,
        Reflecting as Reflecting,
        Restraint as Restraint,
        Rod as Rod,
        Run as Run,
        Safety as Safety,
        Sine as Sine,
        SineInput as SineInput,
        Solid as Solid,
        Spline as Spline,
        Spring as Spring,
        StepInput as StepInput,
        StepResponse as StepResponse,
        Stop as Stop,
        Support as Support,
        TableInput as TableInput,
        Taylor as Taylor,
        TitleBlock as TitleBlock,
        Tracking as Tracking,
        Trapezoid as Trapezoid,
        Tube as Tube,
        Way as Way,
    )
    from kinetruss.results import Status as Status
    from kinetruss.runs import run as run

__version__ = "0.1.0"

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

__getattr__, __dir__, __all__ = late(__name__)
__all__ += ["__version__"]


def load_ipython_extension(shell: Any) -> None:
    """``%load_ext kinetruss`` in a notebook: models, runs and results are shown as pictures."""
    importlib.import_module("kinetruss.notebook").register(shell)


if "IPython" in sys.modules and (_shell := sys.modules["IPython"].get_ipython()) is not None:
    load_ipython_extension(_shell)  # so that no notebook needs %load_ext
