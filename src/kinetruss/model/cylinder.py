"""Hydraulic cylinders between two nodes: pressures given in time behind a supply of limited flow, or a given flow."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from pydantic import Field, model_validator

from kinetruss.errors import Fault
from kinetruss.model.drives import ElementRecord
from kinetruss.model.in_time import check_table
from kinetruss.model.record import Of, PositiveLength, Series, Time, positive
from kinetruss.model.references import MemberName, NodeName

if TYPE_CHECKING:
    from kinetruss.model.data import ModelData

Pressure = Annotated[float, Of("pressure")]
Flow = Annotated[float, Of("volume flow")]
Times = Annotated[tuple[Time, ...], Field(min_length=2), Series]
Pressures = Annotated[tuple[Pressure, ...], Series]


class Cylinder(ElementRecord):
    """A hydraulic cylinder along a member, or between two nodes: p_A on the bore and p_B on its ring about the rod push them
    apart with p_A A_A - p_B A_B. Oil is stiff and has no mass: pressures follow at once.

    Pressures given, as constants or tables over `times` (linear between, constant outside): of the supply. With `flow_limit` a
    port that draws the flow Q has p (1 - (Q/flow_limit)^2), at least 0, as behind the orifice of a valve (H. E. Merritt,
    Hydraulic Control Systems, 1967, eq. 3-31). Or `flow` is given, into A (negative: into B), and the other port is open to the
    tank; what the speed does not take leaks past the piston: `leak` times the pressure. At the flow 0 both ports are shut.

    member : along which it stands. nodes : or between which. bore, rod : diameters; the rod is on the side B. pressure_A,
    pressure_B : of the supply; pressures_A, pressures_B : tables. flow : of the pump; flows : a table. times : of the tables.
    flow_limit : at which the whole pressure is lost. leak : flow per pressure. relief : highest pressure.
    """

    element: ClassVar[str] = "cylinder"
    measured: ClassVar[dict[str, str]] = {
        "thrust": "N",
        "pressure_A": "Pa",
        "pressure_B": "Pa",
        "flow_A": "m^3/s",
        "flow_B": "m^3/s",
        "power": "W",
    }
    """Its results that expressions may name, with their units."""
    member: MemberName | None = None
    nodes: tuple[NodeName, NodeName] | None = None
    bore: PositiveLength
    rod: PositiveLength
    times: Times | None = None
    pressure_A: Pressure | None = None
    pressures_A: Pressures | None = None
    pressure_B: Pressure | None = None
    pressures_B: Pressures | None = None
    flow: Flow | None = None
    flows: Annotated[tuple[Flow, ...], Series] | None = None
    flow_limit: Annotated[float, Of("volume flow", positive)] | None = None
    leak: Annotated[float, Of("flow per pressure", positive)] | None = None
    relief: Annotated[float, Of("pressure", positive)] | None = None

    @model_validator(mode="after")
    def _sound(self) -> Cylinder:
        if (self.member is None) == (self.nodes is None):
            raise ValueError("a cylinder stands along one member or between two nodes. Give member, or nodes.")
        if self.rod >= self.bore:
            raise ValueError(f"the rod ({self.rod:g} m) is not thinner than the bore ({self.bore:g} m). Mend one of them.")
        tables = {name: one for name in ("pressures_A", "pressures_B", "flows") if (one := getattr(self, name)) is not None}
        for name, one in tables.items():
            if self.times is None:
                raise ValueError(f"{name} is a table. Give its times.")
            check_table(self.times, one, name)
        if self.times is not None and not tables:
            raise ValueError("times belong to a table. Give pressures_A, pressures_B or flows, or leave them out.")
        for one, many in (("pressure_A", "pressures_A"), ("pressure_B", "pressures_B"), ("flow", "flows")):
            if getattr(self, one) is not None and getattr(self, many) is not None:
                raise ValueError(f"{one} and {many} both state the same. Leave one out.")
        lows = [*(self.pressures_A or ()), *(self.pressures_B or ()), self.pressure_A or 0.0, self.pressure_B or 0.0]
        if min(lows) < 0.0:
            raise ValueError("a pressure is negative; they count from that of the tank. Give at least 0.")
        if self.by_flow:
            if any(name.startswith("pressure") and one is not None for name, one in self):
                raise ValueError("flow and pressure are both given. Leave one out.")
            if self.leak is None or self.flow_limit is not None:
                raise ValueError("a given flow takes its pressure from the leak past the piston. Give leak, and no flow_limit.")
        elif self.leak is not None or self.relief is not None:
            raise ValueError("leak and relief belong to a given flow. Leave them out.")
        elif self.pressure_A is None and self.pressures_A is None and self.pressure_B is None and self.pressures_B is None:
            raise ValueError("nothing moves the piston. Give pressure_A, pressure_B, or flow with leak.")
        return self

    @property
    def by_flow(self) -> bool:
        """True if the flow is given."""
        return self.flow is not None or self.flows is not None

    def faults(self, model: ModelData, path: tuple[Any, ...]) -> Iterator[Fault]:
        """Nodes that are one, or stand at one place."""
        if self.nodes is None:
            return
        first, second = self.nodes
        if first == second:
            yield Fault((*path, "nodes"), f"names {first!r} twice.", "Give two different nodes.")
        elif model.nodes[first].at == model.nodes[second].at:
            yield Fault((*path, "nodes"), "stand at one place, so the cylinder has no direction.", "Move one of them.")

    if TYPE_CHECKING:

        def __init__(self, **fields: Any) -> None: ...
