"""Optima of numbers alone: closed forms with their multipliers, any scale and order, published trusses by an own NumPy method,
contradictions, and searches that are stopped.
"""

from __future__ import annotations

import numpy as np
import pytest

from kinetruss.design.optimum.certificate import certificate
from kinetruss.design.optimum.contradictions import contradiction
from kinetruss.design.optimum.evaluations import Evaluations
from kinetruss.design.optimum.problem import Limit, Problem, Variable
from kinetruss.design.optimum.working_limits import optimum
from reference.trusses import ten_bars, twenty_five_bars


class Formula:
    """Objective f(p), limits g(p) with their Jacobians."""

    def __init__(self, f, g):
        self.f, self.g, self.asked = f, g, 0

    def values(self, p, rows):
        self.asked += 1
        found = self.g(p)[0]
        return self.f(p)[0], found if rows is None else found[rows]

    def gradients(self, p, rows):
        return self.f(p)[1], self.g(p)[1][rows]


def problem(function, lower, upper, start, count, scale="range"):
    ends = enumerate(zip(lower, upper, start, strict=True))
    variables = [Variable(name=f"x{k}", lower=a, upper=b, start=c, scale=scale) for k, (a, b, c) in ends]
    limits = [Limit(subject=f"g{k}", family="g", limit=1.0, size=1.0) for k in range(count)]
    return Problem(variables=variables, limits=limits, function=function)


def found(asked, start=None, method="slsqp"):
    start = asked.problem.start if start is None else start
    return optimum(asked, start, method, 500, 1e-10)


LENGTH, DENSITY, FORCE, STRESS = 2.0, 7850.0, 7e4, 1e8


def one_bar(scale="range"):
    """Least mass rho l A of a bar under F with F/A <= s: A = F/s, and dm/ds = -rho l F/s^2."""
    mass = lambda p: (DENSITY * LENGTH * p[0], np.array([DENSITY * LENGTH]))  # noqa: E731
    stress = lambda p: (np.array([FORCE / p[0] / STRESS - 1]), np.array([[-FORCE / p[0] ** 2 / STRESS]]))  # noqa: E731
    return problem(Formula(mass, stress), [1e-5], [1e-2], [5e-3], 1, scale)


@pytest.mark.parametrize("method", ["slsqp", "trust-constr", "highs", "mma"])
@pytest.mark.parametrize("scale", ["range", "log", "inverse"])
def test_a_bar_has_the_area_of_its_stress_and_the_price_of_its_limit(scale, method):
    if method == "mma":
        pytest.importorskip("nlopt")
    result = found(Evaluations(one_bar(scale)), method=method)
    assert result.p[0] == pytest.approx(FORCE / STRESS, rel=1e-6)
    (active,) = [one for one in result.certificate.active if one.row >= 0]
    # the limit is given as a share of the stress: dm/d(share) = rho l F/s
    assert active.multiplier == pytest.approx(DENSITY * LENGTH * FORCE / STRESS, rel=1e-5)
    assert result.certificate.first_order
    assert result.certificate.complementarity < 1e-6


def two_bars(order=(0, 1), factor=1.0, scale="range"):
    """Two bars in a row, of lengths 1 and 2, whose elongations together are limited: least x + 2 y with 1/x + 2/y <= 4, and
    x <= 0.6 of the one.
    """
    place, own = np.argsort(order), list(order)

    def f(p):
        x, y = p[place] / factor
        return x + 2 * y, (np.array([1.0, 2.0]) / factor)[own]

    def g(p):
        x, y = p[place] / factor
        slope = np.array([[-1 / x**2 / 4, -2 / y**2 / 4], [1.0, 0.0]]) / factor
        return np.array([(1 / x + 2 / y) / 4 - 1, x - 0.6]), slope[:, own]

    return problem(Formula(f, g), [0.1 * factor] * 2, [3.0 * factor] * 2, [2.0 * factor] * 2, 2, scale)


CASES = [((0, 1), 1, "range"), ((1, 0), 1, "range"), ((0, 1), 1e-4, "log"), ((1, 0), 1e5, "inverse")]


@pytest.mark.parametrize(("order", "factor", "scale"), CASES)
def test_scale_and_order_of_variables_change_nothing(order, factor, scale):
    """x = 0.6, y = 2/(4 - 1/x); multipliers by hand: m1 = 4 y^2 of the elongation, m2 = (y/x)^2 - 1."""
    result = found(Evaluations(two_bars(order, factor, scale)))
    x, y = 0.6, 2 / (4 - 1 / 0.6)
    assert (result.p / factor)[np.argsort(order)] == pytest.approx([x, y], rel=1e-5)
    prices = {one.row: one.multiplier for one in result.certificate.active}
    assert prices[0] == pytest.approx(4 * y**2, rel=1e-4)
    assert prices[1] == pytest.approx((y / x) ** 2 - 1, rel=1e-4)


def test_a_point_beside_the_optimum_has_no_certificate():
    """Also where all limits are kept, and where a limit is reached at which the objective still falls."""
    asked = Evaluations(two_bars())
    assert not certificate(asked, np.array([0.6, 1.5])).first_order
    along = np.array([0.4, 2 / (4 - 1 / 0.4)])  # on the first limit
    assert certificate(asked, along).feasible
    assert certificate(asked, along).residual > 0.1


class Trusses:
    """Stresses within 25 ksi, displacements within 2 in; of 25 bars also buckling (Schmit and Farshi 1974)."""

    def __init__(self, truss, stress, moved=None, push=None, dofs=None):
        self.truss, self.stress, self.moved, self.dofs = truss, stress, moved, dofs
        self.push = stress if push is None else push

    def rows(self, A):
        u, s, du, ds = self.truss.analysed(A)
        push = np.broadcast_to(self.push, s.shape).ravel()
        s, ds = s.ravel(), ds.reshape(-1, len(A))
        g, dg = [s / self.stress - 1, -s / push - 1], [ds / self.stress, -ds / push[:, None]]
        if self.moved is not None:
            k = slice(None) if self.dofs is None else self.dofs
            u, du = u[:, k].ravel(), du[:, k].reshape(-1, len(A))
            g, dg = [*g, u / self.moved - 1, -u / self.moved - 1], [*dg, du / self.moved, -du / self.moved]
        return np.concatenate(g), np.concatenate(dg)

    def problem(self, start, low, high):
        function = Formula(lambda A: (self.truss.weight(A), self.truss.weight_gradient()), self.rows)
        n = len(start)
        return problem(function, [low] * n, [high] * n, start, len(self.rows(start)[0]))


def arrived(trusses, low, high, best, seed=1, starts=30):
    """Searches from random starts that end at the published weight with a certificate, and their analyses."""
    rng, count, analyses = np.random.default_rng(seed), 0, []
    for _ in range(starts):
        asked = Evaluations(trusses.problem(rng.uniform(low, high, len(trusses.truss.groups)), low, high))
        result = found(asked)
        assert result.certificate.first_order
        weight = trusses.truss.weight(result.p)
        count += abs(weight / best - 1) < 1e-5
        analyses.append(asked.analyses)
    return count, float(np.median(analyses))


def test_ten_bars_reach_the_published_optima():
    """5060.85 lb with displacements, 1593.18 lb with stresses alone (Haftka and Gurdal 1992; Schmit and Farshi 1974)."""
    truss = ten_bars()
    count, analyses = arrived(Trusses(truss, 25.0, 2.0), 0.1, 40.0, 5060.8537)
    assert count >= 25
    assert analyses < 30
    count, analyses = arrived(Trusses(truss, 25.0), 0.1, 40.0, 1593.1805)
    assert count == 30


def test_twenty_five_bars_reach_the_published_optimum():
    """545.16 lb; bars of groups with their own limit of buckling (Schmit and Farshi 1974)."""
    truss = twenty_five_bars()
    push = truss.spread @ np.array([35.092, 11.590, 17.305, 35.092, 35.092, 6.759, 6.959, 11.082])
    top = [truss.dofs[node, axis] for node in "12" for axis in range(3)]
    count, analyses = arrived(Trusses(truss, 40.0, 0.35, push, top), 0.01, 3.4, 545.1628)
    assert count == 30
    assert analyses < 30


def test_multipliers_are_what_a_changed_limit_saves():
    """The optimum with 0.1 % more displacement is lighter by the multiplier (a difference of two optima)."""
    truss, start = ten_bars(), np.full(10, 20.0)
    by = {moved: found(Evaluations(Trusses(truss, 25.0, moved).problem(start, 0.1, 40.0))) for moved in (2.0, 2.002)}
    saved = truss.weight(by[2.0].p) - truss.weight(by[2.002].p)
    price = sum(one.multiplier for one in by[2.0].certificate.active if one.row >= 20)
    assert saved == pytest.approx(0.001 * price, rel=0.01)


def test_few_rows_of_very_many_are_worked_with():
    """sin(t) x + cos(t) y <= 1 at 50,000 instants: the unit circle, of which a handful of instants are differentiated."""
    t = np.linspace(0, 2 * np.pi, 50_000)
    along = np.stack([np.sin(t), np.cos(t)], axis=1)
    rows: list[int] = []
    function = Formula(lambda p: (-p.sum(), -np.ones(2)), lambda p: (along @ p - 1, along))
    watched = function.gradients

    def gradients(p, chosen):
        rows.append(len(chosen))
        return watched(p, chosen)

    function.gradients = gradients
    result = found(Evaluations(problem(function, [-2.0] * 2, [2.0] * 2, [-1.0, 0.5], len(t))))
    assert result.p == pytest.approx([np.sqrt(0.5)] * 2, abs=1e-4)  # of the unit circle
    assert result.certificate.first_order
    assert max(rows) < 200


def test_limits_that_exclude_each_other_are_named_alone():
    """x + y <= 1, x >= 0.8, y >= 0.5 cannot hold together; x - y <= 3 has no part in it."""
    A = np.array([[1.0, 1.0], [-1.0, 0.0], [0.0, -1.0], [1.0, -1.0]])
    b = np.array([1.0, -0.8, -0.5, 3.0])
    function = Formula(lambda p: (p.sum(), np.ones(2)), lambda p: (A @ p - b, A))
    asked = Evaluations(problem(function, [0.0] * 2, [5.0] * 2, [1.0, 1.0], 4))
    kept, _, worst = contradiction(asked, np.array([1.0, 1.0]), np.arange(4))
    assert sorted(kept) == [0, 1, 2]
    assert worst == pytest.approx(0.1, abs=1e-6)  # 1.3 - 1 shared by three
    kept, _, _ = contradiction(asked, np.array([1.0, 1.0]), np.array([0, 1, 3]))
    assert kept == []


def test_a_stopped_search_goes_on_to_the_last_bit(tmp_path):
    """Stopped at any analysis, with a last line cut off, it ends as if it had not been, and computes nothing twice."""
    truss, start = ten_bars(), np.full(10, 20.0)
    whole = Evaluations(Trusses(truss, 25.0, 2.0).problem(start, 0.1, 40.0))
    expected = found(whole).p
    for stop in (1, 7, 16):
        file = tmp_path / f"{stop}.jsonl"
        task = Trusses(truss, 25.0, 2.0).problem(start, 0.1, 40.0)

        def told(done, _objective, _worst, stop=stop):
            if done == stop:
                raise KeyboardInterrupt

        first = Evaluations(task, file, told)
        with pytest.raises(KeyboardInterrupt):
            found(first)
        with file.open("ab") as cut:
            cut.write(b'["v0123')
        again = Evaluations(task, file)
        assert np.array_equal(found(again).p, expected)
        assert again.computed + first.computed == whole.computed
