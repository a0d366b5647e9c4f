"""The model: everything the user describes, by name."""

from __future__ import annotations

from typing import Annotated, Any, Literal, Self

from pydantic import Field, ValidationError, field_validator, model_validator

from kinetruss.errors import Fault, ModelError
from kinetruss.model._drives import Drive, LengthDrive, Pose
from kinetruss.model._drivetrain import Gear, LeadScrew, Motor
from kinetruss.model._loads import History, LoadCase, NodalForce
from kinetruss.model._members import Active, Bar, Node
from kinetruss.model._record import GravityVector, Name, Number, Record
from kinetruss.model._runs import Run
from kinetruss.model._sections import Material, Section
from kinetruss.model._trajectories import Trajectory

__all__ = ["Model", "Safety"]

AXES = "xyz"


class Safety(Record):
    """Safety factors: allowable stress = yield strength/`yielding`, allowable compression = critical load/`buckling`."""

    yielding: Annotated[Number, Field(ge=1)] = 1.0
    buckling: Annotated[Number, Field(ge=1)] = 1.0


class Model(Record):
    """A mechanism, robot or adaptive structure made of bars.

    Every argument is a mapping from names to records; plain lists stand for nodes and bars
    (``nodes={"A": (0, 0)}``, ``bars={"crank": ("A", "B")}``). Faults are collected and raised at once as `ModelError`.

    fixed : names of nodes held in all axes, or a mapping node -> axes, e.g. ``{"A": "xy"}``.
    section, material : used by every bar that names none.
    """

    kinetruss: Literal[1] = 1
    title: str = ""
    nodes: Annotated[dict[Name, Node], Field(min_length=1)]
    fixed: dict[Name, str] = {}
    bars: dict[Name, Bar] = {}
    active: dict[Name, Active] = {}
    section: Section | Name | None = None
    material: Material | Name | None = None
    sections: dict[Name, Section] = {}
    materials: dict[Name, Material] = {}
    screws: dict[Name, LeadScrew] = {}
    gears: dict[Name, Gear] = {}
    motors: dict[Name, Motor] = {}
    gravity: GravityVector | None = None
    loads: dict[Name, NodalForce] = {}
    load_cases: dict[Name, LoadCase] = {}
    support_motion: dict[Name, History] = {}
    drives: dict[Name, Drive] = {}
    poses: dict[Name, Pose] = {}
    trajectories: dict[Name, Trajectory] = {}
    runs: dict[Name, Run] = {}
    safety: Safety = Safety()

    def __init__(self, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise ModelError(faults_of(error)) from None

    @model_validator(mode="before")
    @classmethod
    def _fixed_names(cls, value: Any) -> Any:
        if isinstance(value, dict) and isinstance(value.get("fixed"), (list, tuple, set, frozenset)):
            axes = AXES[: _dimension_of(value.get("nodes"))]
            return value | {"fixed": {name: axes for name in value["fixed"]}}
        return value

    @field_validator("fixed")
    @classmethod
    def _axes(cls, value: dict[str, str]) -> dict[str, str]:
        for node, axes in value.items():
            if not axes or set(axes) - set(AXES) or len(set(axes)) != len(axes):
                raise ValueError(f"{axes!r} at node {node!r} is not a set of axes. Write for example 'xy', or 'xyz'.")
        return value

    @model_validator(mode="after")
    def _consistent(self) -> Model:
        from kinetruss.model._faults import faults

        if found := faults(self):
            raise ModelError(found)
        return self

    # -- what follows from the fields ------------------------------------------------------------------------------

    @property
    def dim(self) -> int:
        """2 or 3."""
        return len(next(iter(self.nodes.values())).at)

    @property
    def members(self) -> dict[str, Bar | Active]:
        """All members by name: bars, then active members. Results keep this order."""
        return {**self.bars, **self.active}

    @property
    def all_drives(self) -> dict[str, Drive]:
        """Drives by name: one of each driven bar and active member (under the member's own name), then `drives`."""
        own = [name for name, bar in self.bars.items() if bar.kind == "driven"] + list(self.active)
        named = {drive.bar for drive in self.drives.values() if isinstance(drive, LengthDrive)}
        return {name: LengthDrive(name) for name in own if name not in named} | dict(self.drives)

    def section_of(self, part: Any) -> Any:
        """The section record of a bar or part, or None."""
        chosen = part.section if part.section is not None else self.section
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


def faults_of(error: ValidationError) -> list[Fault]:
    """The faults behind a pydantic error, in the words of this package."""
    return [_fault(item) for item in error.errors(include_url=False, include_context=False)]


def _fault(item: Any) -> Fault:
    path = tuple(item["loc"])
    message = item["msg"].removeprefix("Value error, ")
    mend = {
        "extra_forbidden": "Remove it, or mend its spelling.",
        "missing": "Add it.",
    }.get(item["type"], "")
    if item["type"] == "extra_forbidden":
        message = f"{path[-1]!r} is not known here."
    if item["type"] == "missing":
        message = f"{path[-1]!r} is missing."
    return Fault(path, message, mend)


def _dimension_of(nodes: Any) -> int:
    """2 or 3, from the first node given in any form; 3 where it cannot be told."""
    try:
        first = next(iter(nodes.values()))
        at = first if isinstance(first, (list, tuple)) else first.at if isinstance(first, Node) else first["at"]
        return len(at)
    except (AttributeError, KeyError, StopIteration, TypeError):
        return 3
