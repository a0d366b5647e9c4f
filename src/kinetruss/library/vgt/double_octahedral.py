"""The double-octahedral variable-geometry truss of Lacy (1991), chapters 4 to 6: one bay, or a chain of bays."""

from __future__ import annotations

import math
from typing import Annotated, Any

from pydantic import Field

from kinetruss.errors import Fault, ModelError
from kinetruss.kernels.motion.placement import place_chain, reach
from kinetruss.library._arguments import own_arguments
from kinetruss.library._builder import builder, named
from kinetruss.library.drives import GEARS, MOTORS, SCREWS
from kinetruss.library.materials import ALUMINIUM_LACY, MATERIALS
from kinetruss.library.sections import SECTIONS, TUBE_LACY_SPATIAL
from kinetruss.limits import MOST_ENTRIES, whole
from kinetruss.model import (
    Active,
    Angle,
    Bar,
    Count,
    Flag,
    ForceVector,
    Gear,
    GimbalPose,
    GravityVector,
    LeadScrew,
    Mass,
    Material,
    Model,
    Motor,
    Name,
    NodalForce,
    Node,
    Part,
    PositiveLength,
    PositiveTime,
    Quintic,
    Safety,
)
from kinetruss.model.parts import EndCondition, Section

__all__ = ["double_octahedral", "slew"]

BARS = {
    "M1": (6, 2, 1),
    "M2": (6, 1, 2),
    "M3": (4, 1, 3),
    "M4": (4, 3, 1),
    "M5": (5, 3, 2),
    "M6": (5, 2, 3),
    "M13": (6, 9, 7),
    "M14": (6, 7, 9),
    "M15": (4, 7, 8),
    "M16": (4, 8, 7),
    "M17": (5, 8, 9),
    "M18": (5, 9, 8),
    "M19": (7, 9, 8),
    "M20": (8, 7, 9),
    "M21": (8, 9, 7),
}
"""First node, second node, third node of a face the bar bounds. Ends: Lacy (1991), table 4.1, with M19 from 7 to 9."""

ACTIVE = {"M7": (4, 5, 6), "M9": (5, 6, 4), "M11": (4, 6, 5)}
"""Node of the base rod, node of the tube, third node of the middle triangle."""

BELOW = {1: 7, 2: 9, 3: 8}
"""Top node of the bay below that is the same as a base node."""

TOP = (7, 8, 9)

MOST_BAYS = MOST_ENTRIES // (len(BARS) + len(ACTIVE))
Bays = Annotated[Count, Field(le=MOST_BAYS)]


@builder("vgt.double_octahedral")
def double_octahedral(
    bays: Bays = 1,
    *,
    base: PositiveLength = 1.2192,
    longeron: PositiveLength = 0.889,
    beta: Angle = 0.0,
    gamma: Angle = 0.0,
    height: PositiveLength | None = None,
    active_length: PositiveLength = 1.1684,
    section: Section | Name = TUBE_LACY_SPATIAL,
    material: Material | Name = ALUMINIUM_LACY,
    base_mass: Mass = 3.0,
    base_length: PositiveLength = 0.7,
    base_section: Section | Name | None = None,
    tube_length: PositiveLength = 0.254,
    tube_mass: Mass | None = None,
    tube_section: Section | Name | None = None,
    payload_mass: Mass = 0.0,
    payload_gravity: GravityVector | None = None,
    tip_force: ForceVector | None = None,
    gravity: GravityVector | None = (0.0, 0.0, -9.81),
    rotary_inertia: Flag = False,
    screw: LeadScrew | Name | None = None,
    gear: Gear | Name | None = None,
    motor: Motor | Name | None = None,
    limits: tuple[PositiveLength, PositiveLength] | None = None,
    buckling: EndCondition = "pinned-pinned",
    safety: Safety = Safety(),
    title: str = "",
) -> Model:
    """A double-octahedral truss of `bays` bays: 18 members a bay, 3 of them active, and 3 + 6 bays nodes.

    Names follow Lacy (1991). One bay: nodes N1..N9, bars M1..M6, M13..M21, active members M7, M9, M11 (his M7/M8, M9/M10,
    M11/M12), pose ``bay``. A chain: ``B1.N1``..``B1.N9``, ``B2.N4``.., bars ``B1.M1``.., poses ``B1``, ``B2``..; the
    top nodes 7, 9, 8 of a bay are the base nodes 1, 2, 3 of the next. N1, N2, N3 of the first bay are fixed, z points
    from the base up. Pose coordinates ``bay.beta``, ``bay.gamma``, ``bay.height`` move the three active members.

    Parameters
    ----------
    bays : number of bays.
    base : side of the base and top triangles, m (48 in). longeron : length of the cross longerons, m (35 in).
    beta, gamma : gimbal angles at the start, rad, the same in all bays. height : distance of the centroids of a bay's base
        and top, m; by default such that the active members have `active_length` (m, 46 in) when the bay is upright.
    section, material : of all bars and tubes.
    base_mass, base_length, base_section : of the base rods of the active members (kg, m); without a section their stresses are
        not checked.
    tube_length, tube_mass, tube_section : of their tubes (m, kg); by default density x area x length, and `section`.
    payload_mass, payload_gravity : lumped at each of the three top nodes, kg, with their own gravity (a suspended payload),
        m/s^2.
    tip_force : on each of the three top nodes, N; the loads are called ``tip_N7``, ``tip_N8``, ``tip_N9``.
    gravity : m/s^2; None for none. The thesis' truss hangs: (0, 0, 9.81).
    rotary_inertia : include that of the finite diameter of bars and tubes.
    screw, gear, motor : of every active member, records or library names, e.g. ``screw_lacy_spatial``. limits : least and
        largest length of the active members, m.
    buckling : ends of all members. safety : factors on yield and buckling.

    Returns
    -------
    Model. Local axis 3 of every bar is the normal of a face it bounds, of every active member that of the middle triangle.

    Raises
    ------
    ModelError : faults of the parameters, all at once; a pose out of reach.

    Examples
    --------
    >>> model = double_octahedral(beta="-10 deg", gravity=(0, 0, 9.81), tip_force=(0, 0, "46 N"))
    >>> len(model.nodes), len(model.members), [round(x, 6) for x in model.nodes["N8"].at]
    (9, 18, [0.0, 0.790985, 0.995325])
    """
    height = _height(base, longeron, beta, gamma, height, active_length)
    tube_section = section if tube_section is None else tube_section
    sections = {"bar": (section, "section"), "tube": (tube_section, "tube_section"), "base": (base_section, "base_section")}
    train = {"screw": named(SCREWS, screw, "screw"), "gear": named(GEARS, gear, "gear"), "motor": named(MOTORS, motor, "motor")}
    bar: dict[str, Any] = {"section": "bar", "material": "bar", "rotary_inertia": rotary_inertia, "buckling": buckling}
    active: dict[str, Any] = {
        "base": Part(length=base_length, mass=base_mass, section=None if base_section is None else "base"),
        "tube": Part(length=tube_length, mass=tube_mass, section="tube", material="bar", rotary_inertia=rotary_inertia),
        "limits": limits,
        "buckling": buckling,
    } | {kind: kind for kind, record in train.items() if record is not None}
    top = {k: f"{_prefix(bays, bays)}N{k}" for k in TOP}
    load = {} if payload_mass == 0 else {node: {"mass": payload_mass, "gravity": payload_gravity} for node in top.values()}
    placed = zip(_node_names(bays), place_chain(base, longeron, beta, gamma, height, bays).tolist(), strict=True)
    return Model(
        title=title or f"Double-octahedral truss, {bays} bay{'s' if bays > 1 else ''}",
        nodes={name: Node(at=at, **load.get(name, {})) for name, at in placed},
        fixed=_node_names(bays)[:3],
        sections={name: named(SECTIONS, *one) for name, one in sections.items() if one[0] is not None},
        materials={"bar": named(MATERIALS, material, "material")},
        **{f"{kind}s": {kind: record} for kind, record in train.items() if record is not None},
        bars={name: Bar(ends=ends, orientation=third, **bar) for name, ends, third in _members(bays, BARS)},
        active={name: Active(ends=ends, orientation=third, **active) for name, ends, third in _members(bays, ACTIVE)},
        gravity=gravity,
        loads={} if tip_force is None else {f"tip_N{k}": NodalForce(node=node, force=tip_force) for k, node in top.items()},
        poses={
            name: GimbalPose(base=base, longeron=longeron, drives=tuple(f"{_prefix(k, bays)}{member}" for member in ACTIVE))
            for k, name in enumerate(_pose_names(bays), start=1)
        },
        safety=safety,
    )


@own_arguments
def slew(
    bays: int = 1,
    *,
    beta: tuple[float, float] | None = None,
    gamma: tuple[float, float] | None = None,
    height: tuple[float, float] | None = None,
    duration: PositiveTime = 1.0,
) -> Quintic:
    """A rest-to-rest motion of `double_octahedral` in pose: every bay moves from the first to the second value.

    Parameters
    ----------
    bays : number of bays, as of the truss. beta, gamma : rad, or text such as ``"-10 deg"``. height : m. None: constant.
    duration : s.

    Examples
    --------
    >>> slew(3, beta=("0 deg", "10 deg"), gamma=("0 deg", "10 deg"), duration=3).moves["B2.gamma"][1]
    0.17453292519943295
    """
    bays = whole(bays, "bays", most=MOST_BAYS)
    pairs = {"beta": beta, "gamma": gamma, "height": height}
    moves = {f"{name}.{key}": pair for name in _pose_names(bays) for key, pair in pairs.items() if pair is not None}
    return Quintic(moves=moves, duration=duration)


def _height(base: float, longeron: float, beta: float, gamma: float, height: float | None, active_length: float) -> float:
    """The height, given or for equal active lengths when upright; ModelError if the pose is impossible."""
    if longeron <= base / 2:
        mend = f"Make it longer than half the base, {base / 2:g} m."
        raise ModelError([Fault(("longeron",), f"{longeron:g} m cannot span the base edge of {base:g} m.", mend)])
    rim, inner = math.sqrt(longeron**2 - base**2 / 4), base / (2 * math.sqrt(3))
    if height is None:
        cosine = (active_length / math.sqrt(3) - inner) / rim
        if not -1 < cosine < 1:
            least, most = math.sqrt(3) * max(inner - rim, 0.0), math.sqrt(3) * (inner + rim)
            mend = f"With this base and longeron it must lie between {least:.4g} m and {most:.4g} m."
            raise ModelError([Fault(("active_length",), f"{active_length:g} m does not close the bay.", mend)])
        height = 2.0 * rim * math.sqrt(1.0 - cosine**2)
    if height >= 2.0 * rim:
        raise ModelError([Fault(("height",), f"{height:g} m is out of reach.", f"Stay below {2 * rim:.6g} m.")])
    if not reach(base, longeron, beta, gamma, height) > 0:
        text = f"the pose {math.degrees(beta):.4g} deg, {math.degrees(gamma):.4g} deg is out of reach at height {height:.6g} m."
        raise ModelError([Fault(("beta",), text, "Tilt less, or lower the height.")])
    return height


def _prefix(bay: int, bays: int) -> str:
    return "" if bays == 1 else f"B{bay}."


def _pose_names(bays: int) -> list[str]:
    return ["bay"] if bays == 1 else [f"B{k}" for k in range(1, bays + 1)]


def _node_name(bay: int, number: int, bays: int) -> str:
    """Name of node `number` of a bay; its base nodes belong to the bay below."""
    if bay > 1 and number in BELOW:
        bay, number = bay - 1, BELOW[number]
    return f"{_prefix(bay, bays)}N{number}"


def _node_names(bays: int) -> list[str]:
    """In the order of `place_chain`."""
    own = [f"{_prefix(bay, bays)}N{k}" for bay in range(1, bays + 1) for k in range(4, 10)]
    return [f"{_prefix(1, bays)}N{k}" for k in (1, 2, 3)] + own


def _members(bays: int, table: dict[str, tuple[int, int, int]]) -> list[tuple[str, tuple[str, str], str]]:
    """Name, ends and third node of the members of all bays."""
    found = []
    for bay in range(1, bays + 1):
        for name, numbers in table.items():
            first, second, third = (_node_name(bay, number, bays) for number in numbers)
            found.append((f"{_prefix(bay, bays)}{name}", (first, second), third))
    return found
