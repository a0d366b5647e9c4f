"""Statics: the stiffness method and pose-wise statics against printed figures, inverse dynamics and closed forms."""

from __future__ import annotations

import numpy as np

import kinetruss as kt
from kinetruss.verification.thesis.tables import INCH, LEVEL, LONG, POSES, SETS, SHORT, Lengths
from kinetruss.verification.thesis.triangle import truss

STRAINS = {"equilibrium": LEVEL, "M7_long": LONG, "M7_short": SHORT}


def bay(name: str, weight: bool = False) -> kt.Model:
    """The bay of a set of the thesis; with weight, that of the members hanging down."""
    setup = SETS[name]
    return kt.library.vgt.double_octahedral(
        base=48 * INCH,
        longeron=setup.longeron,
        section=kt.Tube(outer=0.75 * INCH, inner=setup.inner),
        material=kt.Material(E=71e9, density=2711.5 if weight else 0.0),
        gravity=(0.0, 0.0, 9.81 if weight else 0.0),
        tip_force=(0.0, 0.0, setup.force),
    )


def _pose(lengths: Lengths) -> dict[str, float]:
    return dict(zip(("M7", "M9", "M11"), lengths, strict=True))


def table(where: str) -> dict[str, float]:
    """Tables 5.2 to 5.4 by the stiffness method."""
    model = bay("A")
    found = kt.statics.linear(model, kt.kinematics.assemble(model, _pose(POSES[where])), weight=False)
    area = kt.Tube(outer=0.75 * INCH, inner=SETS["A"].inner).area
    reaction, force = found.reaction.sel(support="N1").values, found.member_force
    return {f"R_N1_{axis}": value for axis, value in zip("xyz", reaction, strict=True)} | {
        "tension_M6": force.sel(member="M6").item(),
        "compression_M19": -force.sel(member="M19").item(),
        "stress_M6": abs(force.sel(member="M6").item()) / area,
        "stress_M19": abs(force.sel(member="M19").item()) / area,
    }


def table_3_2() -> dict[str, float]:
    """Massless members, 98.1 N at B."""
    model = truss(10.0, massless=True)
    found = kt.statics.linear(model)
    area = model.section_of(model.bars["follower"]).area
    force = {name: found.member_force.sel(member=name).item() for name in ("follower", "actuator")}
    return _reactions(found) | {
        "tension_follower": force["follower"],
        "tension_tube": force["actuator"],
        "stress_follower": abs(force["follower"]) / area,
        "stress_tube": abs(force["actuator"]) / area,
    }


def section_3_2() -> dict[str, float]:
    """Reactions with the weight of the members."""
    return _reactions(kt.statics.linear(truss()))


def _reactions(found: kt.results.Result) -> dict[str, float]:
    return {f"R_O{k}{axis}": found.reaction.sel(support=f"O{k}", axis=axis).item() for k in (1, 2) for axis in "xy"}


def strains(by: str) -> dict[str, float]:
    """Table 5.5: microstrain of M6 in three poses, from pose-wise statics or by the stiffness method."""
    model = bay("B")
    if by == "at_poses":
        forces = kt.statics.at_poses(model, {name: _pose(lengths) for name, lengths in STRAINS.items()}, weight=False)
        found = kt.statics.deflection(model, forces).strain.sel(member="M6").values * 1e6
        return dict(zip(STRAINS, found.tolist(), strict=True))
    at = {name: kt.kinematics.assemble(model, _pose(lengths)) for name, lengths in STRAINS.items()}
    return {name: 1e6 * kt.statics.linear(model, x, weight=False).strain.sel(member="M6").item() for name, x in at.items()}


def agreement(geometry: str, weight: bool) -> dict[str, float]:
    """Largest difference of stiffness method and inverse dynamics at rest, of the largest force."""
    if geometry == "table_3_2":
        model, poses = truss(massless=not weight), {"actuator": 2.5}
    else:
        model, poses = bay("A", weight=True), _pose(POSES[geometry])
    forces = kt.statics.at_poses(model, [poses], weight=weight)
    found = kt.statics.linear(model, forces.motion.position.values[0], weight=weight)
    scale = float(np.abs(forces.member_force.values).max())
    return {
        name: float(np.abs(found.data[name].values - forces.data[name].values[0]).max()) / scale
        for name in ("member_force", "end_force", "reaction")
    }


def along() -> dict[str, float]:
    """The same along a slew: inverse dynamics at rest and its deflection against the stiffness method at each pose."""
    model = bay("A", weight=True)
    motion = kt.kinematics.follow(model, kt.library.vgt.slew(beta=(-0.17, 0.17), gamma=(0.0, 0.09)), samples=5)
    forces = kt.dynamics.inverse(model, motion)
    still = forces.static
    if still is None:
        raise TypeError("static forces were asked for")
    bent = kt.statics.deflection(model, still)
    force, shift = 0.0, 0.0
    for i, position in enumerate(motion.position.values):
        found = kt.statics.linear(model, position)
        force = max(force, float(np.abs(found.member_force.values - still.member_force.values[i]).max()))
        shift = max(shift, float(np.abs(found.displacement.values - bent.displacement.values[i]).max()))
    moving = kt.statics.deflection(model, forces)
    return {
        "member_force": force / float(np.abs(still.member_force.values).max()),
        "displacement": shift / float(np.abs(bent.displacement.values).max()),
        "virtual_work": float(np.abs(moving.work_balance.values).max() / moving.energy.values.max()),
    }


def three_bars() -> dict[str, float]:
    """Forces, of the load, in a vertical bar between two at 45 degrees that hang from one ceiling; sag of their node."""
    model = kt.Model(
        nodes={"L": (-1, 1), "M": (0, 1), "R": (1, 1), "P": (0, 0)},
        fixed=["L", "M", "R"],
        bars={"left": ("L", "P"), "middle": ("M", "P"), "right": ("R", "P")},
        section=kt.General(area=1e-4, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
        material=kt.Material(E=100e9, density=0.0),
        loads={"load": kt.NodalForce(node="P", force=(0.0, -1000.0))},
        load_cases={"load": kt.LoadCase(loads={"load": 1.0})},
    )
    found, shared = kt.statics.linear(model, load_case="load"), kt.statics.at_poses(model, [{}])
    return {
        "middle": found.member_force.sel(member="middle").item() / 1000.0,
        "side": found.member_force.sel(member="left").item() / 1000.0,
        "sag": -found.displacement.sel(node="P", axis="y").item() * 100e9 * 1e-4 / 1000.0,
        "shared_middle": shared.member_force.sel(member="middle").item() / 1000.0,
    }
