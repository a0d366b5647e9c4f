"""The double-octahedral variable-geometry truss of Lacy (1991), chapters 4 to 6: one bay, or a chain of bays."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from pydantic import Field

from kinetruss.library.building import builder, own_arguments
from kinetruss.library.cells import Rods, double_octahedron, stacked
from kinetruss.library.materials import ALUMINIUM_LACY
from kinetruss.library.sections import TUBE_LACY_SPATIAL
from kinetruss.limits import MOST_ENTRIES, whole
from kinetruss.model import (
    Angle,
    Compliance,
    Count,
    Flag,
    ForceVector,
    Gear,
    GravityVector,
    Hub,
    LeadScrew,
    Mass,
    Material,
    Model,
    Motor,
    Name,
    NodalForce,
    PositiveLength,
    PositiveTime,
    Quintic,
    Safety,
)
from kinetruss.model.members import EndCondition
from kinetruss.model.sections import Section

TOP = ("N7", "N8", "N9")

LEAVES = {"N4": ("M3", "M4"), "N6": ("M1", "M2"), "N5": ("M5", "M6")}
"""Middle node -> the lower longeron that its hub clamps, and the one that is hinged there, about the normal of both."""
CORNERS = {"N7": ("M19", "M15", "N8"), "N9": ("M21", "M13", "N7"), "N8": ("M20", "M17", "N9")}
"""Top node -> the batten that its hub clamps, the upper longeron that is hinged there, and the other end of the edge of the
top about which it swings.
"""

MOST_BAYS = MOST_ENTRIES // 18
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
    compliance: Compliance | None = None,
    joint_offset: PositiveLength | None = None,
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
        largest length of the active members, m. compliance : of their screw, nut and base, in elastic analyses.
    joint_offset : distance of the joints of all members from their nodes, m: each node becomes a rigid hub (see below). Poses
        have no closed form then; the lengths of the active members, which are those between their joints, move the bays.
    buckling : ends of all members. safety : factors on yield and buckling.

    Returns
    -------
    Model. Local axis 3 of every bar is the normal of a face it bounds, of every active member that of the middle triangle.

    Notes
    -----
    With `joint_offset` the hubs of the base are bolted to the ground. Each middle hub turns with its lower leaf, of which it
    clamps one longeron; the other is hinged to it about the normal of the leaf. Each hub of the top clamps one batten, and one
    upper longeron swings at it about an edge of the top. All other joints are ball joints. So hubs hold each other without
    states of self-stress: 3 freedoms a bay, and all forces follow from statics. The thesis has no design of its joints; this
    one is the library's. Arms have the section and material of the bars.

    Raises
    ------
    ModelError : faults of the parameters, all at once; a pose out of reach.

    Examples
    --------
    >>> model = double_octahedral(beta="-10 deg", gravity=(0, 0, 9.81), tip_force=(0, 0, "46 N"))
    >>> len(model.nodes), len(model.members), [round(x, 6) for x in model.nodes["N8"].at]
    (9, 18, [0.0, 0.790985, 0.995325])
    >>> real = double_octahedral(joint_offset="30 mm")
    >>> real.whole.bars["M6"].ends, real.poses == {}
    (('N5.M6', 'N2.M6'), True)
    """
    hardware = Rods(
        section=section,
        material=material,
        rotary_inertia=rotary_inertia,
        buckling=buckling,
        base_mass=base_mass,
        base_length=base_length,
        base_section=base_section,
        tube_length=tube_length,
        tube_mass=tube_mass,
        tube_section=tube_section,
        screw=screw,
        gear=gear,
        motor=motor,
        limits=limits,
        compliance=compliance,
    )
    pose: Any = {"beta": beta, "gamma": gamma, "height": height}
    bay = double_octahedron(base=base, longeron=longeron, active_length=active_length, **pose, **hardware)
    last = bay
    if payload_mass:
        load = {"mass": payload_mass, "gravity": payload_gravity}
        last = bay.with_(nodes={name: node.with_(**load) if name in TOP else node for name, node in bay.nodes.items()})
    top = {name: name if bays == 1 else f"B{bays}.{name}" for name in TOP}
    chain = stacked([bay] * (bays - 1) + [last], "B")
    ideal = chain.model(
        title=title or f"Double-octahedral truss, {bays} bay{'s' if bays > 1 else ''}",
        fixed=list(chain.places)[:3],
        gravity=gravity,
        loads={} if tip_force is None else {f"tip_{k}": NodalForce(node=node, force=tip_force) for k, node in top.items()},
        safety=safety,
    )
    return ideal if joint_offset is None else _with_hubs(ideal, bays, joint_offset)


def _with_hubs(ideal: Model, bays: int, offset: float) -> Model:
    """The truss with a hub at every node; see `double_octahedral`."""
    places = {name: np.array(node.at) for name, node in ideal.nodes.items()}
    matter = {"section": "bar" if "bar" in ideal.sections else None, "material": "bar" if "bar" in ideal.materials else None}

    def along(node: str, member: str) -> Any:
        """The vector of a member from one of its nodes."""
        one, other = ideal.bars[member].ends
        return places[other if node == one else one] - places[node]

    hubs = {node: Hub(reach=offset, **matter) for node in ideal.fixed}
    for prefix in [""] if bays == 1 else [f"B{k}." for k in range(1, bays + 1)]:
        for node, (clamped, hinged) in LEAVES.items():
            name, members = prefix + node, (prefix + clamped, prefix + hinged)
            axis = np.cross(along(name, members[0]), along(name, members[1]))
            hubs[name] = Hub(reach=offset, clamped=members[:1], hinges={members[1]: axis}, **matter)
        for node, (clamped, hinged, other) in CORNERS.items():
            name, edge = prefix + node, places[prefix + other] - places[prefix + node]
            hubs[name] = Hub(reach=offset, clamped=(prefix + clamped,), hinges={prefix + hinged: edge}, **matter)
    return ideal.with_(hubs=hubs, poses={})


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
    names = ["bay"] if bays == 1 else [f"B{k}" for k in range(1, bays + 1)]
    moves = {f"{name}.{key}": pair for name in names for key, pair in pairs.items() if pair is not None}
    return Quintic(moves=moves, duration=duration)
