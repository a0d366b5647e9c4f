"""What presses the bearings of a simulation, as tables for kernels: everything that acts on their members, by its source.

The force that presses a bearing is what its joint does to the end of its member: what the mass, the law and the rows of the
member need there, less what the actions on the member (dynamics.bar_actions) are worth there. It is linear in accelerations
and row forces, so simulations solve it together with the friction that follows from it (kernels.structure.bearings).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.dynamics.action_couples import bars_of_hinge, hinge_couple, hinge_pull, hinges_of, side_push
from kinetruss.dynamics.actions import Action
from kinetruss.dynamics.bar_actions import actions_of
from kinetruss.dynamics.bearing_friction import bearing_push, bearings_of, jam, rows_on_hub, seats_of
from kinetruss.dynamics.equations import force_history, load_tables, loads_of_case
from kinetruss.dynamics.hub_arms import HubFrame, arm_push, body_push, load_push, pin_couple
from kinetruss.elements.kinds import forces_of_loads, scalar_forces, spans_of, table_of_kinds
from kinetruss.elements.pin_friction import pins_of
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kernels.solve.accelerations import of_bearings
from kinetruss.kernels.structure.bearings import (
    ACROSS,
    ACROSS_LENGTH,
    ALONG,
    ELEMENT,
    FIXED,
    LEVER,
    ROW,
    TABLE,
    TERM,
    JointLoads,
)
from kinetruss.kernels.structure.structure import ANGLE, LENGTH
from kinetruss.mechanics.bars import bars_of
from kinetruss.mechanics.frames import Side
from kinetruss.mechanics.rotating_base import base_of
from kinetruss.model import GivenForce

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.dynamics.bearing_friction import Seat
    from kinetruss.kernels.structure.equations import Equations, Workspace
    from kinetruss.mechanics import System


def with_bearings(
    system: System, eq: Equations, ws: Workspace, load_case: str | None, tasks: Mapping[str, Any]
) -> tuple[Equations, Workspace]:
    """Equations with the friction of the bearings of a system, and their workspace.

    Raises
    ------
    InputError : the base rotates.
    """
    seats = seats_of(system)
    if not seats:
        return eq, ws
    if base_of(system) is not None:
        raise InputError(
            "Bearings with friction cannot be simulated in a base that rotates. Take out the bearings, or the rotation."
        )
    found = _Loads(system, eq, load_case, tasks)
    for k, seat in enumerate(seats):
        found.add_member(k, seat)
        for action in actions_of(system, load_case or "").actions:
            if action.member == seat.member and not action.counted:
                found.add_action(k, seat, action)
    own, pressed = bearings_of(system), found.record()
    eq = eq.with_(
        rubs=of_bearings.addresses(),
        bearing_ints=own.ints,
        bearing_reals=own.reals,
        pressed_ints=pressed.ints,
        pressed_reals=pressed.reals,
    )
    return eq, ws.with_(couple=np.zeros(len(seats)), jammed=np.zeros(1, np.int64))


def jammed(system: System, ws: Workspace) -> AnalysisError | None:
    """The error of a bearing whose friction did not settle in the last accelerations; None where all did."""
    worst = int(ws.jammed[0]) - 1 if ws.jammed.size else -1
    return jam(seats_of(system)[worst].name) if worst >= 0 else None


def _unknown(seat: Seat, what: str) -> InputError:
    return InputError(
        f"Bearing {seat.name!r} cannot be simulated: what {what} does in its joint is not known as a force there. Take the "
        "friction out, or find the forces along a motion (dynamics.inverse)."
    )


class _Loads:
    """The tables of `JointLoads` as they grow."""

    def __init__(self, system: System, eq: Equations, load_case: str | None, tasks: Mapping[str, Any]) -> None:
        self.system, self.eq, self.shares, self.tasks = system, eq, loads_of_case(system, load_case), tasks
        self.place = {int(r): k for k, r in enumerate(eq.row)}
        self.seat: list[Any] = []
        self.mass: list[NDArray[np.float64]] = []
        self.varying: list[int] = []
        self.law: list[int] = []
        self.pull: list[tuple[int, ...]] = []
        self.pull_by: list[tuple[float, ...]] = []
        self.load: list[tuple[int, int, int]] = []
        self.load_by: list[float] = []
        self.tables: list[tuple[Any, Any]] = []
        self.parts: list[list[Any]] = []
        self.push: list[tuple[int, int, int]] = []
        self.push_by: list[float] = []
        self.element: list[tuple[int, int, int]] = []
        self.rub: list[tuple[int, int, int]] = []
        self.rub_by: list[float] = []

    def record(self) -> JointLoads:
        """The record."""
        system, kinds = self.system, [kind for part in self.parts for kind in part]
        given: dict[str, Any] = {
            name: np.array(getattr(self, name), np.int64).reshape(-1, width)
            for name, width in (("seat", 3), ("pull", 8), ("load", 3), ("push", 3), ("element", 3), ("rub", 3))
        }
        given |= {name: np.array(getattr(self, name), float) for name in ("load_by", "push_by", "rub_by")}
        return JointLoads.of(
            given
            | table_of_kinds("part", kinds)
            | {
                "varying": self.varying,
                "law": self.law,
                "mass": np.array(self.mass),
                "pull_by": np.array(self.pull_by, float).reshape(-1, 4),
                "ptr": np.cumsum([0, *(len(times) for times, _ in self.tables)]),
                "time": np.concatenate([*(np.asarray(times, float) for times, _ in self.tables), np.zeros(0)]),
                "value": np.concatenate([*(np.asarray(values, float) for _, values in self.tables), np.zeros(0)]),
                "part_ptr": np.cumsum([0, *map(len, self.parts)]),
                "form": system.term_form,
                "place": system.term_at,
                "data": system.term_data,
            }
        )

    # What the member itself needs at its ends.

    def add_member(self, k: int, seat: Seat) -> None:
        """Mass, law and rows of the member of a bearing."""
        system, eq, i = self.system, self.eq, seat.member
        self.seat.append((3 * system.p[i], 3 * system.q[i], seat.end))
        self.mass.append(eq.pair[eq.pair_member == i].sum(axis=0))
        self.varying.append(_first(eq.varying_member == i))
        self.law.append(_first(eq.law_member == i))
        sign = 1.0 if seat.end else -1.0
        for r in np.flatnonzero((system.row_member == i) & (system.row_measure < 0)):
            self._add_row(k, int(r), i, sign)

    def _add_row(self, k: int, r: int, i: int, share: float) -> None:
        """The tension of a row between the ends of bar i, of an angle across it."""
        turned = self.system.row_kind[r] == ANGLE
        if r in self.place:
            self._pull(k, ROW, self.place[r], ACROSS if turned else ALONG, self._ends(i), share)
        elif (table := self._given(int(self.system.row_drive[r]))) >= 0:
            # the row of a drive with a given force F has N = -F, that of one with a torque -T/L
            self._pull(k, TABLE, table, ACROSS_LENGTH if turned else ALONG, self._ends(i), -share)

    def _ends(self, i: int) -> tuple[int, int]:
        return 3 * int(self.system.p[i]), 3 * int(self.system.q[i])

    def _pull(
        self, k: int, source: int, index: int, form: int, numbers: tuple[int, ...], share: float, by: Iterable[float] = ()
    ) -> None:
        self.pull.append((k, source, index, form, *numbers, *(0,) * (4 - len(numbers))))
        vector = tuple(by)
        self.pull_by.append((share, *vector, *(0.0,) * (3 - len(vector))))

    def _given(self, d: int) -> int:
        """The table of the given force of a drive; -1 where it has none."""
        task = self.tasks.get(self.system.drives[d])
        return self._table(*force_history(task)) if isinstance(task, GivenForce) else -1

    def _table(self, times: Any, values: Any) -> int:
        self.tables.append((times, values))
        return len(self.tables) - 1

    # What acts on it. An action says how it acts on its bar by the function that it is worth, and what this is called with.

    def add_action(self, k: int, seat: Seat, action: Action) -> None:
        """An action on the member of a bearing; its worth at the end is taken off what the joint does."""
        for one in (action.worth, action.couple):
            if isinstance(one, partial) and one.func in self._acts:
                self._acts[one.func](self, k, seat, *one.args, **one.keywords)
            elif one is not None:
                raise _unknown(seat, f"{action.kind} {action.source!r}")

    def _side(self, k: int, seat: Seat, columns: list[int], signs: NDArray[np.float64], number: int, side: Side) -> None:  # noqa: ARG002
        """The forces on two nodes of a side."""
        column, share = columns[seat.end], -float(signs[seat.end])
        if side.weights is not None:
            self._pull_of(k, side.source, FIXED, (), share, side.weights[column])
        else:
            shared = int(len(side.nodes) == 3)
            self._pull_of(k, side.source, TERM, (side.term, int(side.end > 0), column - 1, shared), share)

    def _pull_of(
        self,
        k: int,
        key: tuple[str, str],
        form: int,
        numbers: tuple[int, ...],
        share: float,
        by: Iterable[float] = (),
    ) -> None:
        """A pull of the force of a drive, a coupling or an element on a coordinate."""
        system, (kind, name) = self.system, key
        if kind not in ("drive", "coupling"):
            number = list(system.force_elements).index(name)
            self._pull(k, ELEMENT, self._element(number), form, numbers, share, by)
            return
        m = system.measures.index(name)
        for r in np.flatnonzero(system.row_measure == m):
            if int(r) in self.place:
                self._pull(k, ROW, self.place[int(r)], form, numbers, -share * system.measure_scale[m], by)
                return
        if kind == "drive" and (table := self._given(system.drives.index(name))) >= 0:
            self._pull(k, TABLE, table, form, numbers, share, by)

    def _element(self, number: int) -> int:
        """The element on a coordinate of this number, among those with a name."""
        system = self.system
        m = int(system.force_element_measure[number])
        self.parts.append([scalar_forces(system, spans_of(system)["friction"].stop + number)])
        self.element.append((len(self.parts) - 1, int(system.measure_ptr[m]), int(system.measure_ptr[m + 1])))
        return len(self.element) - 1

    def _body(self, k: int, seat: Seat, i: int, m: NDArray[np.float64], skew: float) -> None:  # noqa: ARG002
        """Weight less inertia of a body on the member."""
        self.mass[k] = self.mass[k] + np.array([m[0, 0], m[0, 1], m[1, 1], skew])

    def _load(self, k: int, seat: Seat, i: int, name: str) -> None:
        """A load on the member: what does not act at its end B acts at A."""
        B = int(self.system.q[i])
        self._loads(k, (name,), lambda node: float((node == B) == (seat.end == 1)), -1.0)

    def _loads(self, k: int, names: Iterable[str], counts: Callable[[int], float], share: float) -> None:
        """The forces of loads on nodes that count."""
        for name in names:
            constant, turning = load_tables(self.system, name, self.shares.get(name, 0.0))
            for flat, times, amounts in constant:
                if counts(flat // 3):
                    self.load.append((k, flat % 3, self._table(times, amounts)))
                    self.load_by.append(share)
            for one in turning:
                self.parts.append([forces_of_loads([one])])
                for node in one.load.nodes:
                    if counts(int(node)):
                        self.push.append((k, len(self.parts) - 1, 3 * int(node)))
                        self.push_by.append(share)

    def _pin(self, k: int, seat: Seat, i: int, node: int) -> None:
        """Friction about a pin: the element pushes the far end, and its opposite acts at the pin."""
        pins, first = pins_of(self.system), spans_of(self.system)["friction"].start
        pairs = np.flatnonzero((pins.node == node) & ((pins.first == i) | (pins.second == i)))
        self.parts.append([scalar_forces(self.system, first + int(pair)) for pair in pairs])
        p, q = int(self.system.p[i]), int(self.system.q[i])
        self.push.append((k, len(self.parts) - 1, 3 * (p + q - node)))
        self.push_by.append(1.0 if (p, q)[seat.end] == node else -1.0)

    def _bearing(self, k: int, seat: Seat, rows: tuple[int, int]) -> None:
        """The couple of a bearing on the member."""
        self._rub(k, rows[seat.end], -1.0)

    def _rub(self, k: int, row: int, share: float) -> None:
        bearing = int(np.searchsorted(bearings_of(self.system).ptr, row, side="right")) - 1
        self.rub.append((k, bearing, row))
        self.rub_by.append(share)

    def _arm(self, k: int, seat: Seat, frame: HubFrame, i: int, tip: int, nodes: list[int]) -> None:  # noqa: ARG002
        """What braces, loads and friction do to the tip of a member that a hub clamps, and their opposite at the centre."""
        if frame.grounded:
            raise _unknown(seat, f"hub {frame.hub!r}, which is on the ground,")
        share, bars = -1.0 if seat.end == tip else 1.0, bars_of(self.system)
        for brace in frame.braces:
            for end, node in enumerate(bars.ends(brace)):
                if node in nodes:
                    self._brace(k, brace, -share if end else share)  # they pull outward
        self._loads(k, frame.loads, lambda node: float(node in nodes), share)
        own_nodes = bearings_of(self.system).node // 3
        for row in rows_on_hub(self.system, frame.hub):
            if own_nodes[row] in nodes:
                self._rub(k, row, share)

    def _brace(self, k: int, i: int, share: float) -> None:
        if (r := self._row_of(i)) >= 0:
            self._pull(k, ROW, r, ALONG, self._ends(i), share)

    def _row_of(self, i: int) -> int:
        """The row of the length of member i in the equations; -1 where it has none."""
        rows = np.flatnonzero((self.system.row_member == i) & (self.system.row_kind == LENGTH) & (self.system.row_measure < 0))
        return self.place[int(rows[0])] if len(rows) else -1

    def _hinge_pull(self, k: int, seat: Seat, hinge: int, i: int) -> None:  # noqa: ARG002
        """The axial force of the bars of a hinge."""
        self._hinge(k, seat, hinge, 0.0, -1.0 if seat.end == hinges_of(self.system)[hinge].end else 1.0)

    def _hinge(self, k: int, seat: Seat, hinge: int, sign: float = 1.0, axial: float = 0.0) -> None:
        """The part of the couple of a hinge across its member, and the axial force of its bars."""
        system, pivot = self.system, hinges_of(self.system)[hinge]
        joint = 3 * system.node_index(pivot.tip)
        group = {system.node_index(node) for node in (pivot.tip, *pivot.nodes)}
        by = (-sign if seat.end else sign, axial)
        for n, i in enumerate(bars_of_hinge(system, bars_of(system), pivot)):
            row, share = self._row_of(i), 1.0
            if not pivot.steady:  # a positive force of the coupling lengthens the first bar and shortens the second
                m = system.measures.index(pivot.coupling)
                row = self.place[int(np.flatnonzero(system.row_measure == m)[0])]
                share = float(system.measure_scale[m]) * (-1.0 if n else 1.0)
            for node, out in ((int(system.p[i]), 1.0), (int(system.q[i]), -1.0)):
                if node in group and row >= 0:
                    self._pull(k, ROW, row, LEVER, (*self._ends(i), 3 * node, joint), out * share, by)

    _acts: Mapping[Callable[..., Any], Callable[..., None]] = {
        side_push: _side, body_push: _body, load_push: _load, pin_couple: _pin, bearing_push: _bearing, arm_push: _arm,
        hinge_couple: _hinge, hinge_pull: _hinge_pull,
    }  # fmt: skip
    """By the function of an action."""


def _first(mask: NDArray[np.bool_]) -> int:
    """The first index where a mask is true, or -1."""
    found = np.flatnonzero(mask)
    return int(found[0]) if len(found) else -1
