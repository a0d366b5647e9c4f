"""What the user describes: frozen records, data only."""

from kinetruss.model._bodies import Body, Frame
from kinetruss.model._body_loads import BodyCouple, BodyForce, Pressure
from kinetruss.model._body_mass import body_mass
from kinetruss.model._catalogue import Catalogue, ScrewStock, TubeStock
from kinetruss.model._continua import Membrane, Orthotropic, Solid
from kinetruss.model._drives import (
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
from kinetruss.model._drivetrain import Amplifier, DriveTrain, Gear, LeadScrew, Motor
from kinetruss.model._elastic import natural_length, stiffness
from kinetruss.model._events import Event
from kinetruss.model._faults import coordinate_kinds, faults, trajectory_faults
from kinetruss.model._gauges import Gauge, GaugeZero
from kinetruss.model._inputs import (
    DriveInput,
    DriveLoad,
    ExponentialInput,
    PositionLoop,
    SineInput,
    StepInput,
    TableInput,
)  # fmt: skip
from kinetruss.model._joints import FREEDOMS, GROUND, Hinge, Joint
from kinetruss.model._loads import History, LoadCase, NodalForce
from kinetruss.model._members import Active, Bar, Node, Part, PlanarBody
from kinetruss.model._methods import DOP853, EnergyMomentum, GeneralizedAlpha, Method, Rattle, Solver, Taylor
from kinetruss.model._mission import Catalogues, Group, Mission, Settle, matched, mission_faults
from kinetruss.model._model import Model, Safety
from kinetruss.model._plausibility import plausibility
from kinetruss.model._record import Record
from kinetruss.model._runs import Run
from kinetruss.model._sections import General, Material, Rectangle, Rod, Tube
from kinetruss.model._simulation_faults import event_faults, task_faults, velocity_faults
from kinetruss.model._tasks import MOTOR_TASKS, TRAJECTORY_TASKS, Free, GivenForce, Hold, Task
from kinetruss.model._trajectories import (
    ConstantRate,
    Cyclic,
    Quintic,
    Sine,
    Spline,
    StepResponse,
    Trapezoid,
    moved_by,
)  # fmt: skip
from kinetruss.model._words import nearest

__all__ = [
    "Active", "Amplifier", "AngleDrive", "Bar", "Body", "BodyCouple", "BodyForce", "ConstantRate",
    "CoordinateDrive", "Cyclic", "DriveInput", "DriveLoad",
    "DriveTrain", "ExponentialInput", "Frame", "Gauge", "GaugeZero", "Gear", "General", "GimbalPose", "History", "LeadScrew",
    "LengthDrive", "LoadCase", "Material", "Model", "Motor", "Node", "NodalForce", "Part", "PositionLoop", "Pressure",
    "Quintic", "Record", "Rectangle", "Rod", "Run", "Safety", "Sine", "SineInput", "Spline", "StepInput", "StepResponse",
    "TableInput", "Trapezoid", "Tube",
    "Catalogue", "Catalogues", "Group", "Mission", "ScrewStock", "Settle", "TubeStock", "matched", "mission_faults",
    "DOP853", "EnergyMomentum", "Event", "Free", "GeneralizedAlpha", "GivenForce", "Hold", "MOTOR_TASKS", "Method",
    "PlanarBody", "Rattle", "Solver", "TRAJECTORY_TASKS", "Task", "Taylor",
    "Coupling", "HingeDrive", "OffsetCoordinate", "geared", "turns",
    "event_faults", "natural_length", "stiffness", "task_faults", "velocity_faults",
    "FREEDOMS", "GROUND", "Hinge", "Joint", "body_mass", "coordinate_kinds", "faults", "moved_by", "nearest", "plausibility",
    "Membrane", "Orthotropic", "Solid", "trajectory_faults",
]  # fmt: skip
