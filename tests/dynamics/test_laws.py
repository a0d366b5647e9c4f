"""Laws of bars: what they pull, what they store, what they take, in inverse dynamics and in the stiffness method."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

import kinetruss as kt
from kinetruss.kernels.structure.laws import law_values
from kinetruss.mechanics import CABLE, ENGINEERING, GREEN, NONE, compile

K, L0, C = 250.0, 0.8, 7.0
LAWS = [ENGINEERING, GREEN, CABLE]
KINDS = {
    "engineering": {"kind": "elastic"}, "green": {"kind": "elastic", "strain": "green"}, "cable": {"kind": "cable"},
}  # fmt: skip


def values(law, L, Ld=0.0, k=K, l0=L0, c=C):
    out = np.empty((4, 1, 1))
    law_values(np.array([law], np.int8), *(np.array([v]) for v in (k, l0, c)), np.array([[L]]), np.array([[Ld]]), out)
    return out[:, 0, 0]


def pull(law, L, Ld=0.0, **more):
    return values(law, L, Ld, **more)[0]


def slope(law, L, **more):
    return values(law, L, c=0.0, **more)[1]


@pytest.mark.slow
@given(st.floats(0.1, 2.0), st.floats(-3.0, 3.0))
def test_closed_forms(L, Ld):
    engineering = K * (L - L0) + C * Ld
    assert pull(NONE, L, Ld) == 0
    assert pull(ENGINEERING, L, Ld) == pytest.approx(engineering, rel=1e-13, abs=1e-12)
    assert pull(GREEN, L, Ld) == pytest.approx(K * (L**2 - L0**2) / (2 * L0) * L / L0 + C * Ld, rel=1e-13, abs=1e-12)
    assert pull(CABLE, L, Ld) == pytest.approx(max(0.0, engineering) if L > L0 else 0.0, rel=1e-13, abs=1e-12)


def test_a_taut_cable_that_shortens_fast_does_not_push():
    assert K * 0.01 < C * 2.0
    assert pull(CABLE, L0 + 0.01, -2.0) == 0.0
    assert pull(ENGINEERING, L0 + 0.01, -2.0) == pytest.approx(K * 0.01 - C * 2.0, rel=1e-12)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("L", [0.5, 0.79, 0.81, 1.3])
def test_energy_is_what_the_tension_stores(law, L):
    points, weights = np.polynomial.legendre.leggauss(8)
    first, last = (max(L0, L), L0) if law == CABLE else (L, L0)
    middle, half = (first + last) / 2, (first - last) / 2
    work = half * sum(w * pull(law, middle + half * p) for p, w in zip(points, weights, strict=True))
    assert values(law, L)[3] == pytest.approx(work, rel=1e-13, abs=1e-13)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("L", [0.5, 0.79, 0.81, 1.3])
def test_slope_by_the_rate_is_the_damping(law, L):
    taken = (pull(law, L, 0.5) - pull(law, L, 0.3)) / 0.2
    assert values(law, L, 0.4)[2] == pytest.approx(taken, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("L", [0.5, 0.79, 0.81, 1.3])
def test_slope(law, L):
    h = 1e-5
    assert slope(law, L) == pytest.approx((pull(law, L + h) - pull(law, L - h)) / (2 * h), rel=1e-8, abs=1e-8)


def spring(law="engineering", motion=None, **changes):
    """A spring and a mass on a line; the drive moves the mass."""
    bar = kt.Bar(ends=("A", "B"), **{"stiffness": K, "natural_length": L0, "damping": C} | KINDS[law] | changes)
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(1, 0), mass=2.0)},
        fixed={"A": "xy", "B": "y"},
        bars={"s": bar},
        drives={"push": kt.CoordinateDrive(node="B", axis="x")},
        trajectories={"t": kt.Sine(amplitudes={"push": 0.4}, period=1.0, duration=1.0)},
    )


def run(model):
    motion = kt.kinematics.follow(model, model.trajectories["t"], samples=41)
    return motion, kt.dynamics.inverse(model, motion)


@pytest.mark.slow
@pytest.mark.parametrize("law", KINDS)
def test_inverse_dynamics(law):
    motion, forces = run(spring(law))
    code = {"engineering": ENGINEERING, "green": GREEN, "cable": CABLE}[law]
    L, Ld, Ldd = (motion.data[name].values[:, 0] for name in ("length", "length_rate", "length_acceleration"))
    N = np.array([pull(code, l, ld) for l, ld in zip(L, Ld, strict=True)])
    assert np.abs(forces.data["member_force"].values[:, 0] - N).max() < 1e-12 * np.abs(N).max()
    assert np.abs(forces.static.data["member_force"].values[:, 0] - [pull(code, l) for l in L]).max() < 1e-12 * np.abs(N).max()
    assert np.abs(forces.data["drive_force"].values[:, 0] - (2.0 * Ldd + N)).max() < 1e-12 * np.abs(N).max()
    still = np.array([pull(code, l) for l in L])
    assert np.abs(forces.data["dissipation"].values - (N - still) * Ld).max() < 1e-12 * np.abs(N).max()


@pytest.mark.slow
@pytest.mark.parametrize("law", KINDS)
def test_energy_balance_and_virtual_work(law):
    """Power of the drive = rate of energy + dissipation, and the energy is the integral of the undamped tension."""
    model = spring(law)
    motion = kt.kinematics.follow(model, model.trajectories["t"], samples=4001)
    forces = kt.dynamics.inverse(model, motion, static=False)
    assert float(abs(forces.data["energy_balance"]).max()) < 1e-12 * float(abs(forces.data["power"]).max())
    assert float(forces.data["dissipation"].min()) >= 0 or law == "cable"
    speed = motion.data["velocity"].sel(node="B", axis="x").values
    strain_energy = forces.data["energy"].values - 0.5 * 2.0 * speed**2
    L = motion.data["length"].values[:, 0]
    code = {"engineering": ENGINEERING, "green": GREEN, "cable": CABLE}[law]
    N = np.array([pull(code, l) for l in L])
    work = np.concatenate([[0], np.cumsum(0.5 * (N[1:] + N[:-1]) * np.diff(L))])
    miss = strain_energy - strain_energy[0] - work
    assert np.abs(miss).max() < 1e-6 * np.abs(strain_energy).max()


def test_undamped_has_no_dissipation():
    _, forces = run(spring(damping=0.0))
    assert "dissipation" not in forces.data


def test_damped_free_bar():
    model = spring(kind="free", stiffness=None, natural_length=None)
    motion, forces = run(model)
    Ld = motion.data["length_rate"].values[:, 0]
    assert np.abs(forces.data["member_force"].values[:, 0] - C * Ld).max() < 1e-12
    assert float(abs(forces.static.data["member_force"]).max()) == 0
    assert float(abs(forces.data["energy_balance"]).max()) < 1e-12 * float(abs(forces.data["power"]).max())


@pytest.mark.slow
@pytest.mark.parametrize("law", KINDS)
def test_newton_and_euler_know_the_law(law):
    model = spring(law, mass=0.7)
    motion, forces = run(model)
    for time in (0.1, 0.35, 0.8):
        system = kt.dynamics.newton_euler(model, motion, forces, time=time)
        assert system.unique
        assert system.difference < 1e-11 * system.largest
    still = kt.dynamics.newton_euler(model, motion, forces.static, time=0.35)
    assert still.difference < 1e-11 * still.largest


@pytest.mark.slow
@pytest.mark.parametrize(
    ("law", "given_", "pretension"),
    [
        (law, given_, N0)
        for law in KINDS
        for given_ in ("stiffness", "section")
        for N0 in (0.0, 30.0, -20.0)
        if law != "cable" or N0 >= 0
    ],
)
def test_pretension_is_the_force_at_the_start(law, given_, pretension):
    if given_ == "stiffness":
        changes = {"stiffness": K}
    else:
        changes = {"stiffness": None, "section": kt.General(area=1e-6, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01),
                   "material": kt.Material(E=250e6, density=0.0)}  # fmt: skip
    model = spring(law, natural_length=None, pretension=pretension, damping=0.0, **changes)
    _, forces = run(model)
    assert forces.data["member_force"].values[0, 0] == pytest.approx(pretension, rel=1e-13, abs=1e-12)
    system = compile(model)
    if given_ == "section":
        assert system.spring[0] * system.natural[0] == pytest.approx(250.0, rel=1e-15)


@pytest.mark.slow
@pytest.mark.parametrize("law", KINDS)
def test_stiffness_method_has_the_slope_of_the_law(law):
    """A small load moves a stretched spring by load over slope, on top of what the prestress does."""
    model = spring(law, natural_length=0.9).with_(drives={}, trajectories={})
    found = [
        kt.statics.linear(model.with_(loads={"f": kt.NodalForce(node="B", force=(f, 0.0))})).displacement.sel(
            node="B", axis="x"
        )
        for f in (0.0, 1e-3)
    ]
    code = {"engineering": ENGINEERING, "green": GREEN, "cable": CABLE}[law]
    moved = float(found[1].values - found[0].values)
    assert moved == pytest.approx(1e-3 / slope(code, 1.0, l0=0.9), rel=1e-9)


def hung(**cable):
    """A mass between two elastic bars, held by a cable as well."""
    spring_ = {"kind": "elastic", "stiffness": K}
    return kt.Model(
        nodes={"A": (-1, 0), "B": (1, 0), "P": (0, -1), "G": (0, -2)},
        fixed=["A", "B", "G"],
        bars={
            "left": kt.Bar(ends=("A", "P"), **spring_),
            "right": kt.Bar(ends=("B", "P"), **spring_),
            "tie": kt.Bar(ends=("P", "G"), kind="cable", stiffness=K, **cable),
        },
        loads={"w": kt.NodalForce(node="P", force=(0, 0.1))},
    )


def test_slack_cable_carries_nothing():
    slack, tight = (kt.statics.linear(hung(natural_length=l)) for l in (1.5, 0.999))
    without = kt.statics.linear(hung().with_(bars={name: bar for name, bar in hung().bars.items() if name != "tie"}))
    assert float(slack.member_force.sel(member="tie")) == 0
    largest = float(abs(without.displacement).max())
    assert np.allclose(slack.displacement, without.displacement, rtol=0, atol=1e-13 * largest)
    assert float(slack.elongation.sel(member="tie")) == pytest.approx(float(slack.displacement.sel(node="P", axis="y")))
    assert float(tight.member_force.sel(member="tie")) > 0
    assert np.isfinite(slack.data["energy"])


def test_a_structure_that_only_a_slack_cable_holds_is_a_mechanism():
    model = hung(natural_length=1.5)
    with pytest.raises(kt.InputError, match="mechanism"):
        kt.statics.linear(model.with_(bars={name: bar for name, bar in model.bars.items() if name != "left"}))


@pytest.mark.slow
def test_deflection_under_the_forces_of_a_motion():
    model = spring("green", natural_length=0.9, damping=0.0)
    _, forces = run(model)
    moved = kt.statics.deflection(model.with_(drives=model.drives), forces)
    assert np.isfinite(moved.data["displacement"]).all()
