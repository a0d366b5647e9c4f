"""The data of a model by name: its records, and properties derived from them."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated, Any, get_args

from pydantic import AfterValidator, BeforeValidator, ConfigDict, Field, WithJsonSchema

from kinetruss.errors import shown
from kinetruss.model.beams import Beam
from kinetruss.model.bodies import Body
from kinetruss.model.continua import Membrane, Solid
from kinetruss.model.cylinder import Cylinder
from kinetruss.model.deflection_limits import DeflectionLimit
from kinetruss.model.drives import (
    AngleDrive,
    Coupling,
    Drive,
    ElementRecord,
    ForceElement,
    HingeDrive,
    LengthDrive,
    Pose,
    Spring,
    geared,
)
from kinetruss.model.drivetrain import Amplifier, Gear, LeadScrew, Motor
from kinetruss.model.gauges import Gauge, GaugeZero
from kinetruss.model.hubs import Hub
from kinetruss.model.joints import GROUND, Bearing, BodyOrGroundName, Joint
from kinetruss.model.links import Link
from kinetruss.model.load_cases import Combinations, LoadCase, cases_of, of_one_code
from kinetruss.model.loads import History, Load
from kinetruss.model.members import Active, Bar, Brace, Node
from kinetruss.model.quantities import Quantity
from kinetruss.model.record import GravityVector, Name, Number, Record, VelocityVector, one_format
from kinetruss.model.references import NodeName
from kinetruss.model.runs import BaseRotation, Condition, Run
from kinetruss.model.sections import Material, MaterialOrName, Section, SectionOrName
from kinetruss.model.stops import Stop
from kinetruss.model.supports import Support
from kinetruss.model.table import Filled, ReadOnly, Table
from kinetruss.model.trajectories import Trajectory

AXES = "xyz"
FORMAT = 1


def _axes(value: str) -> str:
    if not value or set(value) - set(AXES) or len(set(value)) != len(value):
        raise ValueError(f"{shown(value)} is not a set of axes. Write for example xy, or xyz.")
    return value


Axes = Annotated[str, AfterValidator(_axes), WithJsonSchema({"type": "string", "pattern": "^[xyz]{1,3}$"})]
Format = Annotated[
    int,
    one_format(FORMAT, "kinetruss", "format version {}"),
    WithJsonSchema({"const": FORMAT, "description": "format version"}),
]


def _grounded(value: Any) -> Any:
    """A list names nodes that the ground holds."""
    if isinstance(value, (list, tuple, set, frozenset)) and all(isinstance(name, str) for name in value):
        return dict.fromkeys(value, GROUND)
    return value


Clamps = Annotated[Table[NodeName, BodyOrGroundName], BeforeValidator(_grounded)]


class Safety(Record):
    """Safety factors.

    yielding : allowable stress = yield strength/`yielding`.
    buckling : allowable compression = critical load/`buckling`.
    """

    yielding: Annotated[Number, Field(ge=1)] = 1.0
    buckling: Annotated[Number, Field(ge=1)] = 1.0


class TitleBlock(Record):
    """What the title block of a report says. Empty entries become lines to fill in.

    project, client : for what and for whom it was made.
    number : of the document.
    author, checker : who made and who checked it.
    revision, date : of the document, as text.
    """

    project: str = ""
    client: str = ""
    number: str = ""
    author: str = ""
    checker: str = ""
    revision: str = ""
    date: str = ""


class ModelData(Record):
    """The data of a model, and properties derived from them. `Model` adds the checks.

    The text below a table is its description in the schema, in the model reference and in new model files.
    """

    model_config = ConfigDict(use_attribute_docstrings=True)

    kinetruss: Format = FORMAT
    """Version of the file format."""
    title: str = ""
    """What the model is; the heading of reports and pictures."""
    nodes: Filled[Name, Node]
    """Points by name: place [x, y] or [x, y, z] in the start configuration, or a record with a mass."""
    fixed: Table[NodeName, Axes] = ReadOnly()
    """Supports: a list of nodes, or node -> the axes in which it is held, e.g. xy."""
    bars: Table[Name, Bar] = ReadOnly()
    """Members by name: their two nodes, or a record with kind, section, mass and length. Rigid unless a kind is given."""
    active: Table[Name, Active] = ReadOnly()
    """Active members: a base and a tube with a lead screw, whose length a motor changes."""
    beams: Table[Name, Beam] = ReadOnly()
    """Members that bend and share the rotation of the nodes at which they meet."""
    links: Table[Name, Link] = ReadOnly()
    """Stiff members through two pins or more, straight or bent: their nodes in order, or a record with section and mass."""
    clamped: Clamps = ReadOnly()
    """Nodes of beams whose rotation is held: a list (by the ground), or node -> body."""
    supports: Table[NodeName, Support] = ReadOnly()
    """Supports that hold single translations and rotations of a node: rigid, elastic, turned, with a gap or a settlement."""
    bodies: Table[Name, Body] = ReadOnly()
    """Rigid or straining masses on nodes: mass, centre and inertia."""
    joints: Table[Name, Joint] = ReadOnly()
    """Joints between bodies that `library.joints` has built from nodes and bars."""
    hubs: Table[NodeName, Hub] = ReadOnly()
    """Nodes of finite size: arms from the node to the joints of its members."""
    bearings: Table[Name, Bearing] = ReadOnly()
    """Pins and balls whose friction follows from the force in them."""
    membranes: Table[Name, Membrane] = ReadOnly()
    """Meshes of elastic triangles on nodes."""
    solids: Table[Name, Solid] = ReadOnly()
    """Meshes of elastic tetrahedra on nodes."""
    section: SectionOrName | None = None
    """Cross-section of all bars that name none: a record, or a name."""
    material: MaterialOrName | None = None
    """Material of all bars that name none: a record, or a name, e.g. steel_s235."""
    sections: Table[Name, Section] = ReadOnly()
    """Cross-sections by name, for bars to refer to."""
    materials: Table[Name, Material] = ReadOnly()
    """Materials by name, for bars to refer to."""
    screws: Table[Name, LeadScrew] = ReadOnly()
    """Lead screws by name, for active members and drive trains."""
    gears: Table[Name, Gear] = ReadOnly()
    """Gears by name."""
    motors: Table[Name, Motor] = ReadOnly()
    """Motors by name: torque constant, resistance, inertia, limits."""
    amplifiers: Table[Name, Amplifier] = ReadOnly()
    """Amplifiers of motors by name: largest voltage and current."""
    gravity: GravityVector | None = None
    """Acceleration of gravity as a vector; by default there is none."""
    base_rotation: BaseRotation | None = None
    """Rotation of the base, with all that stands on it."""
    loads: Table[Name, Load] = ReadOnly()
    """Forces, pressures and couples by name: at nodes, on bodies, constant or along time."""
    load_cases: Table[Name, LoadCase] = ReadOnly()
    """Loads and gravity that act together, by name; by default all loads are one case."""
    combinations: Annotated[Table[Name, Combinations], BeforeValidator(of_one_code)] = ReadOnly()
    """Load cases that act together: factors by name, or all combinations of a standard, e.g. {kind: en1990}."""
    conditions: Table[Name, Condition] = ReadOnly()
    """States of missions by name: gravity, base motion, temperature, locked or released members."""
    support_motion: Table[NodeName, History] = ReadOnly()
    """Prescribed motion of fixed nodes."""
    velocities: Table[NodeName, VelocityVector] = ReadOnly()
    """Velocities of nodes at the start of a simulation."""
    drives: Table[Name, Drive] = ReadOnly()
    """What moves, besides active members: lengths, angles and coordinates that a trajectory prescribes."""
    couplings: Table[Name, Coupling] = ReadOnly()
    """Linear relations between drives, e.g. of gears."""
    springs: Table[Name, Spring] = ReadOnly()
    """Springs, dampers, friction and play on lengths and angles."""
    stops: Table[Name, Stop] = ReadOnly()
    """Stops on lengths, angles and other coordinates: a gap, and contact behind it."""
    cylinders: Table[Name, Cylinder] = ReadOnly()
    """Hydraulic cylinders along members or between nodes."""
    poses: Table[Name, Pose] = ReadOnly()
    """Coordinates of a platform or tip by name, for trajectories and tasks."""
    trajectories: Table[Name, Trajectory] = ReadOnly()
    """Motions by name, for runs to refer to."""
    runs: Table[Name, Run] = ReadOnly()
    """Analyses by name: what `kinetruss run` does."""
    quantities: Table[Name, Quantity] = ReadOnly()
    """What to measure of a motion: angles, distances, ratios of rates, as expressions, with limits."""
    deflections: Table[Name, DeflectionLimit] = ReadOnly()
    """Limits of deflections of members, alone or in a row, as a share of the span or a length: e.g. span/300."""
    gauges: Table[Name, Gauge] = ReadOnly()
    """Strain gauges on members."""
    gauge_zero: GaugeZero | None = None
    """State in which the gauges read zero."""
    safety: Safety = Safety()
    """Safety factors against yielding and buckling."""
    report: TitleBlock | None = None
    """Title block of reports: project, client, number, author, checker, revision, date."""

    @property
    def dim(self) -> int:
        """2 or 3."""
        return len(next(iter(self.nodes.values())).at)

    @cached_property
    def bending(self) -> dict[str, Beam | Link]:
        """Beams and links by name."""
        return ReadOnly({**self.beams, **self.links})

    @cached_property
    def cases(self) -> dict[str, LoadCase]:
        """All load cases by name: its own, then the combinations of these."""
        return ReadOnly(cases_of(self))

    @cached_property
    def members(self) -> dict[str, Bar | Active]:
        """All members by name: bars, then active members. Results keep this order."""
        return ReadOnly({**self.bars, **self.active})

    @cached_property
    def driven_members(self) -> frozenset[str]:
        """Members whose length is driven."""
        own = {name for name, bar in self.bars.items() if bar.kind == "driven"} | set(self.active)
        return frozenset(own | {drive.bar for drive in self.drives.values() if isinstance(drive, LengthDrive)})

    @cached_property
    def all_drives(self) -> dict[str, Drive]:
        """Drives by name: one of each driven bar and active member (under the member's own name), then `drives`."""
        own = [name for name, bar in self.bars.items() if bar.kind == "driven"] + list(self.active)
        named = {drive.bar for drive in self.drives.values() if isinstance(drive, LengthDrive)}
        return ReadOnly({name: LengthDrive(name) for name in own if name not in named} | self.drives)

    @cached_property
    def force_elements(self) -> dict[str, tuple[str, Any]]:
        """Elements with a law on a coordinate by name: their kind and record."""
        kinds = ((kind, getattr(self, field).items()) for kind, field in FORCE_ELEMENTS.items())
        return ReadOnly({name: (kind, one) for kind, own in kinds for name, one in own})

    @cached_property
    def actuators(self) -> dict[str, Active | AngleDrive | HingeDrive]:
        """Elements with a drive train: active members, then drives of angles that have a gear or a motor."""
        return ReadOnly({**self.active, **{name: one for name, one in self.drives.items() if geared(one)}})

    def section_of(self, part: Any) -> Any:
        """The section record of a bar or part, or None."""
        chosen = part.section if part.section is not None or isinstance(part, Brace) else self.section
        return self.sections[chosen] if isinstance(chosen, str) else chosen

    def material_of(self, part: Any) -> Material | None:
        """The material record of a bar or part, or None."""
        chosen = part.material if part.material is not None else self.material
        return self.materials[chosen] if isinstance(chosen, str) else chosen

    def trajectory_of(self, run: Run) -> Any:
        """The trajectory record of a run, or None if it follows a motion file."""
        return self.trajectories[run.trajectory] if isinstance(run.trajectory, str) else run.trajectory


_ELEMENTS: dict[str, tuple[str, type]] = {
    record.element: (name, record)
    for name, field in ModelData.model_fields.items()
    for record in get_args(field.annotation)
    if isinstance(record, type) and issubclass(record, ElementRecord)
}
ELEMENT_FIELDS: dict[str, str] = {kind: name for kind, (name, _) in _ELEMENTS.items()}
"""Kinds of elements whose records say so (`element`), and the fields that have them."""
FORCE_ELEMENTS: dict[str, str] = {kind: name for kind, (name, one) in _ELEMENTS.items() if issubclass(one, ForceElement)}
"""Those with a law on a coordinate (kinetruss.elements)."""
