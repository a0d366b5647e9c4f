"""The triangular variable-geometry truss of Lacy (1991), chapters 2 and 3."""

from __future__ import annotations

import math
from typing import Any

from kinetruss.errors import Fault, ModelError
from kinetruss.library.building import builder, named, own_arguments
from kinetruss.library.drives import GEARS, MOTORS, SCREWS
from kinetruss.library.materials import ALUMINIUM_LACY, MATERIALS
from kinetruss.library.sections import SECTIONS, TUBE_LACY_PLANAR
from kinetruss.model import (
    Active,
    Bar,
    Compliance,
    Flag,
    ForceVector,
    Gear,
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
    Safety,
    StepResponse,
)
from kinetruss.model.members import EndCondition
from kinetruss.model.sections import Section


@builder("vgt.triangular")
def triangular(
    *,
    actuator_length: PositiveLength = 2.5,
    follower_length: PositiveLength = 2.0,
    span: PositiveLength = 2.0,
    section: Section | Name = TUBE_LACY_PLANAR,
    material: Material | Name = ALUMINIUM_LACY,
    base_mass: Mass = 2.4,
    base_length: PositiveLength = 2.1,
    base_section: Section | Name | None = None,
    tube_length: PositiveLength = 2.0,
    tube_mass: Mass | None = None,
    tube_section: Section | Name | None = None,
    payload_mass: Mass = 10.0,
    tip_force: ForceVector | None = None,
    gravity: GravityVector | None = (0.0, -9.81),
    rotary_inertia: Flag = True,
    screw: LeadScrew | Name | None = None,
    gear: Gear | Name | None = None,
    motor: Motor | Name | None = None,
    limits: tuple[PositiveLength, PositiveLength] | None = None,
    compliance: Compliance | None = None,
    buckling: EndCondition = "pinned-pinned",
    safety: Safety = Safety(),
    title: str = "Triangular variable-geometry truss",
) -> Model:
    """A follower and an actuator that meet in a loaded top node: the planar truss of Lacy (1991), chapters 2 and 3.

    Nodes O2 = (0, 0) and O1 = (span, 0) are fixed, B is on top. Bar ``follower`` runs from O1 to B, active member
    ``actuator`` from O2 to B: its base rod turns about O2, its tube ends at B. All defaults are the thesis' values.

    Parameters
    ----------
    actuator_length : of the actuator at the start, m.
    follower_length, span : length of the follower and distance O2 O1, m.
    section, material : of follower and tube.
    base_mass, base_length, base_section : of the base rod (kg, m); without a section its stresses are not checked.
    tube_length, tube_mass, tube_section : of the actuator's tube (m, kg); by default density x area, and `section`.
    payload_mass : lumped at B, kg. tip_force : on B, N; the load is called ``tip_B``.
    gravity : m/s^2; None for none.
    rotary_inertia : count the tubes' finite diameter, as the thesis does; the base rod stays thin.
    screw, gear, motor : of the actuator, records or library names, e.g. ``screw_lacy_planar``. limits : its least and
        largest length, m. compliance : of its screw, nut and base, in elastic analyses.
    buckling : ends of the follower and the actuator. safety : factors on yield and buckling.

    Returns
    -------
    Model.

    Raises
    ------
    ModelError : faults of the parameters, all at once; lengths that do not close.

    Examples
    --------
    >>> model = triangular(payload_mass="40 kg")
    >>> [round(x, 6) for x in model.nodes["B"].at]
    [1.5625, 1.951562]
    """
    tube = section if tube_section is None else tube_section
    sections = {"follower": section, "tube": tube} | ({} if base_section is None else {"base": base_section})
    rod = {} if base_section is None else {"section": "base", "material": "tube"}
    turning: Any = {"rotary_inertia": rotary_inertia}
    actuator = Active(
        ends=("O2", "B"),
        base=Part(length=base_length, mass=base_mass, **rod),
        tube=Part(length=tube_length, mass=tube_mass, section="tube", material="tube", **turning),
        screw=named(SCREWS, screw, "screw"),
        gear=named(GEARS, gear, "gear"),
        motor=named(MOTORS, motor, "motor"),
        limits=limits,
        compliance=compliance,
        buckling=buckling,
    )
    follower = Bar(ends=("O1", "B"), section="follower", material="tube", buckling=buckling, **turning)
    top = Node(at=_top(actuator_length, follower_length, span), mass=payload_mass)
    return Model(
        title=title,
        nodes={"O1": (span, 0.0), "O2": (0.0, 0.0), "B": top},
        fixed=["O1", "O2"],
        sections={name: named(SECTIONS, chosen, "section") for name, chosen in sections.items()},
        materials={"tube": named(MATERIALS, material, "material")},
        bars={"follower": follower},
        active={"actuator": actuator},
        loads={} if tip_force is None else {"tip_B": NodalForce(node="B", force=tip_force)},
        gravity=gravity,
        safety=safety,
    )


def _top(actuator: float, follower: float, span: float) -> tuple[float, float]:
    """B, where the circles of actuator about O2 and follower about O1 meet above the span."""
    x = (actuator**2 - follower**2 + span**2) / (2.0 * span)
    square = actuator**2 - x**2
    if square <= 0:
        least, most = abs(span - follower), span + follower
        mend = f"With this follower and span it must lie between {least:g} m and {most:g} m."
        raise ModelError([Fault(("actuator_length",), f"{actuator:g} m does not close the triangle.", mend)])
    return x, math.sqrt(square)


@own_arguments
def lacy_step(
    moves: dict[str, tuple[float, float]] | None = None, duration: PositiveTime = 3.0, damping: float = 0.8
) -> StepResponse:
    """The motion of Lacy (1991), section 3.2: a step through three placed poles.

    w = 6/(zeta 0.9 duration) and third pole 2 w, as in his program (his text has 4 for 6). By default the actuator of
    `triangular` from 2.5 to 3.7 m in 3 s. It overshoots by 1 % and has a small velocity at the end.

    >>> import kinetruss as kt
    >>> step = kt.library.vgt.lacy_step()
    >>> step.moves, round(step.frequency, 4)  # m; w = 6/(0.8 * 2.7 s), rad/s
    ({'actuator': (2.5, 3.7)}, 2.7778)
    """
    return StepResponse(
        moves=moves or {"actuator": (2.5, 3.7)},
        duration=duration,
        damping=damping,
        settling_time=0.9 * duration,
        settling_factor=6.0,
        order=3,
        third_pole=2.0,
    )
