"""Elastic beams along motions of drives: they keep their shape, carry what rigid ones would, and vibrate about it."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.errors import InputError

TUBE = kt.Tube(outer=0.03, inner=0.026)
STEEL = kt.library.materials.STEEL_S235
START, LONG, TIP = math.hypot(0.7, 1.0), 1.5, 4.0
SLEW = kt.Quintic(moves={"left": (START, START + 0.1)}, duration=0.5)


def truss(**changes) -> kt.Model:
    """A plate on two driven bars and a rigid one, a beam without mass that stands on it, and a mass at its tip."""
    fields = {
        "nodes": {"A": (0, 0), "B": (2, 0), "C": (0.7, 1), "D": (1.3, 1), "T": kt.Node(at=(0.7, 2.5), mass=TIP)},
        "fixed": ["A", "B"],
        "bars": {
            "left": kt.Bar(ends=("A", "C"), kind="driven"),
            "right": kt.Bar(ends=("B", "D"), kind="driven"),
            "cross": ("A", "D"),
        },
        "bodies": {"plate": kt.Body(nodes=("C", "D"))},
        "beams": {"arm": kt.Beam(ends=("C", "T"), mass=0.0)},
        "clamped": {"C": "plate"},
        "section": TUBE,
        "material": STEEL,
        "gravity": (0.0, -9.81),
    }
    return kt.Model(**(fields | changes))


@pytest.mark.slow
def test_a_beam_moves_and_carries_like_a_rigid_one():
    elastic = truss()
    stiff = truss(beams={"arm": kt.Beam(ends=("C", "T"), mass=0.0, kind="rigid")})
    moved, wanted = (kt.kinematics.follow(model, SLEW, samples=21) for model in (elastic, stiff))
    assert "Beams keep their shape: arm" in moved.message
    for name in ("position", "velocity", "acceleration"):
        ours, theirs = (one.data[name].sel(node=["C", "D", "T"]).values for one in (moved, wanted))
        np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-10 * max(1.0, np.abs(theirs).max()))
    ours, theirs = kt.dynamics.inverse(elastic, moved), kt.dynamics.inverse(stiff, wanted)
    bars, largest = ["left", "right", "cross"], float(np.abs(theirs.member_force).max())
    for got, ref in ((ours, theirs), (ours.static, theirs.static)):
        np.testing.assert_allclose(got.member_force.sel(member=bars), ref.member_force.sel(member=bars), atol=1e-9 * largest)
        np.testing.assert_allclose(got.reaction, ref.reaction, atol=1e-9 * largest)
    assert np.abs(ours.energy_balance).max() < 1e-9 * np.abs(ours.power).max()
    assert "Not in balance" not in ours.message


@pytest.mark.slow
def test_section_forces_along_a_motion_are_those_of_the_mass_at_the_tip():
    """At the clamp r x (g - a) m, everywhere the resultant (g - a) m; of the beam's own mass those of a rigid rod."""
    model = truss()
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, SLEW, samples=11))
    motion = forces.motion
    load = TIP * (np.array([0.0, -9.81]) - motion.acceleration.sel(node="T").values)
    r = (motion.position.sel(node="T") - motion.position.sel(node="C")).values
    moment = r[:, 0] * load[:, 1] - r[:, 1] * load[:, 0]
    along = kt.strength.beams(model, forces)
    scale = np.abs(moment).max()
    np.testing.assert_allclose(along.end_moment.sel(beam="arm", end="A", about="z"), -moment, atol=1e-9 * scale)
    np.testing.assert_allclose(along.section_M.sel(beam="arm", moment="3").values[:, -1], 0.0, atol=1e-9 * scale)
    np.testing.assert_allclose(along.end_force.sel(beam="arm", end="B"), load, atol=1e-12 * np.abs(load).max())
    heavy = truss(beams={"arm": kt.Beam(ends=("C", "T"), mass=6.0)})
    forces = kt.dynamics.inverse(heavy, motion)
    along, a = kt.strength.beams(heavy, forces), motion.acceleration
    g, ends = np.array([0.0, -9.81]), (a.sel(node="C").values, a.sel(node="T").values)
    # a uniform rod: int xi (g - a) dm along r, a linear in xi; the rotary inertia of the section adds 1e-4 of it
    own = 6.0 * (g / 2 - ends[0] / 6 - ends[1] / 3)
    whole = moment + r[:, 0] * own[:, 1] - r[:, 1] * own[:, 0]
    np.testing.assert_allclose(along.end_moment.sel(beam="arm", end="A", about="z"), -whole, atol=3e-4 * np.abs(whole).max())


@pytest.mark.slow
def test_frequencies_at_every_pose_are_in_closed_form():
    """On a rigid truss the mass on the beam has sqrt(3 E I/(m l^3)) across and sqrt(E A/(m l)) along it, in every pose."""
    model = truss(gravity=(0.0, 0.0), beams={"arm": kt.Beam(ends=("C", "T"), mass=0.0)})
    slow = kt.Quintic(moves={"left": (START, START + 0.3)}, duration=1e4)
    forces = kt.dynamics.inverse(model, kt.kinematics.follow(model, slow, samples=7))
    found = kt.flexible.frequencies(model, forces, rigid=("left", "right", "cross"), modes=2).frequency.values
    across = math.sqrt(3 * STEEL.E * TUBE.second_moments[1] / (TIP * LONG**3)) / (2 * math.pi)
    along = math.sqrt(STEEL.E * TUBE.area / (TIP * LONG)) / (2 * math.pi)
    np.testing.assert_allclose(found, np.tile([across, along], (7, 1)), rtol=1e-7)


def test_weight_along_a_beam_lowers_its_frequency_as_in_its_equilibrium():
    """Upright the tip's weight, 20 % of Euler's load, softens the beam: the pose has it from the force of the modes."""
    nodes = dict(truss().nodes) | {"T": kt.Node(at=(0.7, 2.5), mass=40.0)}
    model = truss(nodes=nodes, beams={"arm": kt.Beam(ends=("C", "T"), mass=0.1)})
    rest = kt.statics.equilibrium(model)
    stiff = ("left", "right", "cross")
    here = kt.flexible.frequencies(model, kt.statics.at_poses(model, [{}]), rigid=stiff, modes=1).frequency.values
    exact = kt.dynamics.linearise(model, rest).frequency.values[0]
    unloaded = kt.dynamics.linearise(model.with_(gravity=(0.0, 0.0))).frequency.values[0]
    assert here[0, 0] == pytest.approx(exact, rel=1e-4)
    assert exact < 0.96 * unloaded


def ring(radius: float, twist: float, height: float) -> list[tuple[float, ...]]:
    """Six places about z, in pairs."""
    angles = [k * math.pi / 3 + (-1) ** k * twist for k in range(6)]
    return [(radius * math.cos(angle), radius * math.sin(angle), height) for angle in angles]


def isolator(**changes) -> kt.Model:
    """A plate on six driven legs, and a beam of two elements that stands out from it with a mass at its end."""
    nodes = {f"B{k}": place for k, place in enumerate(ring(1.0, 0.2, 0.0))}
    nodes |= {f"P{k}": place for k, place in enumerate(ring(0.6, -0.25, 0.9))}
    nodes |= {"C": (0.0, 0.0, 1.0), "M": (0.5, 0.1, 1.3), "T": kt.Node(at=(0.9, 0.3, 1.7), mass=1.5)}
    top = (*(f"P{k}" for k in range(6)), "C")
    fields = {
        "nodes": nodes,
        "fixed": [f"B{k}" for k in range(6)],
        "bars": {f"leg{k}": kt.Bar(ends=(f"B{k}", f"P{k}"), kind="driven", mass=2.0) for k in range(6)},
        "bodies": {"plate": kt.Body(nodes=top, mass=30.0, carriers=("P0", "P2", "P4", "C"))},
        "beams": {"inner": ("C", "M"), "outer": ("M", "T")},
        "clamped": {"C": "plate"},
        "section": TUBE,
        "material": STEEL,
    }
    return kt.Model(**(fields | changes))


def shaken(model: kt.Model, duration: float) -> kt.Quintic:
    """All legs of an isolator change their length at once, each by its own amount."""
    start = {name: math.dist(*(model.nodes[end].at for end in model.bars[name].ends)) for name in model.all_drives}
    moves = {name: (long, long + 0.12 * math.sin(k)) for k, (name, long) in enumerate(start.items())}
    return kt.Quintic(moves=moves, duration=duration)


def test_moments_and_torques_of_a_bent_beam_in_space_are_those_of_the_mass_at_its_end():
    """At each end of both elements -(g - a) m and its moment about it, in motion and at rest; places as of rigid beams."""
    model = isolator(gravity=(0.3, -0.5, -9.81), beams={pair: kt.Beam(ends=tuple(pair), mass=0.0) for pair in ("CM", "MT")})
    motion = kt.kinematics.follow(model, shaken(model, 0.5), samples=9)
    stiff = model.with_(beams={name: one.with_(kind="rigid") for name, one in model.beams.items()})
    moved = kt.kinematics.follow(stiff, shaken(model, 0.5), samples=9)
    np.testing.assert_allclose(motion.position, moved.position, atol=1e-10)
    np.testing.assert_allclose(motion.data.singularity, moved.data.singularity, rtol=1e-6)
    forces = kt.dynamics.inverse(model, motion)
    place, a = motion.position, motion.acceleration
    for one, inertia in ((forces, a.sel(node="T").values), (forces.static, 0.0)):
        along, load = kt.strength.beams(model, one), 1.5 * (np.array([0.3, -0.5, -9.81]) - inertia)
        for beam in model.beams:
            for sign, end, node in zip((-1.0, 1.0), "AB", beam, strict=True):
                moment = np.cross((place.sel(node="T") - place.sel(node=node)).values, load)
                there = along.end_moment.sel(beam=beam, end=end).values
                np.testing.assert_allclose(there, sign * moment, atol=1e-10 * np.abs(load).max())
    assert np.abs(forces.data.mode_force.sel(beam="CM", mode="torsion")).max() > 1.0


def test_an_isolator_with_a_beam_along_its_drives_is_that_of_a_model_drawn_in_each_pose():
    """Frequencies along the motion are the eigenvalues of a model with elastic legs that is drawn there, with other frames."""
    model = isolator()
    motion = kt.kinematics.follow(model, shaken(model, 1e4), samples=5)
    found = kt.flexible.frequencies(model, kt.dynamics.inverse(model, motion), modes=6).frequency.values
    bars = {name: model.bars[name].with_(kind="elastic") for name in model.all_drives}
    for i in (0, 2, 4):
        nodes = {name: node.with_(at=tuple(motion.position.sel(node=name).values[i])) for name, node in model.nodes.items()}
        drawn = model.with_(nodes=nodes, bars=bars)
        exact = np.asarray(kt.dynamics.linearise(drawn).frequency.values)[:6]
        np.testing.assert_allclose(np.sort(found[i]), exact, rtol=1e-6)
    assert np.abs(found[-1] / found[0] - 1).max() > 1e-3


@pytest.mark.slow
def test_vibration_agrees_with_the_simulation():
    model = truss(gravity=(0.0, 0.0), beams={"arm": kt.Beam(ends=("C", "T"), mass=0.5)})
    motion = kt.kinematics.follow(model, SLEW, times=np.linspace(0, 0.05, 26))
    found = kt.flexible.vibration(model, kt.dynamics.inverse(model, motion), rigid=("cross",))
    run = kt.flexible.simulate(model, SLEW, t_end=0.05, samples=26, rigid=("cross",))
    there = (run.motion.position - motion.position).sel(node="T").values
    size = np.abs(there).max()
    assert size > 1e-4
    np.testing.assert_allclose(found.displacement.sel(node="T").values, there, atol=5e-3 * size)


def test_tasks_of_the_tip_move_the_drives():
    model = truss()
    wanted = kt.kinematics.inverse(model, kt.Quintic(moves={"T.x": (0.7, 0.9), "T.y": (2.5, 2.51)}, duration=1.0), samples=5)
    np.testing.assert_allclose(wanted.position.sel(node="T").values[-1], [0.9, 2.51], atol=1e-9)
    assert wanted.whole["length"].sel(member="arm.chord").values == pytest.approx(LONG, abs=1e-10)
    ends = {name: (START, float(wanted.drive_position.sel(drive=name)[-1])) for name in ("left", "right")}
    again = kt.kinematics.follow(model, kt.Quintic(moves=ends, duration=1.0), samples=3)
    np.testing.assert_allclose(again.position.sel(node="T").values[-1], [0.9, 2.51], atol=1e-9)


def test_drives_that_bend_a_beam_and_beams_that_balance_alone_does_not_decide():
    model = truss(drives={"tip": kt.CoordinateDrive(node="T", axis="x")})
    with pytest.raises(InputError, match=r"contradict each other.*beams keep their shape.*dynamics\.simulate"):
        kt.kinematics.follow(model, kt.Quintic(moves={"tip": (0.7, 0.8)}, duration=1.0))
    loose = truss(beams={"arm": kt.Beam(ends=("C", "T"), release=["C"])}, clamped={})
    with pytest.raises(InputError, match="freedom"):
        kt.kinematics.follow(loose, SLEW)
    # two beams side by side from the plate to one node: how they share is not a question of balance alone
    twice = truss(beams={"arm": ("C", "T"), "brace": ("D", "T")}, clamped={"C": "plate", "D": "plate"})
    motion = kt.kinematics.follow(twice, SLEW, samples=5)
    np.testing.assert_allclose(motion.whole["length"].sel(member=["arm.chord", "brace.chord"]).std("time"), 0.0, atol=1e-9)
    forces = kt.dynamics.inverse(twice, motion)
    assert "Balance alone does not decide the forces of the beams arm, brace" in forces.message
    assert not {"left", "right", "cross"} & set(forces.attrs["not_unique"])
    # the bars below carry the weight of both beams all the same, whatever share each beam has
    stiff = twice.with_(beams={name: beam_of.with_(kind="rigid") for name, beam_of in twice.beams.items()})
    wanted = kt.dynamics.inverse(stiff, kt.kinematics.follow(stiff, SLEW, samples=5))
    bars = ["left", "right", "cross"]
    ours, theirs = (one.member_force.sel(member=bars).values for one in (forces, wanted))
    np.testing.assert_allclose(ours, theirs, atol=1e-3 * np.abs(theirs).max())
    verdict = kt.strength.check(twice, forces)
    assert {row.note.partition(":")[0] for row in verdict.table() if row.part in ("arm", "brace") and row.rule == "yield"} == {
        "not checked"
    }
    with pytest.raises(InputError, match=r"statics\.equilibrium"):
        kt.flexible.frequencies(twice, forces)
    # nor is how a beam and a rigid bar beside it share
    beside = truss(bars=dict(truss().bars) | {"side": ("C", "T")})
    forces = kt.dynamics.inverse(beside, kt.kinematics.follow(beside, SLEW, samples=5))
    assert (forces.attrs["undecided"], forces.attrs["not_unique"]) == (["arm"], ["side"])


def test_missions_have_beams_along_motions_of_drives(tmp_path):
    model = truss(
        trajectories={"slew": SLEW},
        conditions={"laden": kt.Condition(payloads={"T": 3.0})},
        runs={
            "tilt": kt.Run(trajectory="slew", samples=21),
            "all": kt.Run(analysis="mission", motions=("tilt",), conditions=("laden",)),
        },
    )
    assert kt.check(model) == []
    mission = kt.run(model, "all", tmp_path / "out")
    laden = kt.under(model, "laden")
    forces = kt.dynamics.inverse(laden, kt.kinematics.follow(laden, "slew", samples=21))
    stress = float(kt.strength.beams(laden, forces, stations=97).von_mises.max())
    for one in (mission, kt.runs.load(tmp_path / "out")):
        row = next(row for row in one.verdict.table() if (row.part, row.rule) == ("arm", "yield"))
        assert row.value == pytest.approx(stress, rel=1e-9)
    alone = kt.run(model, "tilt", tmp_path / "alone")
    again = kt.runs.load(tmp_path / "alone")
    assert again.forces["all"].mode_force.values == pytest.approx(alone.forces["all"].mode_force.values)
