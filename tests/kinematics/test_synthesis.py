"""Linkages for positions and paths: those of known linkages are found again; whatever is returned passes; limits are told."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.kinematics.synthesis import along, through
from kinetruss.kinematics.synthesis.chains import of
from kinetruss.kinematics.synthesis.dyads import centre_curve, five, on_lines, points_for
from kinetruss.kinematics.synthesis.paths import _Fit

KNOWN = of(A=0.0, D=4.0, a=1.0, h=3.5, r=2.5, side=1.0, p=1.5 + 1.2j)
"""A crank-rocker."""

SLIDING = of(A=0.0, D=0.4j, a=1.0, h=2.5, r=0.0, side=1.0, p=1.0 + 0.8j, along=np.exp(0.3j))
"""A slider-crank with an offset, on a slope."""


def taken(chains, angles):
    """Positions (n, 3) of the coupler of a linkage, as `through` takes them."""
    _, turn, P = chains.moved(np.array([angles], dtype=float))
    return np.column_stack([P[0].real, P[0].imag, np.angle(turn[0])])


def split(positions):
    """Places and directions as complex numbers."""
    return positions[:, 0] + 1j * positions[:, 1], np.exp(1j * positions[:, 2])


def lengths(linkage):
    """Fixed pivots and lengths of a four-bar's model."""
    at = {name: complex(*linkage.model.nodes[name].at) for name in "ABCDP"}
    return np.array(
        [at["A"], at["D"], abs(at["B"] - at["A"]), abs(at["C"] - at["B"]), abs(at["C"] - at["D"]), abs(at["P"] - at["B"])]
    )


def passed(linkage, positions):
    """Largest error of place (m) and angle (rad) of the model, when its crank is driven from position to position."""
    model, angles = linkage.model, linkage.angles
    rate = np.sign(angles[-1] - angles[0])
    drive = kt.ConstantRate(rates={"motor": float(rate)}, duration=float(abs(angles[-1] - angles[0])))
    motion = kt.kinematics.follow(model, drive, times=abs(angles - angles[0]))
    B, C, P = np.moveaxis(motion.position.sel(node=["B", "C", "P"]).values, 1, 0)
    way = C - B
    turned = np.unwrap(np.arctan2(way[:, 1], way[:, 0])) - np.arctan2(way[0, 1], way[0, 0])
    asked = positions[:, 2] - positions[0, 2]
    return np.abs(P - positions[:, :2]).max(), np.abs(np.exp(1j * turned) - np.exp(1j * asked)).max()


def test_five_positions_have_the_dyads_of_the_linkage_they_were_taken_from():
    """The quartic of five positions has among its roots both pivots, and the pins on the coupler, of the known four-bar."""
    d, e = split(taken(KNOWN, [0.2, 1.0, 1.9, 3.0, 4.1]))
    g, w = five(d, e)
    assert len(g) == 4
    for pivot, pin in ((0.0, -1.5 - 1.2j), (4.0, 2.0 - 1.2j)):
        k = abs(g - pivot).argmin()
        assert g[k] == pytest.approx(pivot, abs=1e-9)
        assert w[k] == pytest.approx(pin, abs=1e-9)
    radii = abs(d + e * w[:, None] - g[:, None])
    np.testing.assert_allclose(radii, radii[:, :1].repeat(5, 1), rtol=1e-10)


@pytest.mark.parametrize("angles", [[0.2, 1.0, 1.9, 3.0, 4.1], [5.0, 4.4, 3.7, 2.5, 1.0]])
def test_a_four_bar_is_found_again_from_five_positions(angles):
    """All dimensions to 1e-9, in either sense of the crank."""
    wanted = np.array([0.0, 4.0, 1.0, 3.5, 2.5, abs(1.5 + 1.2j)])
    positions = taken(KNOWN, angles)
    found = through(positions, region=[(-100, -100), (100, 100)])
    assert min(abs(lengths(one) - wanted).max() for one in found) < 1e-9
    assert all(max(passed(one, positions)) < 1e-9 for one in found)


def test_a_four_bar_is_found_again_from_three_positions_and_its_pivots():
    """Three positions and both pivots leave one four-bar, which is driven from either side."""
    found = through(taken(KNOWN, [0.2, 1.0, 1.9]), pivots=[(0, 0), (4, 0)])
    assert {one.type for one in found} == {"crank-rocker"}
    np.testing.assert_allclose(lengths(found[0]), [0.0, 4.0, 1.0, 3.5, 2.5, abs(1.5 + 1.2j)], atol=1e-9)


def test_pivots_of_four_positions_lie_on_burmesters_curve():
    """Known pivots are on it (no residual), others are not; sampled ones keep the distance of their point."""
    d, e = split(taken(KNOWN, [0.2, 1.0, 1.9, 3.0]))
    _, left = points_for(d, e, np.array([0.0, 4.0, 1.0 + 1.0j]))
    assert left[:2].max() < 1e-12 < 1e-3 < left[2]
    g = centre_curve(d, e, -2 - 4j, 6 + 4j)
    assert len(g) > 200
    radii = abs(d + e * points_for(d, e, g)[0][:, None] - g[:, None])
    assert np.ptp(radii, axis=1).max() < 1e-9


def test_a_slider_crank_is_found_again_from_four_positions():
    """Four positions have one point on a line: that of the slider, on its slope."""
    positions = taken(SLIDING, [0.3, 0.9, 1.6, 2.4])
    w = on_lines(*split(positions), 1)
    assert w == pytest.approx([2.5 - (1.0 + 0.8j)], abs=1e-9)
    found = list(through(positions, kinds=("slider-crank",)))
    assert found
    slopes = [one.model.supports["C"].turned for one in found]
    np.testing.assert_allclose(np.tan(np.array(slopes, dtype=float)), np.tan(0.3), rtol=1e-9)
    assert all(max(passed(one, positions)) < 1e-9 for one in found)


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (1, 2, 3))])
def test_whatever_is_returned_passes_all_positions_in_order(seed):
    """Random positions: every linkage takes them by its drive alone, one after the other, on its branch."""
    rng = np.random.default_rng(seed)
    positions = np.column_stack([rng.uniform(-1, 1, (3, 2)), rng.uniform(-1.5, 1.5, 3)])
    found = through(positions, count=6)
    assert len(found) >= 6
    for one in found:
        assert max(passed(one, positions)) < 1e-9
        steps = np.diff(one.angles)
        assert (steps > 0).all() or (steps < 0).all()
        assert abs(one.angles[-1] - one.angles[0]) <= 2 * np.pi
        assert np.radians(15) <= one.transmission <= np.pi / 2


def test_linkages_with_defects_are_left_out_and_told():
    """A four-bar that would have to be taken apart between two positions is no answer, though it passes all of them."""
    other = of(A=0.0, D=4.0, a=1.0, h=3.5, r=2.5, side=-1.0, p=1.5 + 1.2j)
    positions = np.vstack([taken(KNOWN, [0.2, 1.0]), taken(other, [1.9])])
    found = through(positions, pivots=[(0, 0), (4, 0)])
    assert not len(found)
    assert "change their branch" in found.message
    disordered = through(taken(KNOWN, [0.2, 1.9, 1.0, 3.0, 4.1]), region=[(-100, -100), (100, 100)])
    assert "another order" in disordered.message


def test_five_positions_leave_no_slider_and_it_is_said():
    found = through(taken(KNOWN, [0.2, 1.0, 1.9, 3.0, 4.1]), kinds=("slider-crank",))
    assert not len(found)
    assert "No slider-crank" in found.message


@pytest.mark.slow
def test_the_cognates_of_a_coupler_curve_are_found():
    """Roberts and Chebyshev: three four-bars draw one curve, on pivots A, D and E = A + (D - A) p/h, two of them each."""
    chains = of(A=0.0, D=0.4, a=0.1, h=0.35, r=0.25, side=1.0, p=0.2 + 0.2j)
    P = chains.moved(np.linspace(0, 2 * np.pi, 24, endpoint=False)[None])[2][0]
    found = along(np.column_stack([P.real, P.imag]), closed=True, kinds=("four-bar",))
    exact = [one for one in found if one.error < 1e-9]
    assert exact
    pivots = np.array([0.0, 0.4, 0.4 * (0.2 + 0.2j) / 0.35])
    for one in exact:
        own = np.array([complex(*one.model.nodes[name].at) for name in "AD"])
        assert abs(own[:, None] - pivots).min(1).max() < 1e-6


@pytest.mark.slow
def test_scott_russells_slider_crank_draws_an_exact_line():
    """A rod twice as long as the crank, driven about the slider's line: the other end runs straight. Four-bars come near."""
    line = np.column_stack([np.linspace(0, 1, 10), np.linspace(0, 0.5, 10)])
    found = along(line, kinds=("slider-crank",))
    assert min(one.error for one in found) < 1e-9


@pytest.mark.slow
def test_a_line_is_drawn_at_least_as_well_as_by_chebyshevs_linkage():
    """Over the same stretch as half of his, relative to its length."""
    model = kt.library.mechanisms.chebyshev()
    turn = kt.Quintic(moves={"motor": (0.95, 1.4)}, duration=1.0)
    P = kt.kinematics.follow(model, turn, samples=15).position.sel(node="P").values
    middle = P - P.mean(0)
    _, values, _ = np.linalg.svd(middle)
    theirs = values[1] / np.sqrt(len(P)) / np.linalg.norm(P[-1] - P[0])
    found = along(np.column_stack([np.linspace(0, 1, 15), np.zeros(15)]), kinds=("four-bar",))
    assert min(one.error for one in found) < theirs


@pytest.mark.parametrize("slides", [False, True])
def test_derivatives_of_a_fit_are_those_of_its_residuals(slides):
    """Complex steps against central differences, where the loop closes, where it is open, and where links are too long."""
    path = np.exp(1j * np.linspace(0, 2, 7))
    for scale in (1.0, 9.0):
        own = [0.4, 0.3] if slides else [1.2, 0.1, 0.9]
        z = np.array([0.1, -0.2, 0.5 * scale, 0.8, 0.3, 0.4, *own, *np.linspace(0.1, 2.9, 7)])
        fit = _Fit(path, 1.0, slides)
        step = 1e-6
        central = np.array(
            [(fit.residuals(z + step * one) - fit.residuals(z - step * one)) / (2 * step) for one in np.eye(len(z))]
        ).T
        np.testing.assert_allclose(fit.jacobian(z), central, atol=1e-7 * scale)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: through([(0, 0, 0), (1, 0, 0)]), "expected 3, 4 or 5"),
        (lambda: through([(0, 0, 0), (1, 0, 0), (1, 0, 0)]), "positions 2 and 3 are the same"),
        (lambda: through([(0, 0, 0), (0, 0, 1), (0, 0, 2)]), "all at one place"),
        (lambda: through([(0, 0, 0), (1, 0, 0), (2, 1, 1)], kinds=("six-bar",)), "expected \\('four-bar',\\)"),
        (lambda: through([(0, 0, 0), (1, 0, 0), (2, 1, 1)], region=[(0, 0), (0, 1)]), "no area"),
        (lambda: through([(0, 0, 0), (1, 0, 0), (2, 1, 1), (3, 1, 2)], pivots=[(0, 0), (1, 0)]), "leave no choice"),
        (lambda: along([(0, 0), (1, 0), (2, 0)]), "at least 4"),
        (lambda: along([(0, 0), (0, 0), (1, 0), (1, 0), (2, 0)]), "fewer than four that differ"),
    ],
)
def test_what_is_no_task_is_refused(call, words):
    with pytest.raises(kt.errors.InputError, match=words):
        call()


@pytest.mark.slow
def test_a_path_that_no_linkage_draws_is_told_with_its_distance():
    """A square: what is found leaves it, by as much as the message says."""
    square = [(0, 0), (0.5, 0), (1, 0), (1, 0.5), (1, 1), (0.5, 1), (0, 1), (0, 0.5)]
    found = along(square, closed=True, kinds=("four-bar",))
    assert min((one.error for one in found), default=1.0) > 0.02
    assert "leaves the path by" in found.message or "No four-bar was found" in found.message
