"""Examples of everyday machines: the answer that each gives, one of its forces by hand, and what the page of examples says."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kinetruss as kt

pytestmark = pytest.mark.slow

DOCS = Path(__file__).parents[2] / "docs"
PAGE, OPTIMUM = ((DOCS / name).read_text(encoding="utf-8") for name in ("examples.md", "optimum.md"))
g = 9.81


def ran(name: str, samples: int) -> Any:
    """The first run of an example, with few samples."""
    model = kt.read(kt.library.example_files()[name][0])
    run = next(iter(model.runs))
    return kt.run(model.with_(runs={**model.runs, run: model.runs[run].with_(samples=samples)}), run)


def said(name: str) -> str:
    """The row of an example on the page."""
    return re.search(rf"^\| \[?`{name}`.*$", PAGE, re.MULTILINE)[0]


def quantity(run: Any, name: str) -> np.ndarray:
    """The values of a quantity over time."""
    return next(iter(run.quantities.values())).value.sel(quantity=name).values


def test_scissor_lift():
    """s^2 = 0.09 x^2 + 0.25 h^2 and x^2 + h^2 = 4 m^2: F = W dh/ds = W s/(0.16 h)."""
    run = ran("scissor_lift", 5)
    h = quantity(run, "height")
    legs = 2 * 2.0 * 0.06 * 0.12 * kt.library.materials.STEEL_S355.density
    thrust = g * (1150 + legs / 2 + 40 * 0.35) * np.sqrt(0.36 + 0.16 * h**2) / (0.16 * h)
    np.testing.assert_allclose(quantity(run, "thrust"), thrust, rtol=1e-12)
    for case in ("middle", "edge"):  # where the load stands is nothing to the cylinder: the table stays level
        np.testing.assert_allclose(run.forces[case].drive_force.sel(drive="cylinder"), thrust, rtol=2e-4)
    assert run.finding.state == "ok"
    assert f"{quantity(run, 'pressure').max():.0f} bar" in said("scissor_lift")


def test_loader_crane():
    """Moments about the foot (0, 2) of the boom; the line of the cylinder goes from (0.4, 0.6) to (0.9, 2)."""
    run = ran("loader_crane", 9)
    area = np.pi / 4 * 0.08**2
    moment = g * (1000 * 6 + 70 * 4.5 + 120 * 1.5 + 40 * 2.5 + 50 * 0.45)
    thrust = moment / (0.4 * 1.4 + 1.4 * 0.5) * np.hypot(0.5, 1.4)
    drives = run.forces["all"].drive_force
    assert drives.sel(drive="lift")[0].item() == pytest.approx(thrust, rel=1e-4)  # at rest, of lengths to 0.01 mm
    for drive in ("lift", "fold"):
        pressure = quantity(run, f"{drive}_pressure")
        force = drives.sel(drive=drive).values
        np.testing.assert_allclose(force[[0, -1]], 1e5 * area * pressure[[0, -1]], rtol=1e-9)
        np.testing.assert_allclose(force, 1e5 * area * pressure, rtol=0.02)
        assert f"{pressure.max():.0f} bar" in said("loader_crane")
    assert run.finding.state == "ok"
    assert np.argmax(quantity(run, "lift_pressure")) == 8  # not at full reach


def test_landing_gear():
    """At rest the ground carries what the wings do not, and moments about the pin of the arm give the strut."""
    run = ran("landing_gear", 61)
    for name in ("load_factor", "stroke"):
        assert quantity(run, name)[0] < quantity(run, name).max()
    assert f"{quantity(run, 'load_factor').max():.2f}" in said("landing_gear")
    assert f"{1e3 * quantity(run, 'stroke').max():.0f} mm" in said("landing_gear")
    assert run.finding.state == "ok"
    rest = kt.dynamics.simulate(run.model, 10.0, samples=2)
    Q, S, K, W = (rest.motion.position.sel(node=name).values[-1] for name in "QSKW")
    arm = kt.library.materials.STEEL_S355.density * 0.05 * 0.08 * np.hypot(0.5, 0.35)
    ground = g * (400 + 12 + 6 + arm) - 2616
    assert 150e3 * (0.2 - W[1]) == pytest.approx(ground, rel=1e-4)
    along = (S - K) / np.linalg.norm(S - K)
    lever = K[0] * along[1] - (K - Q)[1] * along[0]
    moment = ground * W[0] - g * (12 * W[0] + arm * W[0] / 2 + 3 * K[0])
    force = rest.forces.member_force.sel(member="strut").values[-1]
    assert force == pytest.approx(-moment / lever, rel=1e-4)


def test_adaptive_footbridge():
    """Three hinges: q l^2/8 of the crowd over the depth; the deflection times depth over half the span, twice."""
    model = kt.read(kt.library.example_files()["adaptive_footbridge"][0])
    run = kt.run(model, "stand")
    pull = {case: run.forces[case].member_force.sel(member="actuator").item() for case in ("sls.G", "sls.crowd.G+crowd")}
    assert pull["sls.crowd.G+crowd"] - pull["sls.G"] == pytest.approx(6250 * 24**2 / 8 / 1.5, rel=1e-9)
    assert run.finding.state == "ok"
    assert {row.load_case.split(".")[0] for row in run.finding.quantities} == {"sls"}
    low = {case: one.value.item() for case, one in run.quantities.items() if case.startswith("sls")}
    assert f"{-1e3 * min(low.values()):.1f} mm" in said("adaptive_footbridge")
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"actuator": (4.0, 4.0)}, duration=10.0), samples=2)
    change = {}
    for case in pull:
        forces = kt.dynamics.inverse(model, motion, load_case=case)
        change[case] = kt.flexible.corrected(model, forces, at="D3.y").change.values[0, 0]
        assert change[case] == pytest.approx(low[case] * 2 * 1.5 / 12, rel=0.01)
    assert f"{1e3 * (change['sls.G'] - change['sls.crowd.G+crowd']):.1f} mm" in said("adaptive_footbridge")


def test_press():
    """The crank r stands across the link, the arms l at a: ram 2 l (1 - cos a), knee l a' = r c' to first order; M/(2 r a)."""
    run = ran("press", 5)
    a, press = quantity(run, "knee")[-1], quantity(run, "press")[-1]
    assert np.degrees(a) == pytest.approx(3, abs=1e-3)
    K, C, O = (run.motion.position.sel(node=name).values[-1] for name in "KCO")
    along = (C - K) / np.linalg.norm(C - K)
    crank = np.array([-(C - O)[1], (C - O)[0]]) @ along
    knee = 0.3 * np.array([np.cos(a), np.sin(a)]) @ along
    assert press == pytest.approx(0.2 / abs(2 * 0.3 * np.sin(a) * crank / knee), rel=1e-9)
    assert press == pytest.approx(0.2 / (2 * 0.06 * a), rel=0.01)
    torque = run.forces["all"].drive_force.sel(drive="motor").values
    squeezed = 2e-3 - run.motion.position.sel(node="R", axis="y").values[-1]
    assert torque[-1] == pytest.approx(200 * 25e6 * squeezed / (1e3 * press), rel=1e-3)  # inertia adds little
    np.testing.assert_allclose(torque, quantity(run, "torque"), atol=0.05)
    assert f"{press:.1f} kN" in said("press")
    assert f"{torque[-1]:.0f} N m" in said("press")
    assert run.finding.state == "ok"


def test_press_with_another_crank():
    """The task beside the model: stroke and work stay, k s^2/2 of the workpiece, and the peak of the torque falls."""
    _, task = kt.library.example_files()["press"]
    found = kt.design.optimise(None, kt.io.read_optimum(task))
    peak, turned = {}, {}
    for word, model in (("before", kt.read(kt.library.example_files()["press"][0])), ("after", found.model)):
        run = kt.run(model)
        height = run.motion.position.sel(node="R", axis="y").values
        assert (height[0], height[-1]) == pytest.approx((9.1e-3, 0.83e-3), abs=2e-5)
        torque = run.forces["all"].drive_force.sel(drive="motor").values
        angle = run.motion.drive_position.sel(drive="motor").values
        assert np.trapezoid(torque, angle) == pytest.approx(25e6 * (2e-3 - height[-1]) ** 2 / 2, rel=0.01)
        peak[word], turned[word] = torque.max(), np.ptp(angle[height < 2e-3])
        assert run.finding.state == "ok"
    assert found.certificate.first_order
    assert f"needs {peak['before']:.0f} N m" in OPTIMUM
    assert f"to {peak['after']:.0f} N m, by {100 * (1 - peak['after'] / peak['before']):.0f} %" in OPTIMUM
    assert f"{turned['after']:.2f} rad of the turn" in OPTIMUM
    assert f"in {turned['before']:.2f} rad" in OPTIMUM


def test_folding_array():
    """Without dampers the springs' energy E goes into the stop: (K + k (1 + 4 + 4)) f^2/2 - M (1 + 2 + 2) f = E."""
    run = ran("folding_array", 1201)
    assert f"{quantity(run, 'blow').max():.1f} N m" in said("folding_array")
    still = run.motion.time.values[np.abs(quantity(run, "root_angle")) > np.radians(0.1)].max()
    assert f"{still:.1f} s" in said("folding_array")
    assert run.finding.state == "ok"
    model = run.model
    free = model.with_(springs={name: one.with_(damping=0.0) for name, one in model.springs.items()})
    start = np.radians(88)
    energy = sum(0.5 * 0.5 * (n * start) ** 2 + 0.2 * n * start for n in (1, 2, 2))
    push = np.roots([0.5 * (2000 + 0.5 * 9), -0.2 * 5, -energy]).max()
    hit = kt.dynamics.simulate(free, 4.2, samples=2101)
    deepest = -kt.kinematics.quantities(free, hit).value.sel(quantity="root_angle").values.min()
    assert deepest == pytest.approx(push, rel=3e-4)


def test_balanced_arm():
    """The task beside the model finds its springs, rounded; without them the motors are too small."""
    run = ran("balanced_arm", 31)
    bars = {name: bar for name, bar in run.model.bars.items() if bar.kind != "elastic"}
    bare = kt.run(run.model.with_(bars=bars, quantities={}))
    for one, state in ((run, "ok"), (bare, "over")):
        assert one.finding.state == state
        peak = max(np.abs(forces.drive_force).max().item() for forces in one.forces.values())
        rows = [row for demand in one.demand.values() for row in demand.table() if row.rule == "rms current"]
        current = max(row.utilisation for row in rows)
        assert f"{peak:.1f} N m" in said("balanced_arm")
        assert f"{100 * current:.0f} %" in said("balanced_arm")
    _, task = kt.library.example_files()["balanced_arm"]
    found = kt.design.optimise(None, kt.io.read_optimum(task))
    assert found.certificate.first_order
    for name in ("shoulder_spring", "elbow_spring"):
        assert run.model.bars[name].stiffness == pytest.approx(found.model.bars[name].stiffness, rel=0.01)
        assert run.model.bars[name].natural_length == pytest.approx(found.model.bars[name].natural_length, rel=1e-6)
    for node in "SKBC":
        np.testing.assert_allclose(run.model.nodes[node].at, found.model.nodes[node].at, atol=2e-3)
    loaded, empty = (np.abs(forces.drive_force).max().item() for forces in kt.run(found.model).forces.values())
    assert loaded == pytest.approx(empty, rel=0.01)
    assert f"to {max(loaded, empty):.1f} N m" in OPTIMUM
