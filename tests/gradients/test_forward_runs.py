"""Gradients of forward runs: closed forms, differences of tight runs, order and invariant of the adjoint, refusals."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import ellipk

import kinetruss as kt
from kinetruss.gradients import run_point
from kinetruss.gradients.responses import read_response
from kinetruss.gradients.run_adjoint import Tangent, back_through, cells_of, gauss
from kinetruss.gradients.run_point import RunPoint
from kinetruss.gradients.varied import varied
from kinetruss.mechanics import compile

G = 9.81
TIGHT = kt.DOP853(rtol=1e-12, atol=1e-13)
BALL = kt.Model(nodes={"A": kt.Node(at=(0, 5), mass=2.0)}, velocities={"A": (3, 4)}, gravity=(0, -10))
GROUND = {"ground": kt.Event(coordinate="A.y", value=0.0, direction="falling")}
PENDULUM = kt.Model(
    nodes={"O": (0, 0), "A": kt.Node(at=(1.0, 0), mass=1.0)}, fixed=["O"], bars={"rod": ("O", "A")}, gravity=(0, -G)
)
DOUBLE = kt.Model(
    nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1.0), "B": kt.Node(at=(2, 0), mass=0.7)},
    fixed=["O"],
    bars={"a": ("O", "A"), "b": kt.Bar(ends=("A", "B"), mass=0.3)},
    gravity=(0, -G),
)
CRANK = kt.Model(
    nodes={"O": (0, 0), "A": kt.Node(at=(0.5, 0), mass=2.0), "B": kt.Node(at=(0.5, -0.8), mass=1.0)},
    fixed=["O"],
    bars={"crank": kt.Bar(ends=("O", "A"), mass=0.3), "rod": kt.Bar(ends=("A", "B"), mass=0.2)},
    drives={"motor": kt.AngleDrive("crank")},
    gravity=(0, -G),
    trajectories={"turn": kt.Quintic(moves={"motor": (0.0, 1.3)}, duration=0.8)},
)


def of(text: str, model: kt.Model, **arguments: object) -> kt.Response:
    return kt.Response(text, kt.dynamics.simulate, model, **arguments)


def slopes(text: str, model: kt.Model, wrt: list[str], **arguments: object) -> np.ndarray:
    return kt.gradient(of(text, model, **arguments), wrt).values


def close(found: np.ndarray, exact: object, error: float) -> None:
    assert np.abs(found - exact).max() <= error * np.abs(exact).max(), (found, exact)


# Closed forms.


def test_projectile():
    t = 0.7
    wrt = ["velocities.A.0", "velocities.A.1", "nodes.A.at.0", "nodes.A.at.1", "gravity.1", "nodes.A.mass"]
    close(slopes("final(position[A, x])", BALL, wrt, t_end=t), [t, 0, 1, 0, 0, 0], 1e-10)
    close(slopes("final(position[A, y])", BALL, wrt, t_end=t), [0, t, 0, 1, t**2 / 2, 0], 1e-10)


def test_time_of_an_event_and_values_at_the_end_that_it_makes():
    v, h, g = 4.0, 5.0, 10.0
    w = np.sqrt(v**2 + 2 * g * h)
    t = (v + w) / g
    run = {"t_end": 5.0, "samples": 7, "events": GROUND}
    wrt = ["nodes.A.at.1", "velocities.A.0", "velocities.A.1"]
    close(slopes("event_time[ground]", BALL, wrt, **run), [1 / w, 0, (1 + v / w) / g], 1e-10)
    close(slopes("final(position[A, x])", BALL, wrt, **run), [3 / w, t, 3 * (1 + v / w) / g], 1e-10)
    close(slopes("final(velocity[A, y])", BALL, wrt, **run), [-g / w, 0, -v / w], 1e-10)
    # the end of the run moves, so a mean over it is not the sum of what moves at fixed times
    with pytest.raises(kt.AnalysisError, match="mean over time"):
        slopes("rms(velocity[A, y])", BALL, wrt, **run)


def test_period_of_a_pendulum_by_its_length():
    """A quarter from the horizontal is sqrt(L/g) K(1/2), with the parameter m = 1/2 of the integral."""
    quarter = np.sqrt(1.0 / G) * ellipk(0.5)
    low = {"low": kt.Event(coordinate="A.x", value=0.0, stop=False)}
    run = {"t_end": 2.0, "samples": 11, "events": low, "method": kt.Taylor(rtol=1e-13, atol=1e-14)}
    for k, name in ((1, "low"), (3, "low_2")):
        found = slopes(f"event_time[{name}]", PENDULUM, ["nodes.A.at.0", "gravity.1", "nodes.A.mass"], **run)
        close(found, [k * quarter / 2, k * quarter / (2 * G), 0.0], 1e-10)


@pytest.mark.parametrize(
    "method", [kt.Taylor(rtol=1e-12, atol=1e-13), TIGHT, kt.Radau(rtol=1e-11, atol=1e-12)], ids=lambda m: m.kind
)
def test_oscillator(method: object):
    """x = x0 e^(-d t) (cos w t + d/w sin w t), d = c/2m, w^2 = k/m - d^2."""
    m, k, c, x0, t = 2.0, 50.0, 1.5, 0.2, 1.3
    model = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(1.0 + x0, 0), mass=m)},
        fixed={"O": "xy", "A": "y"},
        bars={"s": kt.Bar(ends=("O", "A"), kind="elastic", stiffness=k, natural_length=1.0, damping=c, mass=0.0)},
    )

    def x(m: complex, k: complex, c: complex, x0: complex) -> complex:
        d = c / (2 * m)
        w = np.sqrt(k / m - d**2)
        return x0 * np.exp(-d * t) * (np.cos(w * t) + d / w * np.sin(w * t))

    exact = [x(*(value + 1e-30j * (i == j) for j, value in enumerate((m, k, c, x0)))).imag / 1e-30 for i in range(4)]
    wrt = ["nodes.A.mass", "bars.s.stiffness", "bars.s.damping", "nodes.A.at.0"]
    close(slopes("final(position[A, x])", model, wrt, t_end=t, method=method), exact, 2e-8 if method.kind == "radau" else 1e-9)


# Differences of tight runs.


@pytest.mark.parametrize(
    "text",
    ["final(position[B, x])", "final(acceleration[A, y])", "max(abs(member_force[a]))", "rms(reaction[O, x])",
     "final(kinetic_energy)"],
)  # fmt: skip
def test_double_pendulum_beside_differences(text: str):
    wrt = ["nodes.A.mass", "nodes.B.mass", "bars.b.mass", "nodes.A.at.0", "nodes.O.at.0", "gravity.1"]
    for method in (kt.Taylor(rtol=1e-12, atol=1e-13), TIGHT):
        assert kt.check_gradient(of(text, DOUBLE, t_end=2.0, samples=21, method=method), wrt).error < 1e-7


def test_closed_four_bar_by_its_lengths_and_by_places_that_its_start_is_moved_from():
    size = {"crank": np.hypot(0.3, 0.6), "coupler": np.hypot(1.3, 0.3), "rocker": np.hypot(0.2, 0.9)}
    ends = {"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")}
    four = kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0.3, 0.6), mass=1), "C": kt.Node(at=(1.6, 0.9), mass=1.5), "D": (1.4, 0)},
        fixed=["A", "D"],
        bars={name: kt.Bar(ends=ends[name], length=size[name], mass=0.5) for name in ends},
        gravity=(0, -G),
    )
    wrt = [f"bars.{name}.length" for name in ends] + ["nodes.B.at.0", "bars.coupler.mass", "nodes.D.at.0"]
    for text in ("final(position[C, x])", "max(abs(member_force[coupler]))", "final(energy)"):
        assert kt.check_gradient(of(text, four, t_end=1.0, samples=41, method=TIGHT), wrt).error < 1e-7


def test_what_a_motion_and_loads_say():
    wrt = ["nodes.B.mass", "nodes.A.at.0", "trajectories.turn.duration", "trajectories.turn.moves.motor.1"]
    run = {"t_end": 1.5, "samples": 34, "trajectory": "turn", "method": TIGHT}
    for text in ("final(position[B, x])", "max(abs(drive_force[motor]))", "rms(member_force[rod])"):
        assert kt.check_gradient(of(text, CRANK, **run), wrt).error < 1e-7
    # a sample at the end of the motion is on one side of it or the other
    with pytest.raises(kt.AnalysisError, match=r"t = 0\.8 s, where a motion ends"):
        slopes("rms(member_force[rod])", CRANK, wrt, **(run | {"samples": 31}))
    loaded = CRANK.with_(
        drives={}, trajectories={},
        loads={"p": kt.NodalForce(node="B", force=(2.0, 1.0)),
               "q": kt.NodalForce(node="A", times=(0, 0.3, 0.5, 1), forces=((0, 0), (1, 0), (1, 0), (-1, 0)))},
    )  # fmt: skip
    found = kt.check_gradient(
        of("final(position[B, x])", loaded, t_end=0.9, method=TIGHT), ["loads.p.force.0", "loads.q.forces.1.0"]
    )
    assert found.error < 1e-8
    assert np.abs(found.gradient).min() > 0.01


def test_many_responses_share_the_work_and_agree():
    texts = ["final(position[B, x])", "final(velocity[B, y])", "max(abs(member_force[b]))"]
    responses = [of(text, DOUBLE, t_end=1.0, samples=11) for text in texts]
    values, found = kt.value_and_gradient(responses, ["nodes.B.mass", "nodes.B.at.0"])
    for k, one in enumerate(responses):
        assert values[k] == one.value
        close(found.values[k], kt.gradient(one, ["nodes.B.mass", "nodes.B.at.0"]).values, 1e-9)


def test_energy_that_is_kept_has_the_gradient_of_the_start():
    """T + V is what it is at the start, -m g y of the nodes: its gradient at the end owes nothing to the motion."""
    wrt = ["nodes.A.at.1", "nodes.B.at.1", "nodes.A.mass"]
    close(slopes("final(energy)", DOUBLE, wrt, t_end=5.0, method=TIGHT), [(1.0 + 0.15) * G, (0.7 + 0.15) * G, 0.0], 1e-8)


# The adjoint.


def _errors(h: np.ndarray, stages: int) -> list[float]:
    """Errors of the transposed collocation of x'' = -(1 + t) x over one second, by the length of cells."""
    found = []
    for size in h:
        count = round(1.0 / size)
        c = gauss(stages).c
        t = (np.arange(count)[:, None] * size + size * c).reshape(-1)
        at = Tangent(rx=-(1.0 + t)[:, None, None], rv=np.zeros((len(t), 1, 1)), M=np.eye(1), J=np.zeros((len(t), 0, 1)))
        both = [
            back_through(at, np.full(count, size), stages, np.array([[1.0, 0.0]]), np.zeros((count, 1, 2)), stiff)[1][0, 0]
            for stiff in (False, True)
        ]
        assert np.abs(both[0] - both[1]).max() < 1e-12  # iterated stages, and matrices of cells
        found.append(both[0])
    from scipy.integrate import solve_ivp

    exact = [
        solve_ivp(lambda t, y: [y[1], -(1.0 + t) * y[0]], (0, 1), start, rtol=1e-13, atol=1e-14).y[0, -1]
        for start in ([1.0, 0.0], [0.0, 1.0])
    ]
    return [float(np.abs(one - exact).max()) for one in found]


@pytest.mark.parametrize("stages", [1, 2, 3])
def test_order_of_the_adjoint(stages: int):
    coarse, fine = _errors(np.array([0.2, 0.1]), stages)
    assert np.log2(coarse / fine) == pytest.approx(2 * stages, abs=0.25)


def test_the_transpose_of_a_cell_is_exact():
    """l1 . y1 = l0 . y0 for the collocation itself, of random derivatives: y1 from its stages, l0 from `cells_of`."""
    rng, f, s, h = np.random.default_rng(3), 3, 4, 0.3
    rx, rv = rng.normal(size=(2, s, f, f))
    at = Tangent(rx, rv, np.eye(f), np.zeros((s, 0, f)))
    scheme, (y0, l1) = gauss(s), rng.normal(size=(2, 2 * f))
    A = np.zeros((s, 2 * f, 2 * f))
    A[:, :f, f:], A[:, f:, :f], A[:, f:, f:] = np.eye(f), rx, rv
    whole = np.eye(2 * f * s) - h * np.einsum("ij,iab->iajb", scheme.A, A).reshape(2 * f * s, -1)
    k = np.linalg.solve(whole, np.concatenate([one @ y0 for one in A])).reshape(s, 2 * f)
    y1 = y0 + h * scheme.b @ k
    assert l1 @ y1 == pytest.approx(cells_of(at, np.array([h]), f, scheme).back[0] @ l1 @ y0, rel=1e-12)


def test_the_measured_error_follows_the_length_of_cells(monkeypatch: pytest.MonkeyPatch):
    """Cells far too long for the motion are told by l^T (v, a), which is to stay as it is."""
    by, point = varied(DOUBLE, ["nodes.B.mass"]), RunPoint(compile(DOUBLE), 4.0, samples=5, method=kt.DOP853())
    seeds = read_response("final(position[B, x])", point.data()).seeds
    errors = []
    for share in (2.0, 12.0):
        monkeypatch.setitem(run_point.SHARE, "DOP853", share)
        read = point._reading([seeds])
        point._anew = np.zeros(1, bool)
        errors.append(point._swept(by, read)[2])
    assert errors[0] < 3e-10
    assert errors[1] > 1e4 * errors[0]
    # and shorter ones are then taken
    assert kt.check_gradient(of("final(position[B, x])", DOUBLE, t_end=4.0, method=TIGHT), ["nodes.B.mass"]).error < 1e-7


@pytest.mark.slow
def test_ten_thousand_steps():
    """Time scales with the root of gravity where lengths stay: g dx/dg = t v/2, after 300 s of swings."""
    model, t = PENDULUM.with_(nodes={"O": (0, 0), "A": kt.Node(at=(0.6, -0.8), mass=1.0)}), 300.0
    run = {"t_end": t, "samples": 3, "method": kt.DOP853(rtol=1e-13, atol=1e-14)}
    there = kt.dynamics.simulate(model, **run)
    assert there.data.steps.values[-1] > 1e4
    v = there.motion.velocity.sel(node="A", axis="x").values[-1]
    close(slopes("final(position[A, x])", model, ["gravity.1"], **run) * -G, [t * v / 2], 1e-7)


# What has no gradient.


def test_refusals():
    wrt = ["nodes.A.mass"]
    for options, words in (
        ({"method": kt.EnergyMomentum(step=0.01)}, "EnergyMomentum has steps"),
        ({"user_force": lambda t, x, v: {}}, "user's force has no derivatives"),
    ):
        with pytest.raises(kt.InputError, match=words):
            slopes("final(position[B, x])", DOUBLE, wrt, t_end=0.1, **options)
    with pytest.raises(kt.AnalysisError, match="start jumps with nodes.A.at.1"):
        slopes(
            "final(position[B, x])",
            CRANK.with_(drives={}, trajectories={}),
            ["nodes.A.at.1"],
            t_end=0.1,
            velocities={"A": (0, 1.0)},
        )
    drop = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(0, 1.0), mass=2.0)}, fixed={"O": "xy", "A": "x"}, gravity=(0, -10),
        bars={"g": kt.Bar(ends=("O", "A"), kind="free")},
        stops={"s": kt.Stop(coordinate=kt.LengthDrive("g"), lower=0.5, stiffness=5e4)},
    )  # fmt: skip
    fall = {"t_end": 0.4, "samples": 41, "method": TIGHT}
    with pytest.raises(kt.AnalysisError, match=r"beyond t = 0\.316228 s: there s\.lower is met"):
        slopes("final(position[A, y])", drop, ["nodes.A.at.1"], **fall)
    close(slopes("at(position[A, y], 0.3)", drop, ["nodes.A.at.1"], **fall), [1.0], 1e-9)
    cable = drop.with_(stops={}, nodes={"O": (0, 0), "A": kt.Node(at=(0, -0.8), mass=2.0)},
                       bars={"g": kt.Bar(ends=("O", "A"), kind="cable", stiffness=2000.0, natural_length=1.0)})  # fmt: skip
    with pytest.raises(kt.AnalysisError, match="a force that jumps or bends"):
        slopes("final(position[A, y])", cable, ["nodes.A.at.1"], **fall)


def test_redundant_rows_have_motions_but_no_unique_forces():
    """Of three bars along one line, one is too many for the motion."""
    nodes = {"A": (0, 0), "B": (1, 0), "C": (2, 0)} | {n: kt.Node(at=(k + 0.6, -0.8), mass=1.0) for k, n in enumerate("PQR")}
    bars = {"a": ("A", "P"), "b": ("B", "Q"), "c": ("C", "R"), "d": ("P", "Q"), "e": ("Q", "R"), "f": ("P", "R")}
    model = kt.Model(nodes=nodes, fixed=["A", "B", "C"], bars=bars, gravity=(0, -G))
    found = kt.check_gradient(of("final(position[R, x])", model, t_end=0.5, method=TIGHT), ["nodes.P.mass", "gravity.1"])
    assert found.error < 1e-8
    with pytest.raises(kt.AnalysisError, match="not unique"):
        slopes("final(member_force[d])", model, ["nodes.P.mass"], t_end=0.5, method=TIGHT)
