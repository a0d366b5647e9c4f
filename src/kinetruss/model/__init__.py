"""Classes for describing a model. All are immutable."""

from typing import TYPE_CHECKING

from kinetruss.late import late

if TYPE_CHECKING:
    from kinetruss.model.beams import Beam as Beam
    from kinetruss.model.bodies import Body as Body, Frame as Frame, body_mass as body_mass
    from kinetruss.model.catalogues import Catalogue as Catalogue, ScrewStock as ScrewStock, TubeStock as TubeStock
    from kinetruss.model.checks import faults as faults, trajectory_faults as trajectory_faults
    from kinetruss.model.collecting import Lost as Lost, rests_on as rests_on
    from kinetruss.model.continua import Membrane as Membrane, Orthotropic as Orthotropic, Solid as Solid
    from kinetruss.model.cylinder import Cylinder as Cylinder
    from kinetruss.model.data import FORMAT as FORMAT, Safety as Safety, TitleBlock as TitleBlock
    from kinetruss.model.deflection_limits import DeflectionLimit as DeflectionLimit
    from kinetruss.model.description import contents as contents, field_texts as field_texts
    from kinetruss.model.drives import (
        AngleDrive as AngleDrive,
        CoordinateDrive as CoordinateDrive,
        CosineCoordinate as CosineCoordinate,
        Coupling as Coupling,
        DistanceCoordinate as DistanceCoordinate,
        GimbalPose as GimbalPose,
        HingeDrive as HingeDrive,
        LengthDrive as LengthDrive,
        OffsetCoordinate as OffsetCoordinate,
        Spring as Spring,
        geared as geared,
        turns as turns,
    )
    from kinetruss.model.drivetrain import (
        Amplifier as Amplifier,
        DriveTrain as DriveTrain,
        Gear as Gear,
        LeadScrew as LeadScrew,
        Motor as Motor,
    )
    from kinetruss.model.gauges import Bridge as Bridge, Gauge as Gauge, GaugeZero as GaugeZero
    from kinetruss.model.hubs import Hub as Hub
    from kinetruss.model.inner import Owner as Owner
    from kinetruss.model.inputs import (
        DriveInput as DriveInput,
        DriveLoad as DriveLoad,
        ExponentialInput as ExponentialInput,
        PositionLoop as PositionLoop,
        SineInput as SineInput,
        StepInput as StepInput,
        TableInput as TableInput,
    )
    from kinetruss.model.joints import GROUND as GROUND, Bearing as Bearing, Hinge as Hinge, Joint as Joint
    from kinetruss.model.links import (
        Link as Link,
        Piece as Piece,
        bars_as_links as bars_as_links,
    )
    from kinetruss.model.load_cases import (
        Asce7 as Asce7,
        Combination as Combination,
        En1990 as En1990,
        LoadCase as LoadCase,
    )
    from kinetruss.model.load_checks import loads_along_beams as loads_along_beams
    from kinetruss.model.loads import (
        ALONG as ALONG,
        BodyCouple as BodyCouple,
        BodyForce as BodyForce,
        History as History,
        NodalForce as NodalForce,
        Pressure as Pressure,
    )
    from kinetruss.model.loads_along import (
        MemberCouple as MemberCouple,
        MemberLoad as MemberLoad,
        MemberPointCouple as MemberPointCouple,
        MemberPointForce as MemberPointForce,
    )
    from kinetruss.model.members import (
        Active as Active,
        Bar as Bar,
        Compliance as Compliance,
        Node as Node,
        Part as Part,
        PlanarBody as PlanarBody,
        PointMass as PointMass,
        natural_length as natural_length,
        stiffness as stiffness,
    )
    from kinetruss.model.mission import (
        Catalogues as Catalogues,
        Group as Group,
        Mission as Mission,
        Settle as Settle,
        mission_faults as mission_faults,
    )
    from kinetruss.model.optimum import (
        OptimumLimit as OptimumLimit,
        OptimumTask as OptimumTask,
        OptimumVariable as OptimumVariable,
    )
    from kinetruss.model.plausible import plausibility as plausibility, turned_far as turned_far
    from kinetruss.model.quantities import Quantity as Quantity
    from kinetruss.model.record import (
        Angle as Angle,
        Count as Count,
        Flag as Flag,
        Force as Force,
        ForceVector as ForceVector,
        GravityVector as GravityVector,
        Length as Length,
        Mass as Mass,
        Name as Name,
        Number as Number,
        Of as Of,
        Point as Point,
        PositiveLength as PositiveLength,
        PositiveNumber as PositiveNumber,
        PositiveTime as PositiveTime,
        Record as Record,
        Series as Series,
        Whole as Whole,
        short_form as short_form,
    )
    from kinetruss.model.references import matched as matched
    from kinetruss.model.run_checks import (
        condition_faults as condition_faults,
        event_faults as event_faults,
        task_faults as task_faults,
    )
    from kinetruss.model.runs import BaseRotation as BaseRotation, Condition as Condition, Elastic as Elastic, Run as Run
    from kinetruss.model.sections import (
        General as General,
        Material as Material,
        Rectangle as Rectangle,
        Rod as Rod,
        Tube as Tube,
    )
    from kinetruss.model.simulation import (
        DOP853 as DOP853,
        ERROR_CONTROLLED as ERROR_CONTROLLED,
        MOTOR_TASKS as MOTOR_TASKS,
        TRAJECTORY_TASKS as TRAJECTORY_TASKS,
        EnergyMomentum as EnergyMomentum,
        Event as Event,
        Free as Free,
        GeneralizedAlpha as GeneralizedAlpha,
        GivenForce as GivenForce,
        Hold as Hold,
        Method as Method,
        Radau as Radau,
        Rattle as Rattle,
        Taylor as Taylor,
    )
    from kinetruss.model.stops import Stop as Stop
    from kinetruss.model.supports import Restraint as Restraint, Support as Support, support_words as support_words
    from kinetruss.model.table import Filled as Filled, ReadOnly as ReadOnly, Table as Table
    from kinetruss.model.targets import (
        TARGETS as TARGETS,
        Circle as Circle,
        Combined as Combined,
        Coordinates as Coordinates,
        Docking as Docking,
        Gimbal as Gimbal,
        Pointing as Pointing,
        Positioning as Positioning,
        Reflecting as Reflecting,
        Way as Way,
        target_faults as target_faults,
    )
    from kinetruss.model.the_model import Model as Model
    from kinetruss.model.tracking import Tracking as Tracking
    from kinetruss.model.trajectories import (
        ConstantRate as ConstantRate,
        Cyclic as Cyclic,
        Measured as Measured,
        Quintic as Quintic,
        Sine as Sine,
        Spline as Spline,
        StepResponse as StepResponse,
        Tabulated as Tabulated,
        Trapezoid as Trapezoid,
        moved_by as moved_by,
    )
    from kinetruss.model.whole import Inner as Inner, WholeModel as WholeModel
    from kinetruss.model.words import in_python as in_python, nearest as nearest, of_file as of_file

__getattr__, __dir__, __all__ = late(__name__)
