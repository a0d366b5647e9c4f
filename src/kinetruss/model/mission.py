"""The mission of a sizing: runs and load cases to withstand, and catalogues to choose from."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import Field, Tag, ValidationError, WithJsonSchema, model_validator

from kinetruss.errors import Fault
from kinetruss.model.catalogues import Catalogue, CatalogueText
from kinetruss.model.data import Safety
from kinetruss.model.members import Active
from kinetruss.model.record import Flag, Name, NameOrRecord, Number, Record, Whole, one_format
from kinetruss.model.references import LoadCaseNames, matched, unknown_names
from kinetruss.model.table import Filled
from kinetruss.model.the_model import Model
from kinetruss.model.words import faults_of, nearest

FORMAT = 1

Patterns = Annotated[tuple[str, ...], Field(min_length=1)]
"""Names of members, or patterns with ``*``, ``?`` and ``[..]``, e.g. ``B?.M[1-6]``."""

CatalogueOrName = Annotated[Annotated[Catalogue, Tag("record")] | Annotated[CatalogueText, Tag("name")], NameOrRecord]


class Group(Record):
    """Members with the same tube; for an active member, the tube rod. A plain list of members is enough.

    tubes : a catalogue for this group alone.
    """

    members: Patterns
    tubes: CatalogueOrName | None = None

    @model_validator(mode="before")
    @classmethod
    def _from_list(cls, value: Any) -> Any:
        if isinstance(value, str):
            return {"members": (value,)}
        return {"members": value} if isinstance(value, (list, tuple)) else value


class Catalogues(Record):
    """The catalogues to choose from: names of built-in ones, paths of TOML files, or records. None: not sized."""

    tubes: CatalogueOrName | None = None
    screws: CatalogueOrName | None = None
    gears: CatalogueOrName | None = None
    motors: CatalogueOrName | None = None


class Settle(Record):
    """Convergence of a sizing: at most `passes` of masses fed back into the forces; `tolerance` is the largest relative
    difference between the member forces of the last pass and those of the finished model.
    """

    passes: Annotated[Whole, Field(ge=2, le=10_000)] = 60
    tolerance: Annotated[Number, Field(gt=0, le=0.01)] = 1e-9


class Mission(Record):
    """The mission of a sizing.

    runs : names of runs of the model; None: all. load_cases : names; None: those of each run.
    groups : name -> members that share a tube; None: the longerons, battens and actuators of every bay of a double-octahedral
        truss, else members of one section. drives : name -> active members that share screw, gear and motor; None: all of
        a bay.
    safety : factors on yielding and buckling; None: those of the model. margin : required ratio of the limits of a drive
        (voltage, current, speed and torque of the motor, stress of the screw) to the demand, 1 for no margin.
    self_locking : every screw must hold by itself.
    """

    kinetruss_mission: Annotated[
        int, one_format(FORMAT, "kinetruss_mission", "mission format {}"), WithJsonSchema({"const": FORMAT})
    ] = FORMAT
    title: str = ""
    runs: Annotated[tuple[Name, ...], Field(min_length=1)] | None = None
    load_cases: Annotated[tuple[LoadCaseNames, ...], Field(min_length=1)] | None = None
    groups: Filled[Name, Group] | None = None
    drives: Filled[Name, Patterns] | None = None
    catalogues: Catalogues
    safety: Safety | None = None
    margin: Annotated[Number, Field(ge=1)] = 1.0
    self_locking: Flag = False
    settle: Settle = Settle()

    @model_validator(mode="after")
    def _something(self) -> Mission:
        given = (self.catalogues.tubes, self.catalogues.screws, self.catalogues.gears, self.catalogues.motors)
        own = [group.tubes for group in (self.groups or {}).values()]
        if all(one is None for one in (*given, *own)):
            raise ValueError("names no catalogue. Add catalogues: {tubes: ..., motors: ...}.")
        return self

    @classmethod
    def _faults(cls, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
        return faults_of(error, data, cls)


def mission_faults(model: Model, mission: Mission) -> list[Fault]:
    """All faults of a mission relative to its model: unknown runs, load cases and members, groups that overlap.

    >>> import kinetruss as kt
    >>> model = kt.library.vgt.triangular()
    >>> mission = kt.Mission(runs=["lift"], catalogues={"tubes": "aluminium_tubes_metric"})
    >>> [fault.message for fault in kt.model.mission_faults(model, mission)]
    ["the model has no run called 'lift'."]
    """
    return [*_runs(model, mission), *_groups(model, mission), *_drives(model, mission)]


def _runs(model: Model, mission: Mission) -> Iterator[Fault]:
    if mission.runs is None and not model.runs:
        yield Fault((), "the model has no run to be sized for.", "Add one to the runs of the model.")
    for index, name in enumerate(mission.runs or ()):
        if name not in model.runs:
            yield Fault(("runs", index), f"the model has no run called {name!r}.", nearest(name, model.runs))
    yield from unknown_names(model, mission, ())


def _groups(model: Model, mission: Mission) -> Iterator[Fault]:
    named = {name: group.members for name, group in (mission.groups or {}).items()}
    yield from _matches(named, list(model.whole.real_members), "groups", ("members",), "member", "a tube")
    for name, group in (mission.groups or {}).items():
        if group.tubes is None and mission.catalogues.tubes is None:
            yield Fault(("groups", name), "has no catalogue of tubes.", "Add catalogues: {tubes: ...}, or tubes to the group.")


def _drives(model: Model, mission: Mission) -> Iterator[Fault]:
    known = [name for name, member in model.members.items() if isinstance(member, Active)]
    yield from _matches(mission.drives or {}, known, "drives", (), "active member", "a drive")


def _matches(
    groups: dict[str, tuple[str, ...]], known: list[str], table: str, below: tuple[str, ...], what: str, gets: str
) -> Iterator[Fault]:
    """Patterns that match nothing, and members in two groups."""
    owner: dict[str, str] = {}
    for name, patterns in groups.items():
        for index, pattern in enumerate(patterns):
            found = matched(known, pattern)
            path: tuple[str | int, ...] = (table, name, *below, index)
            if not found:
                yield Fault(path, f"no {what} fits {pattern!r}.", nearest(pattern, known))
            taken = [one for one in found if owner.setdefault(one, name) != name]
            if taken:
                message = f"{pattern!r} takes {', '.join(taken[:4])}{', ...' if len(taken) > 4 else ''}"
                message += f", which {owner[taken[0]]!r} has already."
                yield Fault(path, message, f"Give every member {gets} once.")
