"""A motion is taken by the model that it is of, and by models that differ in nothing that fixes geometry; by no other."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt

STEEL = kt.library.materials.STEEL_S235


def four_bar(**changes):
    fields = {
        "nodes": {"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)}, "fixed": ("A", "D"), "gravity": (0, -9.81),
        "section": kt.Rectangle(width=0.02, height=0.02), "material": STEEL,
        "bars": {"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")}, "drives": {"motor": kt.AngleDrive("crank")},
    }  # fmt: skip
    return kt.Model(**fields | changes)


SWING = kt.Quintic(moves={"motor": ("90 deg", "100 deg")}, duration=1)
MOTION = kt.kinematics.follow(four_bar(), SWING, samples=5)
FORCES = kt.dynamics.inverse(four_bar(), MOTION)

USES = {
    "inverse": lambda model: kt.dynamics.inverse(model, MOTION),
    "strength": lambda model: kt.strength.check(model, FORCES),
    "sections": lambda model: kt.strength.sections(model, FORCES),
    "pose": lambda model: kt.kinematics.pose(model, MOTION, ("B", "C")),
    "platform": lambda model: kt.kinematics.platform(model, MOTION, ("B", "C")),
    "joint": lambda model: kt.kinematics.joint(model, MOTION, ("A", "B"), ("B", "C")),
    "member_rates": lambda model: kt.kinematics.member_rates(model, MOTION),
    "jacobian": lambda model: kt.kinematics.jacobian(model, MOTION, of="C"),
    "conditioning": lambda model: kt.kinematics.conditioning(model, MOTION),
    "first_order": lambda model: kt.kinematics.first_order(model, MOTION),
    "deflection": lambda model: kt.statics.deflection(model, FORCES),
    "free_body": lambda model: kt.dynamics.free_body(model, MOTION, FORCES, member="crank", time=0.0),
    "linearise": lambda model: kt.dynamics.linearise(model, MOTION, time=0.0, free=["motor"]),
    "evaluate": lambda model: kt.actuators.evaluate(model, MOTION, FORCES),
}


@pytest.mark.slow
@pytest.mark.parametrize("use", USES)
def test_another_crank_is_refused(use):
    moved = dict(four_bar().nodes) | {"B": kt.Node(at=(0, 0.2))}
    with pytest.raises(kt.InputError, match="not of this model: 'crank' is .*0.2 m long"):
        USES[use](four_bar(nodes=moved))


@pytest.mark.slow
@pytest.mark.parametrize("use", [name for name in USES if name not in ("evaluate",)])
def test_another_place_or_drive_is_refused(use):
    shifted = {name: tuple(np.array(node.at) + np.array([0.05, 0])) for name, node in four_bar().nodes.items()}
    with pytest.raises(kt.InputError, match=r"not of this model: [AD]\.x is fixed at"):
        USES[use](four_bar(nodes=shifted))
    with pytest.raises(kt.InputError, match="not of this model: drive 'motor' stands at"):
        USES[use](four_bar(drives={"motor": kt.AngleDrive("rocker")}))


@pytest.mark.slow
@pytest.mark.parametrize("use", USES)
def test_what_fixes_no_geometry_may_change(use):
    nodes = dict(four_bar().nodes) | {"C": kt.Node(at=(0.30, 0.25), mass=2.0)}
    for changes in ({"nodes": nodes}, {"gravity": (1, 0)}, {"section": kt.Rod(diameter=0.03)}, {"title": "another"}):
        USES[use](four_bar(**changes))


@pytest.mark.slow
@settings(max_examples=30, deadline=None)
@given(st.sampled_from(["crank", "coupler", "rocker"]), st.floats(1e-5, 0.2), st.booleans())
def test_any_rigid_length_that_differs_is_refused(bar, share, longer):
    length = float(MOTION.length.sel(member=bar)[0]) * (1 + (share if longer else -share))
    ends = {"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")}
    with pytest.raises(kt.InputError, match=f"not of this model: {bar!r}"):
        kt.dynamics.inverse(four_bar(bars=ends | {bar: kt.Bar(ends=ends[bar], length=length)}), MOTION)


def test_a_coupling_that_is_not_kept():
    nodes = {"A": (0, 0), "B": (0.1, 0), "C": (0.3, 0), "D": (0.3, 0.2)}
    wheels = {"one": ("A", "B"), "two": ("C", "D")}

    def geared(ratio):
        terms = ((kt.AngleDrive("one"), 1.0), (kt.AngleDrive("two"), ratio))
        return kt.Model(
            nodes=nodes, fixed=["A", "C"], bars={name: kt.Bar(ends=ends, mass=1) for name, ends in wheels.items()},
            drives={"motor": kt.AngleDrive("one")}, couplings={"gear": kt.Coupling(terms=terms)},
        )  # fmt: skip

    motion = kt.kinematics.follow(geared(2.0), kt.ConstantRate(rates={"motor": 1.0}, duration=20), samples=41)
    kt.dynamics.inverse(geared(2.0), motion)  # over full turns
    with pytest.raises(kt.InputError, match="coupling 'gear' is off by"):
        kt.dynamics.inverse(geared(3.0), motion)


@pytest.mark.slow
@settings(max_examples=10, deadline=None)
@given(st.floats(1e-5, 5e-3), st.integers(0, 2**32 - 1))
def test_a_measured_motion_may_be_off_by_as_much_as_it_was(noise, seed):
    rng = np.random.default_rng(seed)
    position = MOTION.position.values + noise * rng.standard_normal(MOTION.position.shape)
    time = MOTION.position.time.values
    measured = kt.kinematics.from_arrays(four_bar(), time, position, MOTION.velocity.values, MOTION.acceleration.values)
    assert "Rigid bars change" in measured.message and "does not keep to the model" in measured.message
    kt.dynamics.inverse(four_bar(), measured)
    kt.dynamics.inverse(four_bar(gravity=(0, 0)), measured)
    moved = dict(four_bar().nodes) | {"B": kt.Node(at=(0, 0.2))}
    with pytest.raises(kt.InputError, match="not of this model"):
        kt.dynamics.inverse(four_bar(nodes=moved), measured)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["taylor", "dop853", "energy"])
def test_simulated_motions_are_the_models_own(method):
    methods = {"taylor": None, "dop853": kt.DOP853(), "energy": kt.EnergyMomentum(step=1e-3)}
    options = {} if methods[method] is None else {"method": methods[method]}
    run = kt.dynamics.simulate(four_bar(), 0.5, samples=11, tasks={"motor": kt.Free()}, **options)
    kt.dynamics.inverse(four_bar(), run.motion)


def test_forces_along_another_motion_give_no_demand():
    bay = kt.library.vgt.double_octahedral()
    one, two = (kt.kinematics.follow(bay, kt.library.vgt.slew(beta=(0, b)), samples=3) for b in (0.1, 0.2))
    with pytest.raises(kt.InputError, match="along another motion"):
        kt.actuators.evaluate(bay, two, kt.dynamics.inverse(bay, one))
    with pytest.raises(kt.InputError, match="other instants"):
        kt.actuators.evaluate(four_bar(), kt.kinematics.follow(four_bar(), SWING, samples=6), FORCES)
