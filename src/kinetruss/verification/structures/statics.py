"""Statics: the stiffness method and pose-wise statics against printed figures, inverse dynamics and closed forms."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from kinetruss import dynamics, kinematics, statics
from kinetruss.library import vgt
from kinetruss.model import General, LoadCase, Material, Model, NodalForce, Tube
from kinetruss.results import Result
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference
from kinetruss.verification.thesis.printed import printed
from kinetruss.verification.thesis.tables import INCH, LEVEL, LONG, POSES, SETS, SHORT, Lengths
from kinetruss.verification.thesis.triangle import truss

__all__ = ["cases"]

AGREE = 1e-10
"""Stiffness method against inverse dynamics, of the largest force."""

STRAINS = {"equilibrium": LEVEL, "M7_long": LONG, "M7_short": SHORT}
ROUND_OFF = 1e-12
ELASTIC = Reference("agreement", "the stiffness method and J^T N = f have the same forces in a determinate truss")
WORK = Reference("identity", "principle of virtual work")
SHARED = Reference(
    "closed-form", "N = P/(1 + 2 cos^3 a), sides N cos^2 a, a = 45 deg (Timoshenko, Strength of Materials I, 1955)"
)


def bay(name: str, weight: bool = False) -> Model:
    """The bay of a set of the thesis; with weight, that of the members hanging down."""
    setup = SETS[name]
    return vgt.double_octahedral(
        base=48 * INCH,
        longeron=setup.longeron,
        section=Tube(outer=0.75 * INCH, inner=setup.inner),
        material=Material(E=71e9, density=2711.5 if weight else 0.0),
        gravity=(0.0, 0.0, 9.81 if weight else 0.0),
        tip_force=(0.0, 0.0, setup.force),
    )


def _pose(lengths: Lengths) -> dict[str, float]:
    return dict(zip(("M7", "M9", "M11"), lengths, strict=True))


def table(where: str) -> dict[str, float]:
    """Tables 5.2 to 5.4 by the stiffness method."""
    model = bay("A")
    found = statics.linear(model, kinematics.assemble(model, _pose(POSES[where])), weight=False)
    area = Tube(outer=0.75 * INCH, inner=SETS["A"].inner).area
    reaction, force = found.reaction.sel(support="N1").values, found.member_force
    return {
        **{f"R_N1_{axis}": value for axis, value in zip("xyz", reaction, strict=True)},
        "tension_M6": force.sel(member="M6").item(),
        "compression_M19": -force.sel(member="M19").item(),
        "stress_M6": abs(force.sel(member="M6").item()) / area,
        "stress_M19": abs(force.sel(member="M19").item()) / area,
    }


def table_3_2() -> dict[str, float]:
    """Massless members, 98.1 N at B."""
    model = truss(10.0, massless=True)
    found = statics.linear(model)
    area = model.section_of(model.bars["follower"]).area
    force = {name: found.member_force.sel(member=name).item() for name in ("follower", "actuator")}
    return {
        **_reactions(found),
        "tension_follower": force["follower"],
        "tension_tube": force["actuator"],
        "stress_follower": abs(force["follower"]) / area,
        "stress_tube": abs(force["actuator"]) / area,
    }


def section_3_2() -> dict[str, float]:
    """Reactions with the weight of the members."""
    return _reactions(statics.linear(truss()))


def _reactions(found: Result) -> dict[str, float]:
    return {f"R_O{k}{axis}": found.reaction.sel(support=f"O{k}", axis=axis).item() for k in (1, 2) for axis in "xy"}


def strains(by: str) -> dict[str, float]:
    """Table 5.5: microstrain of M6 in three poses, from pose-wise statics or by the stiffness method."""
    model = bay("B")
    if by == "at_poses":
        forces = statics.at_poses(model, {name: _pose(lengths) for name, lengths in STRAINS.items()}, weight=False)
        found = statics.deflection(model, forces).strain.sel(member="M6").values * 1e6
        return dict(zip(STRAINS, found.tolist(), strict=True))
    return {
        name: statics.linear(model, kinematics.assemble(model, _pose(lengths)), weight=False).strain.sel(member="M6").item()
        * 1e6
        for name, lengths in STRAINS.items()
    }


def agreement(geometry: str, weight: bool) -> dict[str, float]:
    """Largest difference of stiffness method and inverse dynamics at rest, of the largest force."""
    if geometry == "table_3_2":
        model, poses = truss(massless=not weight), {"actuator": 2.5}
    else:
        model, poses = bay("A", weight=True), _pose(POSES[geometry])
    forces = statics.at_poses(model, [poses], weight=weight)
    found = statics.linear(model, forces.motion.position.values[0], weight=weight)
    scale = float(np.abs(forces.member_force.values).max())
    return {
        name: float(np.abs(found.data[name].values - forces.data[name].values[0]).max()) / scale
        for name in ("member_force", "end_force", "reaction")
    }


def along() -> dict[str, float]:
    """The same along a slew: inverse dynamics at rest and its deflection against the stiffness method at each pose."""
    model = bay("A", weight=True)
    motion = kinematics.follow(model, vgt.slew(beta=(-0.17, 0.17), gamma=(0.0, 0.09)), samples=5)
    forces = dynamics.inverse(model, motion)
    still = forces.static
    if still is None:
        raise TypeError("static forces were asked for")
    bent = statics.deflection(model, still)
    force, shift = 0.0, 0.0
    for i, position in enumerate(motion.position.values):
        found = statics.linear(model, position)
        force = max(force, float(np.abs(found.member_force.values - still.member_force.values[i]).max()))
        shift = max(shift, float(np.abs(found.displacement.values - bent.displacement.values[i]).max()))
    moving = statics.deflection(model, forces)
    return {
        "member_force": force / float(np.abs(still.member_force.values).max()),
        "displacement": shift / float(np.abs(bent.displacement.values).max()),
        "virtual_work": float(np.abs(moving.work_balance.values).max() / moving.energy.values.max()),
    }


def three_bars() -> dict[str, float]:
    """Forces, of the load, in a vertical bar between two at 45 degrees that hang from one ceiling; sag of their node."""
    model = Model(
        nodes={"L": (-1, 1), "M": (0, 1), "R": (1, 1), "P": (0, 0)},
        fixed=["L", "M", "R"],
        bars={"left": ("L", "P"), "middle": ("M", "P"), "right": ("R", "P")},
        section=General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
        material=Material(E=100e9, density=0.0),
        loads={"load": NodalForce(node="P", force=(0.0, -1000.0))},
        load_cases={"load": LoadCase(loads={"load": 1.0})},
    )
    found, shared = statics.linear(model, load_case="load"), statics.at_poses(model, [{}])
    return {
        "middle": found.member_force.sel(member="middle").item() / 1000.0,
        "side": found.member_force.sel(member="left").item() / 1000.0,
        "sag": -found.displacement.sel(node="P", axis="y").item() * 100e9 * 1e-4 / 1000.0,
        "shared_middle": shared.member_force.sel(member="middle").item() / 1000.0,
    }


def cases() -> Iterator[Case]:
    """Printed figures again, by another method; agreement of methods; a redundant truss in closed form."""
    for one in (*printed("bay"), *printed("triangle")):
        if (made := _computation(one.id)) is not None:
            make, arguments, key = made
            given = (one.reference, one.expected, one.tolerance, make)
            yield Case(f"statics.linear.{one.id}", *given, arguments, (key,))
            if make is strains:
                yield Case(f"statics.at_poses.{one.id}", *given, ("at_poses",), (key,))
    for geometry in ("table_3_2", "table_5_2", "table_5_3", "table_5_4"):
        for weight in (False, True):
            for quantity in ("member_force", "end_force", "reaction"):
                name = f"statics.agreement.{geometry}.{'with_weight' if weight else 'weightless'}.{quantity}"
                yield Case(name, ELASTIC, 0.0, AGREE, agreement, (geometry, weight), (quantity,), 1.0)
    for quantity, tolerance in (("member_force", AGREE), ("displacement", AGREE), ("virtual_work", ROUND_OFF)):
        reference = WORK if quantity == "virtual_work" else ELASTIC
        yield Case(f"statics.slew.{quantity}", reference, 0.0, tolerance, along, (), (quantity,), 1.0)
    middle = 2.0 - math.sqrt(2.0)
    exact = {"middle": middle, "side": middle / 2, "sag": middle, "shared_middle": middle}
    for quantity, expected in exact.items():
        yield Case(f"statics.three_bars.{quantity}", SHARED, expected, ROUND_OFF, three_bars, (), (quantity,))


def _computation(label: str) -> tuple[Any, tuple[str, ...], str] | None:
    """Analysis, its arguments and the key of a printed number, or None where it is not static."""
    where, name = label.rsplit(".", 1)
    if where == "triangle.table_3_2":
        return table_3_2, (), name
    if where == "triangle.section_3_2.weight":
        return section_3_2, (), name
    if where.startswith("bay.table_5_5"):
        return strains, ("linear",), name
    place = where.removeprefix("bay.")
    return (table, (place,), name) if place in POSES else None
