"""Results have the nodes, members and supports of the user; inner parts stay in `whole`, with which analyses go on."""

from functools import cache

import numpy as np
import pytest
import xarray as xr

import kinetruss as kt
from kinetruss.mechanics import compile
from kinetruss.results.user_parts import completed, held_forces, marked, users

STEEL = kt.Material(E=210e9, density=7850, poisson=0.3)


def frame(**more):
    """A cantilever in space with a corner, 3 m and 2 m, clamped at A, loaded at its end."""
    nodes = {"A": (0, 0, 0), "B": (3.0, 0, 0), "C": (3.0, 2.0, 0)}
    beams = {"arm": ("A", "B"), "up": ("B", "C")}
    loads = {"F": kt.NodalForce(node="C", force=(10.0, 0.0, -40.0))}
    given = {"gravity": (0, 0, 0), "section": kt.Rod(diameter=0.05), "material": STEEL, **more}
    return kt.Model(nodes=nodes, beams=beams, clamped=["A"], loads=loads, **given)


def lever():
    """A planar beam that hangs from a pin and swings, with a bar at its end."""
    nodes = {"A": (0, 0), "B": (1.0, 0), "C": (1.0, -1.0)}
    return kt.Model(
        nodes=nodes, fixed=["A"], beams={"arm": ("A", "B")}, bars={"rod": ("B", "C")},
        gravity=(0, -9.81), section=kt.Rod(diameter=0.02), material=STEEL,
    )  # fmt: skip


def names_in(data):
    found = set()
    for one in data.variables.values():
        if one.dtype.kind in "UO":
            found |= {str(name) for name in np.ravel(one.values)}
    return found


@cache
def run():
    return kt.dynamics.simulate(frame(), t_end=1e-3)


@cache
def rest():
    return kt.statics.equilibrium(frame())


RESULTS = {
    "motion": lambda: run().motion,
    "forces": lambda: run().forces,
    "equilibrium": rest,
    "linear": lambda: kt.statics.linear(frame()),
    "path": lambda: kt.statics.path(frame(), "F", points=5),
    "buckling": lambda: kt.statics.buckling(frame(), "F"),
    "linearisation": lambda: kt.dynamics.linearise(frame(), rest()),
    "frequencies": lambda: kt.flexible.frequencies(frame(), kt.runs.forces_at_rest(frame())),
}


@pytest.mark.parametrize("name", RESULTS)
def test_no_result_has_inner_parts(name):
    model, result = frame(), RESULTS[name]()
    inner = model.whole.inner
    assert not names_in(result.data) & {*inner.nodes, *inner.bars, *inner.couplings}
    assert list(result.data["node"].values) == list(model.nodes)
    assert {"inner_node", "held"}.isdisjoint(result.data.variables)
    assert result.whole.sizes["node"] == len(model.whole.nodes)
    assert not names_in(result.to_dataframe().reset_index().to_xarray()) & {*inner.nodes, *inner.bars}


@pytest.mark.parametrize("of", [kt.statics.linear, kt.statics.equilibrium, kt.runs.forces_at_rest])
def test_a_clamp_has_the_whole_force_and_the_moment(of):
    """R = -F, M = -r x F, in an equilibrium with r to where the load is then."""
    found = of(frame())
    force, arm = np.array([10.0, 0.0, -40.0]), np.array([3.0, 2.0, 0.0])
    if of is kt.statics.equilibrium:
        arm = found.position.sel(node="C").values
    np.testing.assert_allclose(np.ravel(found.reaction.sel(support="A")), -force, atol=1e-8)
    moment = np.ravel(found.reaction_moment.sel(support="A"))
    np.testing.assert_allclose(moment, -np.cross(arm, force), atol=1e-7)


def test_in_motion_the_forces_of_a_clamp_balance_the_change_of_momentum():
    model = frame(gravity=(0, 0, -9.81))
    run = kt.dynamics.simulate(model, t_end=2e-3, samples=201)
    reaction, t = run.forces.reaction.sel(support="A").values, run.motion.time.values
    weight = 7850 * np.pi * 0.05**2 / 4 * 5.0 * 9.81
    left = run.momentum.values - run.momentum.values[0]
    total = reaction + np.array([10.0, 0.0, -40.0 - weight])
    impulse = np.concatenate([[np.zeros(3)], np.cumsum((total[1:] + total[:-1]) / 2 * np.diff(t)[:, None], axis=0)])
    assert np.abs(impulse - left).max() < 1e-3 * np.abs(left).max()


def test_a_motion_that_the_user_cuts_goes_on():
    model = lever()
    run = kt.dynamics.simulate(model, t_end=0.05, samples=11)
    cut = run.motion.with_(data=run.motion.data.isel(time=slice(2, 5)))
    again = kt.dynamics.inverse(model, cut)
    assert cut.data.sizes["time"] == 3
    np.testing.assert_array_equal(cut.whole["position"].values, run.motion.whole["position"].values[2:5])
    np.testing.assert_allclose(again.member_force, run.forces.member_force[2:5], rtol=1e-6, atol=1e-6)


def test_a_change_of_the_user_is_kept():
    motion = kt.dynamics.simulate(lever(), t_end=0.01, samples=3).motion
    moved = motion.with_(data=motion.data.assign(position=motion.position + 1.0))
    np.testing.assert_array_equal(moved.position, motion.position + 1.0)
    np.testing.assert_array_equal(moved.whole["position"].values[:, 3:], motion.whole["position"].values[:, 3:])


def test_inner_parts_between_those_of_the_user_keep_their_values():
    values = np.arange(4.0)
    whole = xr.Dataset(
        {"mass": ("node", values)}, coords={"node": list("abcd"), "inner_node": ("node", [False, True, False, True])}
    )
    own = users(whole)
    assert own.mass.values.tolist() == [0.0, 2.0] and list(own.node.values) == ["a", "c"]
    back = completed(own.assign(mass=own.mass * 10), whole)
    assert back.mass.values.tolist() == [0.0, 1.0, 20.0, 3.0]


def test_instants_that_a_result_lacks_are_refused():
    motion = kt.dynamics.simulate(lever(), t_end=0.01, samples=3).motion
    with pytest.raises(kt.InputError, match="inner parts, which represent beams, bodies and hubs, are not known there"):
        motion.with_(data=motion.data.assign_coords(time=motion.time + 1.0))


def test_positions_without_those_of_frames_are_refused_and_the_result_is_taken():
    model = frame()
    rest = kt.statics.equilibrium(model)
    with pytest.raises(kt.InputError, match="not the 9 inner ones that represent its beams"):
        kt.statics.linear(model, rest.position)
    np.testing.assert_array_equal(
        kt.statics.linear(model, rest).displacement, kt.statics.linear(model, rest.whole["position"]).displacement
    )


def test_runs_of_earlier_versions_are_read_with_marks_and_whole_clamps():
    model = frame()
    forces = kt.runs.forces_at_rest(model)
    names, held = held_forces(forces.whole)
    old = forces.whole.drop_vars(["inner_node", "inner_member", "reaction", "reaction_moment", "held_force", "held", "support"])
    old = old.assign(reaction=(("time", "support", "axis"), held)).assign_coords(support=names)
    found = marked(compile(model), old, forces.motion.whole["position"])
    assert forces.with_(data=found).data.drop_vars("rotation").broadcast_equals(forces.data.drop_vars("rotation"))


def test_a_model_without_inner_parts_has_one_dataset():
    found = kt.statics.linear(kt.library.mechanisms.four_bar().with_(section=kt.Rod(diameter=0.01), material=STEEL))
    assert found.data is found.whole
