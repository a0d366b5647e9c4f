"""Members of a truss in space as beams pinned at both ends: they bend under weight, inertia and loads; nothing else changes."""

import numpy as np
import pytest

import kinetruss as kt

G = np.array([0.0, 0.0, -9.81])
BARS = kt.library.vgt.double_octahedral(gravity=tuple(G), payload_mass=2.0, rotary_inertia=True)
SLEW = kt.Quintic(moves={"bay.beta": (-0.1, 0.17), "bay.gamma": (0.0, 0.14)}, duration=1.0)
POSES = [{"bay.beta": 0.17, "bay.gamma": -0.1}, {"bay.height": 1.15}]
EVERY = ("M?", "M1?", "M2?")


def pinned(kind):
    """All 15 bars as rigid links, elastic links, or elastic beams."""
    if kind == "beams":
        beams = {
            name: kt.Beam(ends=bar.ends, release=bar.ends, section="bar", material="bar", orientation=bar.orientation)
            for name, bar in BARS.bars.items()
        }
        return BARS.with_(bars={}, beams=beams)
    return kt.model.bars_as_links(BARS, *EVERY, kind=kind)


def sizes(values):
    return np.linalg.norm(values, axis=-1)


@pytest.mark.parametrize("kind", ["rigid", "elastic", "beams"])
def test_at_rest_each_bends_as_a_beam_on_two_supports(kind):
    """M = w L^2/8 across the member in its middle; forces at all nodes are those of bars."""
    model = pinned(kind)
    found, bars = kt.statics.at_poses(model, POSES), kt.statics.at_poses(BARS, POSES)
    for name in ("drive_force", "reaction"):
        np.testing.assert_allclose(found.data[name], bars.data[name], atol=1e-11)
    along = kt.strength.beams(model, found, stations=[0.0, 0.5, 1.0])
    x = bars.motion.position
    for name, bar in BARS.bars.items():
        a, b = (x.sel(node=end).values for end in bar.ends)
        L, w = sizes(b - a)[0], BARS.sections["bar"].area * BARS.materials["bar"].density * 9.81
        level = sizes((b - a)[:, :2]) / L
        M = sizes(along.section_M.sel(beam=name).values)
        np.testing.assert_allclose(M[:, 1], w * L**2 * level / 8, rtol=1e-10)
        np.testing.assert_allclose(M[:, [0, 2]], 0, atol=1e-10)
        ends = along.end_force.sel(beam=name).sum("end").values
        np.testing.assert_allclose(ends, np.broadcast_to((0, 0, w * L), ends.shape), atol=1e-10)


@pytest.mark.parametrize("kind", ["rigid", "elastic", "beams"])
def test_in_motion_inertia_bends_them(kind):
    """M = m L |p|/8 in the middle, p the part of a - g across the member there; nodes and drives do as with bars.

    What is left, 1e-7 of moments and 1e-8 of forces, is the inertia of tubes about their own axes, which bars do not have.
    """
    model = pinned(kind)
    motion, bars = (kt.kinematics.follow(one, SLEW, samples=5) for one in (model, BARS))
    found, plain = kt.dynamics.inverse(model, motion), kt.dynamics.inverse(BARS, bars)
    nodes = list(BARS.nodes)
    np.testing.assert_allclose(motion.position.sel(node=nodes), bars.position, atol=1e-13)
    for name in ("drive_force", "reaction"):
        np.testing.assert_allclose(found.data[name], plain.data[name], atol=1e-6)
    along, sections = kt.strength.beams(model, found, stations=[0.25, 0.5]), kt.strength.sections(BARS, plain, [0.25, 0.5]).data
    for name, bar in BARS.bars.items():
        (a, b), (ua, ub) = (
            [history.sel(node=end).values for end in bar.ends] for history in (bars.position, bars.acceleration)
        )
        u = (b - a) / sizes(b - a)[:, None]
        p = 0.5 * (ua + ub) - G
        p -= np.vecdot(p, u)[:, None] * u
        L = sizes(b - a)
        m = BARS.sections["bar"].area * BARS.materials["bar"].density * L
        M = sizes(along.section_M.sel(beam=name).values)
        np.testing.assert_allclose(M[:, 1], m * L * sizes(p) / 8, rtol=1e-6)
        np.testing.assert_allclose(M, sizes(sections.section_M.sel(part=name).values), rtol=1e-6)
        np.testing.assert_allclose(along.section_T.sel(beam=name).values, sections.section_T.sel(part=name).values, atol=2e-6)


def test_one_that_is_held_against_its_spin_bends_no_other():
    """The verdict of all other members is that of the truss of bars, without a word on the spin."""
    model = kt.model.bars_as_links(BARS, "M6")
    found, plain = (kt.strength.check(one, kt.statics.at_poses(one, POSES)) for one in (model, BARS))
    assert "spin" not in found.message and not any("spin" in str(row) for row in found.table())
    mine = {(row.member, row.rule): row for row in found.table()}
    for row in plain.table():
        if row.member != "M6":
            assert mine[row.member, row.rule].utilisation == pytest.approx(row.utilisation, rel=1e-9, nan_ok=True)


def test_a_load_along_one_bends_it_as_a_bar():
    """Uniform load and a force at 30 %: q L^2/8 and more, as the section forces of bars have it; the same drive forces."""
    loads = {
        "wind": kt.MemberLoad(member="M6", force=(0, 20, -30)),
        "lamp": kt.MemberPointForce(member="M6", force=(0, 5, -30), at="30 %"),
    }
    model, bars = (one.with_(loads=loads) for one in (pinned("elastic"), BARS))
    found, plain = (kt.statics.at_poses(one, POSES) for one in (model, bars))
    np.testing.assert_allclose(found.drive_force, plain.drive_force, atol=1e-11)
    M = sizes(kt.strength.beams(model, found, stations=[0.3, 0.5, 0.8]).section_M.sel(beam="M6").values)
    same = sizes(kt.strength.sections(bars, plain, [0.3, 0.5, 0.8]).data.section_M.sel(part="M6").values)
    np.testing.assert_allclose(M, same, rtol=1e-10)
    assert M.min() > 2.0


@pytest.mark.slow
def test_simulated_they_move_as_bars():
    """Released actuators let the truss fall: places after 0.2 s, and energy."""
    falling = {"tasks": {name: kt.Free() for name in ("M7", "M9", "M11")}, "samples": 3, "t_end": 0.2}
    run, plain = (kt.dynamics.simulate(one, **falling) for one in (pinned("rigid"), BARS))
    nodes = list(BARS.nodes)
    assert np.abs(plain.motion.position[-1] - plain.motion.position[0]).max() > 0.05
    np.testing.assert_allclose(run.motion.position.sel(node=nodes), plain.motion.position, atol=1e-8)
    assert np.ptp(run.energy.values) < 1e-8


def test_bars_that_are_no_links_are_refused():
    cases = {
        "M7": "none is called 'M7'",
        "rope": "is cable: a link keeps its length",
        "short": "is given, which links do not have",
    }
    nodes = {"A": (0, 0, 0), "B": (1, 0, 0)}
    bars = {"rope": kt.Bar(ends=("A", "B"), kind="cable", stiffness=1e3), "short": kt.Bar(ends=("A", "B"), length=1.0)}
    model = kt.Model(nodes=nodes, bars=bars, fixed=["A"])
    for name, words in cases.items():
        with pytest.raises(kt.errors.ModelError, match=words):
            kt.model.bars_as_links(model, name)
