"""The model: everything the user describes, by name."""

from __future__ import annotations

from collections.abc import Hashable
from functools import cached_property
from typing import Annotated, Any, Self

from pydantic import AfterValidator, BaseModel, BeforeValidator, Field, ValidationError, WithJsonSchema, model_validator

from kinetruss.errors import Fault, ModelError
from kinetruss.model._collect import Lost, collect, rests_on
from kinetruss.model._library_names import with_library_records
from kinetruss.model._record import GravityVector, Name, Number, Record, VelocityVector
from kinetruss.model._table import Filled, ReadOnly, Table
from kinetruss.model.checks.bodies import body_faults
from kinetruss.model.checks.faults import dimension, faults, misfits
from kinetruss.model.motion.drives import AngleDrive, Coupling, Drive, HingeDrive, LengthDrive, Pose, geared
from kinetruss.model.motion.drivetrain import Amplifier, Gear, LeadScrew, Motor
from kinetruss.model.motion.runs import Run
from kinetruss.model.motion.trajectories import Trajectory
from kinetruss.model.parts.bodies import Body
from kinetruss.model.parts.body_loads import Load
from kinetruss.model.parts.bracing import braced
from kinetruss.model.parts.continua import Membrane, Solid
from kinetruss.model.parts.gauges import Gauge, GaugeZero
from kinetruss.model.parts.joints import Joint
from kinetruss.model.parts.loads import History, LoadCase
from kinetruss.model.parts.members import Active, Bar, Node
from kinetruss.model.parts.sections import Material, MaterialOrName, Section, SectionOrName
from kinetruss.units import shown

__all__ = ["Model", "Safety"]

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


class Safety(Record):
    """Safety factors: allowable stress = yield strength/`yielding`, allowable compression = critical load/`buckling`."""

    yielding: Annotated[Number, Field(ge=1)] = 1.0
    buckling: Annotated[Number, Field(ge=1)] = 1.0


class Model(Record):
    """A mechanism, robot or adaptive structure made of bars.

    Every argument is a mapping from names to records; plain lists stand for nodes and bars
    (``nodes={"A": (0, 0)}``, ``bars={"crank": ("A", "B")}``). Faults are collected and raised at once as `ModelError`.

    fixed : names of nodes held in all axes, or a mapping node -> axes, e.g. ``{"A": "xy"}``.
    bodies : masses in the plane or in space carried by nodes; the bars that hold rigid ones together are added to `bars`.
    joints : records of what `library.joints` has made of nodes and bars.
    membranes, solids : meshes of elastic triangles and tetrahedra on nodes.
    section, material : used by every bar that names none. Here and in its records a name is one of the model's own tables,
        or of the library: ``material="steel_s235"``.
    velocities : of nodes at the start of a simulation, m/s; others rest, or follow these.
    """

    kinetruss: Format = FORMAT
    title: str = ""
    nodes: Filled[Name, Node]
    fixed: Table[Name, Axes] = ReadOnly()
    bars: Table[Name, Bar] = ReadOnly()
    active: Table[Name, Active] = ReadOnly()
    bodies: Table[Name, Body] = ReadOnly()
    joints: Table[Name, Joint] = ReadOnly()
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
    loads: Table[Name, Load] = ReadOnly()
    load_cases: Table[Name, LoadCase] = ReadOnly()
    support_motion: Table[Name, History] = ReadOnly()
    velocities: Table[Name, VelocityVector] = ReadOnly()
    drives: Table[Name, Drive] = ReadOnly()
    couplings: Table[Name, Coupling] = ReadOnly()
    poses: Table[Name, Pose] = ReadOnly()
    trajectories: Table[Name, Trajectory] = ReadOnly()
    runs: Table[Name, Run] = ReadOnly()
    gauges: Table[Name, Gauge] = ReadOnly()
    gauge_zero: GaugeZero | None = None
    safety: Safety = Safety()

    @classmethod
    def _faults(cls, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
        return collect(cls, error, data)

    @model_validator(mode="before")
    @classmethod
    def _fixed_names(cls, value: Any) -> Any:
        fixed = value.get("fixed") if isinstance(value, dict) else None
        if isinstance(fixed, (list, tuple, set, frozenset)) and all(isinstance(name, Hashable) for name in fixed):
            axes = AXES[: _dimension_of(value.get("nodes"))]
            return value | {"fixed": dict.fromkeys(fixed, axes)}
        return value

    @model_validator(mode="before")
    @classmethod
    def _library_names(cls, value: Any) -> Any:
        return with_library_records(value) if isinstance(value, dict) else value

    @model_validator(mode="after")
    def _consistent(self) -> Model:
        odd, fitting = misfits(self)
        # what no longer names a node of another dimension can be judged as far as it goes
        judged = self if not odd else BaseModel.model_copy(self, update={"nodes": fitting})
        if judged.bodies or any(bar.brace for bar in judged.bars.values()):
            judged.__dict__["bars"] = ReadOnly(braced(judged, _faulty_bodies(judged)))
            judged.__pydantic_fields_set__.add("bars")
            judged.__dict__.pop("members", None)  # may have been asked for on the way
        lost = Lost(("nodes", str(fault.path[1])) for fault in odd)
        if found := [*odd, *(fault for fault in faults(judged) if not rests_on(fault, lost))]:
            raise ModelError(found)
        return self

    # -- what follows from the fields ------------------------------------------------------------------------------

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
        """What may hold a drive train: active members, then drives of angles that have a gear or a motor."""
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
        """The trajectory record of a run, or None where it follows a motion file."""
        return self.trajectories[run.trajectory] if isinstance(run.trajectory, str) else run.trajectory

    def with_(self, **changes: Any) -> Self:
        """A new model with some fields changed; all checks run again.

        >>> import kinetruss as kt
        >>> one = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"])
        >>> one.with_(title="a bar").title
        'a bar'
        """
        fields = {name: getattr(self, name) for name in self.model_fields_set}
        return type(self)(**fields | changes)


def _faulty_bodies(model: Model) -> set[str]:
    """Bodies that cannot be braced as they are."""
    dim = dimension(len(node.at) for node in model.nodes.values())
    return {str(fault.path[1]) for fault in body_faults(model, dim)}


def _dimension_of(nodes: Any) -> int:
    """2 or 3, from nodes given in any form; 3 where it cannot be told."""
    counts = []
    for node in nodes.values() if isinstance(nodes, dict) else ():
        at: Any = node.at if isinstance(node, Node) else node.get("at") if isinstance(node, dict) else node
        if hasattr(at, "__len__") and not isinstance(at, str):
            counts.append(len(at))
    return dimension(counts) if counts else 3
