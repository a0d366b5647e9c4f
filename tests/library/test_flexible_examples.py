"""Elastic examples: a tower straightened under wind, by equilibria of another model and by work."""

from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt

PAGE = (Path(__file__).parents[2] / "docs" / "examples.md").read_text(encoding="utf-8")
TOP = ("B8.N4", "B8.N5.y", "B8.N5.z", "B8.N6.z")


def shipped(name):
    return kt.read(kt.library.example_files()[name][0])


@pytest.fixture(scope="module")
def tower():
    model = shipped("wind_tower")
    forces = kt.statics.at_poses(model, [{}], load_case="wind")
    return model, forces, kt.flexible.corrected(model, forces, at=TOP)


def nodal_loads(model, x):
    """Wind and weight on the nodes, N: half of a bar's weight at each end; rods of an actuator by their centres.

    A rod clamped at A with its centre at distance c pulls B by (c/l) (1 - u u') m g, and A by the rest.
    """
    g = np.array(model.gravity)
    F = {name: node.mass * g for name, node in model.nodes.items()}

    def weighs(bar):
        return model.materials[bar.material].density * model.sections[bar.section].area

    for bar in model.bars.values():
        for end in bar.ends:
            F[end] = F[end] + weighs(bar) * np.linalg.norm(np.subtract(*(model.nodes[e].at for e in bar.ends))) / 2 * g
    for member in model.active.values():
        for part, (a, b) in ((member.base, member.ends), (member.tube, member.ends[::-1])):
            d = x[b] - x[a]
            u = d / np.linalg.norm(d)
            far = part.length / 2 / np.linalg.norm(d) * part.mass * (g - u * (u @ g))
            F[b], F[a] = F[b] + far, F[a] + part.mass * g - far
    for load in model.loads.values():
        F[load.node] = F[load.node] + np.array(load.force)
    return F


def elastic(model, forces, changes, loads):
    """The tower as elastic bars without mass under nodal loads; actuators with changed natural lengths."""
    long = {str(m): forces.motion.length.sel(member=m).item() for m in forces.motion.length.member.values}
    bars = {}
    for name, member in {**model.bars, **model.active}.items():
        part = member if name in model.bars else member.tube  # the weaker of the two rods
        area = (model.sections[part.section] if isinstance(part.section, str) else part.section).area
        k = model.materials[part.material].E * area / long[name]
        bars[name] = kt.Bar(ends=member.ends, kind="elastic", stiffness=k, natural_length=long[name] + changes.get(name, 0.0))
    return kt.Model(
        nodes={name: node.at for name, node in model.nodes.items()},
        bars=bars,
        fixed=model.fixed,
        loads={name: kt.NodalForce(node=name, force=tuple(F)) for name, F in loads.items()},
    )


def places(model, position):
    return {name: position.sel(node=name).values for name in model.nodes}


@pytest.mark.slow
def test_corrected_lengths_straighten_the_tower_in_another_model(tower):
    """Nonlinear equilibrium of elastic bars with the lengths found: all six coordinates of the top, and all forces."""
    model, forces, found = tower
    x = places(model, (forces.motion.position + found.displacement).isel(time=0))
    changes = {str(d): found.change.sel(drive=d).item() for d in found.drive.values}
    loads = nodal_loads(model, x)
    bent, straight = (kt.statics.equilibrium(elastic(model, forces, c, loads)) for c in ({}, changes))
    design = places(model, forces.motion.position.isel(time=0))
    for coordinate in ("B8.N4.x", "B8.N4.y", "B8.N4.z", *TOP[1:]):
        node, axis = coordinate.rsplit(".", 1)
        k = "xyz".index(axis)
        assert straight.position.sel(node=node).values[k] == pytest.approx(design[node][k], abs=1e-9), coordinate
    assert (bent.position.sel(node="B8.N6", axis="y").item() - design["B8.N6"][1]) > 0.04
    for member in model.bars:
        got = straight.member_force.sel(member=member).item()
        assert got == pytest.approx(found.member_force.sel(member=member).item(), abs=1e-3), member


@pytest.mark.slow
def test_work_of_the_actuators_is_what_the_tower_and_its_loads_gain(tower):
    """Slow straightening: the integral of tension over length = change of strain energy less the work of wind and weight."""
    model, forces, found = tower
    loads = nodal_loads(model, places(model, forces.motion.position.isel(time=0)))
    changes = {str(d): found.change.sel(drive=d).item() for d in found.drive.values}
    points, shares = np.polynomial.legendre.leggauss(3)
    energy, tension = [], []
    for share in (0.0, 1.0, *(1 + points) / 2):
        soft = elastic(model, forces, {name: share * change for name, change in changes.items()}, loads)
        rest = kt.statics.equilibrium(soft)
        N = rest.member_force
        strain = sum(N.sel(member=name).item() ** 2 / (2 * bar.stiffness) for name, bar in soft.bars.items())
        work = sum(F @ (rest.position.sel(node=name).values - model.nodes[name].at) for name, F in loads.items())
        energy.append(strain - work)
        # natural length l0 grows by dl0: the energy k (l - l0)^2/2 changes by -N dl0
        tension.append(-sum(N.sel(member=name).item() * change for name, change in changes.items()))
    done = float(shares / 2 @ tension[2:])
    assert done == pytest.approx(energy[1] - energy[0], rel=1e-6)
    assert done > 100


def test_the_run_has_the_lengths_that_straighten(tower):
    model, _, found = tower
    for name, (start, end) in model.runs["straighten"].trajectory.moves.items():
        assert end == pytest.approx(found.drive_length.sel(drive=name).item(), abs=1e-5)
        assert start == pytest.approx(found.drive_length.sel(drive=name).item() - found.change.sel(drive=name).item(), abs=1e-5)


def test_virtual_work_of_the_wind(tower):
    """What the wind adds to the force of each drive = - wind times how the nodes move with its length."""
    model, forces, _ = tower
    calm = kt.statics.at_poses(model, [{}], load_case="calm")
    added = (forces.drive_force - calm.drive_force).isel(time=0)
    of = [f"{load.node}.y" for load in model.loads.values()]
    wind = np.array([load.force[1] for load in model.loads.values()])
    J = kt.kinematics.jacobian(model, of=of)
    for drive in added.drive.values:
        column = J.isel({J.dims[1]: list(J[J.dims[1]].values).index(drive)}).values
        assert added.sel(drive=drive).item() == pytest.approx(-wind @ column, rel=1e-9), drive


@pytest.mark.slow
def test_the_page_says_what_the_tower_does(tower):
    model, forces, found = tower
    bent = kt.statics.deflection(model, forces).displacement.isel(time=0).sel(node=["B8.N4", "B8.N5", "B8.N6"], axis="y")
    run = kt.run(model, "straighten")
    power = (run.forces["wind"].drive_force * run.motion.drive_velocity).sum("drive").values
    section = PAGE.split("## A tower in wind")[1].split("## ")[0]
    assert f"{1e3 * bent.mean().item():.1f} mm" in section
    assert (
        f"from {1e3 * found.change.min().item():.1f} to +{1e3 * found.change.max().item():.1f} mm".replace("-", "−") in section
    )
    assert f"{np.trapezoid(power, run.motion.time.values):.0f} J" in section
    difference = np.abs(found.member_force - forces.member_force).max().item()
    assert f"{difference:.0f} N" in section
