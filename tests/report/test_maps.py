"""Maps of a workspace: reach, stroke and distance from singular positions of two bars, in closed form, and as pictures."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report

LEG = {"kind": "driven"}


@pytest.fixture(scope="module")
def found():
    two = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "P": (0.5, 1)},
        fixed=["A", "B"],
        bars={"a": {"ends": ("A", "P"), **LEG}, "b": {"ends": ("B", "P"), **LEG}},
    )
    grid = (("x", np.linspace(0, 1, 9)), ("y", np.linspace(0.25, 1.25, 5)))
    return kt.kinematics.workspace(two, "P", *grid, limits={"a": (0.5, 1.2)})


def lengths(found):
    x, y = np.meshgrid(found["x"].values, found["y"].values)
    return x, y, np.hypot(x, y), np.hypot(x - 1, y)


@pytest.mark.slow
def test_the_stroke_is_the_share_of_the_way_between_the_limits(found):
    _, _, a, _ = lengths(found)
    assert found.stroke.sel(drive="a").values == pytest.approx((a - 0.5) / 0.7, rel=1e-9)
    assert np.isnan(found.stroke.sel(drive="b").values).all()


@pytest.mark.slow
def test_the_limit_names_the_drive_and_the_side(found):
    _, _, a, _ = lengths(found)
    wanted = np.where(a < 0.5, "a short", np.where(a > 1.2, "a long", ""))
    assert np.array_equal(found["limit"].values, wanted)
    assert np.array_equal(found.within.values, wanted == "")


def test_the_conditioning_of_two_bars_is_that_of_the_angle_between_them(found):
    """Unit rows u_a, u_b at the angle t: singular values sqrt(1 -+ |cos t|)."""
    x, y, a, b = lengths(found)
    cosine = np.abs((x * (x - 1) + y * y) / (a * b))
    assert found.parallel.values == pytest.approx(np.sqrt(1 - cosine), rel=1e-9)
    assert found.conditioning.values == pytest.approx(np.sqrt((1 - cosine) / (1 + cosine)), rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("quantity", ["reach", "stroke", "serial", "parallel", "conditioning"])
def test_every_map_is_drawn(found, quantity, tmp_path):
    first, again = (report.map_picture(found, tmp_path / f"{name}.svg", quantity) for name in ("one", "two"))
    assert first.read_bytes() == again.read_bytes()
    assert "x, m" in first.read_text("utf-8")


def test_what_cannot_be_drawn_is_told(found, tmp_path):
    with pytest.raises(kt.InputError, match="No map of 'strok'. Did you mean 'stroke'"):
        report.map_picture(found, tmp_path / "m.png", "strok")
    with pytest.raises(kt.InputError, match="Name the drive"):
        report.map_picture(found, tmp_path / "m.png", "drive_position")
    with pytest.raises(kt.InputError, match="pictures end in"):
        report.map_picture(found, tmp_path / "m.bmp")
