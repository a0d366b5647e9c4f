"""The data of a model by name: its records, and properties derived from them."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Field, WithJsonSchema

from kinetruss.model._record import GravityVector, Name, Number, Record, VelocityVector
from kinetruss.model._table import Filled, ReadOnly, Table
from kinetruss.model.beams.record import Beam
from kinetruss.model.hubs.record import Hub
from kinetruss.model.motion.conditions import BaseRotation, Condition
from kinetruss.model.motion.drives import AngleDrive, Coupling, Drive, HingeDrive, LengthDrive, Pose, geared
from kinetruss.model.motion.drivetrain import Amplifier, Gear, LeadScrew, Motor
from kinetruss.model.motion.runs import Run
from kinetruss.model.motion.springs import Spring
from kinetruss.model.motion.trajectories import Trajectory
from kinetruss.model.parts.bodies import Body
from kinetruss.model.parts.body_loads import Load
from kinetruss.model.parts.continua import Membrane, Solid
from kinetruss.model.parts.gauges import Gauge, GaugeZero
from kinetruss.model.parts.joints import GROUND, Bearing, Joint
from kinetruss.model.parts.loads import History, LoadCase
from kinetruss.model.parts.members import Active, Bar, Node
from kinetruss.model.parts.sections import Material, MaterialOrName, Section, SectionOrName
from kinetruss.units import shown

__all__ = ["AXES", "FORMAT", "ModelData", "Safety"]

AXES = "xyz"
FORMAT = 1


def _format(value: Any) -> Any:
    if value not in (FORMAT, str(FORMAT)) or isinstance(value, bool):
        raise ValueError(f"format version {shown(value)} is not known here. This release reads kinetruss: {FORMAT}.")
    return FORMAT


def _axes(value: str) -> str:
    if not value or set(value) - set(AXES) or len(set(value)) != len(value):
        raise ValueError(f"{shown(value)} is not a set of axes. Write for example xy, or xyz.")
    return value


Axes = Annotated[str, AfterValidator(_axes), WithJsonSchema({"type": "string", "pattern": "^[xyz]{1,3}$"})]
Format = Annotated[int, BeforeValidator(_format), WithJsonSchema({"const": FORMAT, "description": "format version"})]


def _grounded(value: Any) -> Any:
    """A list names nodes that the ground holds."""
    if isinstance(value, (list, tuple, set, frozenset)) and all(isinstance(name, str) for name in value):
        return dict.fromkeys(value, GROUND)
    return value


Clamps = Annotated[Table[Name, Name], BeforeValidator(_grounded)]


class Safety(Record):
    """Safety factors: allowable stress = yield strength/`yielding`, allowable compression = critical load/`buckling`."""

    yielding: Annotated[Number, Field(ge=1)] = 1.0
    buckling: Annotated[Number, Field(ge=1)] = 1.0


class ModelData(Record):
    """The data of a model, and properties derived from them. `Model` adds the checks."""

    kinetruss: Format = FORMAT
    title: str = ""
    nodes: Filled[Name, Node]
    fixed: Table[Name, Axes] = ReadOnly()
    bars: Table[Name, Bar] = ReadOnly()
    active: Table[Name, Active] = ReadOnly()
    beams: Table[Name, Beam] = ReadOnly()
    clamped: Clamps = ReadOnly()
    bodies: Table[Name, Body] = ReadOnly()
    joints: Table[Name, Joint] = ReadOnly()
    hubs: Table[Name, Hub] = ReadOnly()
    bearings: Table[Name, Bearing] = ReadOnly()
    membranes: Table[Name, Membrane] = ReadOnly()
    solids: Table[Name, Solid] = ReadOnly()
    section: SectionOrName | None = None
    material: MaterialOrName | None = None
    sections: Table[Name, Section] = ReadOnly()
    materials: Table[Name, Material] = ReadOnly()
    screws: Table[Name, LeadScrew] = ReadOnly()
    gears: Table[Name, Gear] = ReadOnly()
    motors: Table[Name, Motor] = ReadOnly()
    amplifiers: Table[Name, Amplifier] = ReadOnly()
    gravity: GravityVector | None = None
    base_rotation: BaseRotation | None = None
    loads: Table[Name, Load] = ReadOnly()
    load_cases: Table[Name, LoadCase] = ReadOnly()
    conditions: Table[Name, Condition] = ReadOnly()
    support_motion: Table[Name, History] = ReadOnly()
    velocities: Table[Name, VelocityVector] = ReadOnly()
    drives: Table[Name, Drive] = ReadOnly()
    couplings: Table[Name, Coupling] = ReadOnly()
    springs: Table[Name, Spring] = ReadOnly()
    poses: Table[Name, Pose] = ReadOnly()
    trajectories: Table[Name, Trajectory] = ReadOnly()
    runs: Table[Name, Run] = ReadOnly()
    gauges: Table[Name, Gauge] = ReadOnly()
    gauge_zero: GaugeZero | None = None
    safety: Safety = Safety()

    @property
    def dim(self) -> int:
        """2 or 3."""
        return len(next(iter(self.nodes.values())).at)

    @cached_property
    def members(self) -> dict[str, Bar | Active]:
        """All members by name: bars, then active members. Results keep this order."""
        return ReadOnly({**self.bars, **self.active})

    @property
    def driven_members(self) -> set[str]:
        """Members whose length is driven."""
        own = {name for name, bar in self.bars.items() if bar.kind == "driven"} | set(self.active)
        return own | {drive.bar for drive in self.drives.values() if isinstance(drive, LengthDrive)}

    @cached_property
    def all_drives(self) -> dict[str, Drive]:
        """Drives by name: one of each driven bar and active member (under the member's own name), then `drives`."""
        own = [name for name, bar in self.bars.items() if bar.kind == "driven"] + list(self.active)
        named = {drive.bar for drive in self.drives.values() if isinstance(drive, LengthDrive)}
        return ReadOnly({name: LengthDrive(name) for name in own if name not in named} | self.drives)

    @cached_property
    def actuators(self) -> dict[str, Active | AngleDrive | HingeDrive]:
        """Elements with a drive train: active members, then drives of angles that have a gear or a motor."""
        return ReadOnly({**self.active, **{name: one for name, one in self.drives.items() if geared(one)}})

    def section_of(self, part: Any) -> Any:
        """The section record of a bar or part, or None."""
        brace = isinstance(part, Bar) and part.brace
        chosen = part.section if part.section is not None or brace else self.section
        return self.sections[chosen] if isinstance(chosen, str) else chosen

    def material_of(self, part: Any) -> Material | None:
        """The material record of a bar or part, or None."""
        chosen = part.material if part.material is not None else self.material
        return self.materials[chosen] if isinstance(chosen, str) else chosen

    def trajectory_of(self, run: Run) -> Any:
        """The trajectory record of a run, or None if it follows a motion file."""
        return self.trajectories[run.trajectory] if isinstance(run.trajectory, str) else run.trajectory
