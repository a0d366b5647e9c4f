"""What the user describes: frozen records, data only."""

from kinetruss.model._catalogue import Catalogue, ScrewStock, TubeStock
from kinetruss.model._collect import Lost, rests_on
from kinetruss.model._data import FORMAT
from kinetruss.model._mission import Catalogues, Group, Mission, Settle, matched, mission_faults
from kinetruss.model._model import Model, Safety
from kinetruss.model._plausibility import plausibility
from kinetruss.model._record import (
    Angle,
    Count,
    Flag,
    Force,
    ForceVector,
    GravityVector,
    Length,
    Mass,
    Name,
    Number,
    Of,
    Point,
    PositiveLength,
    PositiveTime,
    Record,
    Series,
)
from kinetruss.model._words import nearest
from kinetruss.model.checks.faults import faults, trajectory_faults
from kinetruss.model.checks.simulation import event_faults, task_faults
from kinetruss.model.motion.drives import (
    AngleDrive,
    CoordinateDrive,
    Coupling,
    GimbalPose,
    HingeDrive,
    LengthDrive,
    OffsetCoordinate,
    geared,
    turns,
)
from kinetruss.model.motion.drivetrain import Amplifier, DriveTrain, Gear, LeadScrew, Motor
from kinetruss.model.motion.events import Event
from kinetruss.model.motion.inputs import (
    DriveInput,
    DriveLoad,
    ExponentialInput,
    PositionLoop,
    SineInput,
    StepInput,
    TableInput,
)
from kinetruss.model.motion.methods import (
    DOP853,
    ERROR_CONTROLLED,
    EnergyMomentum,
    GeneralizedAlpha,
    Method,
    Radau,
    Rattle,
    Taylor,
)
from kinetruss.model.motion.runs import Run
from kinetruss.model.motion.tasks import MOTOR_TASKS, TRAJECTORY_TASKS, Free, GivenForce, Hold
from kinetruss.model.motion.trajectories import (
    ConstantRate,
    Cyclic,
    Quintic,
    Sine,
    Spline,
    StepResponse,
    Trapezoid,
    moved_by,
)
from kinetruss.model.parts.bodies import Body, Frame
from kinetruss.model.parts.body_loads import BodyCouple, BodyForce, Pressure
from kinetruss.model.parts.body_mass import body_mass
from kinetruss.model.parts.continua import Membrane, Orthotropic, Solid
from kinetruss.model.parts.elastic import natural_length, stiffness
from kinetruss.model.parts.gauges import Gauge, GaugeZero
from kinetruss.model.parts.joints import GROUND, Hinge, Joint
from kinetruss.model.parts.loads import History, LoadCase, NodalForce
from kinetruss.model.parts.members import Active, Bar, Node, Part, PlanarBody
from kinetruss.model.parts.sections import General, Material, Rectangle, Rod, Tube

__all__ = [
    "Active", "Amplifier", "AngleDrive", "Bar", "Body", "BodyCouple", "BodyForce", "ConstantRate",
    "CoordinateDrive", "Cyclic", "DriveInput", "DriveLoad",
    "DriveTrain", "ExponentialInput", "Frame", "Gauge", "GaugeZero", "Gear", "General", "GimbalPose", "History", "LeadScrew",
    "LengthDrive", "LoadCase", "Material", "Model", "Motor", "Node", "NodalForce", "Part", "PositionLoop", "Pressure",
    "Quintic", "Record", "Rectangle", "Rod", "Run", "Safety", "Sine", "SineInput", "Spline", "StepInput", "StepResponse",
    "TableInput", "Trapezoid", "Tube",
    "Catalogue", "Catalogues", "Group", "Mission", "ScrewStock", "Settle", "TubeStock", "matched", "mission_faults",
    "DOP853", "EnergyMomentum", "Event", "Free", "GeneralizedAlpha", "GivenForce", "Hold", "MOTOR_TASKS", "Method",
    "ERROR_CONTROLLED", "PlanarBody", "Radau", "Rattle", "TRAJECTORY_TASKS", "Taylor",
    "Coupling", "HingeDrive", "OffsetCoordinate", "geared", "turns",
    "event_faults", "natural_length", "stiffness", "task_faults",
    "GROUND", "Hinge", "Joint", "body_mass", "faults", "moved_by", "nearest", "plausibility",
    "Membrane", "Orthotropic", "Solid", "trajectory_faults",
    "Angle", "Count", "Flag", "Force", "ForceVector", "GravityVector", "Length", "Mass", "Name", "Number", "Of", "Point",
    "PositiveLength", "PositiveTime", "Series", "FORMAT", "Lost", "rests_on",
]  # fmt: skip
