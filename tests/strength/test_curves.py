"""Curves over a structure: closed forms at the written points, the side on which they are drawn, results elsewhere."""

import numpy as np
import pytest

import kinetruss as kt
import loaded_frames as frames
from kinetruss.errors import InputError
from kinetruss.runs import run
from kinetruss.strength.curves import curves, factor_of, only, quantities_shown
from loaded_frames import EI, LOAD, LONG
from samples import fourbar


def of(model: kt.Model, show: str, case: str = "all"):
    found = run(model, "rest")
    return curves(found.model, found.forces[case], show)


def written(one) -> list[tuple[float, float]]:
    return [(float(one.x[k]), float(one.values[k])) for k in one.extremes]


def test_a_simply_supported_beam_has_w_l_squared_over_8_in_the_middle_below_it():
    (moment,) = of(frames.simple(), "M").curves
    assert written(moment) == [(pytest.approx(LONG / 2), pytest.approx(LOAD * LONG**2 / 8, rel=1e-9))]
    # in tension below: a metre a unit moves the middle down by the moment
    (k,) = moment.extremes
    assert moment.tips(1e-4)[k] == pytest.approx([LONG / 2, -1e-4 * LOAD * LONG**2 / 8])
    (shear,) = of(frames.simple(), "V").curves
    assert written(shear) == [(0.0, pytest.approx(-LOAD * LONG / 2)), (LONG, pytest.approx(LOAD * LONG / 2))]
    assert of(frames.simple(), "N").largest == 0.0
    (bent,) = of(frames.simple(), "deflection").curves
    assert written(bent) == [(pytest.approx(LONG / 2), pytest.approx(5 * LOAD * LONG**4 / 384 / EI, rel=1e-9))]
    assert bent.shift[bent.extremes[0]] == pytest.approx([0, -5 * LOAD * LONG**4 / 384 / EI], abs=1e-12)


def test_a_clamped_beam_has_both_extremes_and_tension_above_its_ends():
    clamp = kt.Support(x="held", y="held", rotation="held")
    (moment,) = of(frames.simple(supports={"A": clamp, "B": clamp}), "M").curves
    low, high = moment.extremes
    assert moment.values[low] == pytest.approx(-LOAD * LONG**2 / 12, rel=1e-9)
    assert (moment.x[high], moment.values[high]) == (pytest.approx(LONG / 2), pytest.approx(LOAD * LONG**2 / 24, rel=1e-9))
    assert moment.tips(1e-4)[low][1] > 0 > moment.tips(1e-4)[high][1]


@pytest.mark.parametrize(("begin", "end", "shape"), [(1.1, 2.7, (0, 1)), (0.0, 4.0, (1, 0)), (0.3, 0.9, (1, 1))])
def test_the_largest_moment_is_found_wherever_loads_begin_and_end(begin, end, shape):
    """The top between stations against the roots of the shear force, by statics."""
    load = kt.MemberLoad(member="beam", force=(0, -LOAD), start=begin, end=end, shape=shape)
    (moment,) = of(frames.simple(loads={"q": load}), "M").curves
    s = np.linspace(0, LONG, 400_001)
    eta = np.clip((s - begin) / (end - begin), 0, 1)
    width, (first, last) = end - begin, shape
    whole = LOAD * width * eta * (first + (last - first) * eta / 2)
    turn = LOAD * width**2 * eta**2 * (first / 2 + (last - first) * eta / 6) + np.maximum(s - end, 0) * whole
    by_hand = turn[-1] / LONG * s - turn
    ((x, value),) = written(moment)
    assert value == pytest.approx(by_hand.max(), rel=2e-5)
    assert x == pytest.approx(s[by_hand.argmax()], abs=2e-3)


@pytest.mark.slow
def test_curves_of_a_frame_in_space_are_those_of_beams():
    found = run(frames.space(), "rest")
    beams = kt.strength.beams(found.model, found.forces["all"], stations=97).isel(time=0)
    arrays = {
        "N": beams.section_T, "V2": beams.section_V.sel(transverse="2"), "V3": beams.section_V.sel(transverse="3"),
        "M2": beams.section_M.sel(moment="2"), "M3": beams.section_M.sel(moment="3"), "torque": beams.torsion,
    }  # fmt: skip
    assert set(quantities_shown(3)) == {*arrays, "deflection"}
    for show, array in arrays.items():
        for one in curves(found.model, found.forces["all"], show).curves:
            wanted, length = array.sel(beam=one.part).values, float(one.x[-1])
            assert np.interp(beams.station * length, one.x, one.values) == pytest.approx(
                wanted, abs=1e-9 * abs(array).max().item()
            )
            assert np.linalg.norm(one.shift, axis=1) == pytest.approx(np.abs(one.values))
    for also, show in (("My", "M2"), ("Mz", "M3"), ("Vy", "V2"), ("Vz", "V3"), ("T", "torque")):
        assert curves(found.model, found.forces["all"], also).show == show


def test_bars_of_a_mechanism_have_those_of_sections_at_an_instant():
    model = fourbar()
    found = run(model, next(iter(model.runs)))
    forces = only(next(iter(found.forces.values())), 7)
    data = kt.strength.sections(model, forces, stations=97).data.isel(time=0)
    for show, array in (("N", data.section_T), ("V", data.section_V[..., 0]), ("M", data.section_M[..., 0])):
        for one in curves(model, forces, show).curves:
            values = array.sel(part=one.part).values
            assert np.interp(data.station * float(data.part_length.sel(part=one.part)), one.x, one.values) == pytest.approx(
                values, abs=1e-9 * float(abs(array).max())
            )
            assert one.values.max() >= values.max() - 1e-12 * abs(values).max()
    with pytest.raises(InputError, match="deflection is not known"):
        curves(model, forces, "deflection")
    with pytest.raises(InputError, match="Nothing called 'Q'"):
        curves(model, forces, "Q")


def test_the_scale_is_shared_and_that_of_deflections_round():
    many = [of(frames.portal(), "M", case) for case in ("snow", "wind")]
    factor = factor_of(many, 10.0)
    assert factor * max(one.largest for one in many) == pytest.approx(1.3)
    bent = of(frames.simple(), "deflection")
    assert factor_of([bent], 4.0) == 200.0
    assert factor_of([of(frames.simple(), "N")], 4.0) == 0.0


def test_a_spring_that_turns_a_node_does_not_hide_the_forces_of_its_beams():
    """The moment of the beam at the spring is that of the spring, stiffness times rotation."""
    found = run(frames.portal(), "rest")
    for case in ("snow", "wind"):
        (right,) = [one for one in curves(found.model, found.forces[case], "M").curves if one.part == "right"]
        turned = kt.statics.linear(found.model, load_case=case).node_rotation.sel(frame="D").item()
        assert abs(right.values[0]) == pytest.approx(2e6 * abs(turned), rel=1e-9)
