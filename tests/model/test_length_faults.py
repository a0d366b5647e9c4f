"""Trajectories that take a length to zero or below are found before any work, wherever they stand."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.io import check
from kinetruss.model import trajectory_faults

STEWART = kt.library.mechanisms.stewart()
LEG = float(np.linalg.norm(np.subtract(*(STEWART.nodes[end].at for end in STEWART.members["leg5"].ends))))
THROUGH = {
    "from zero": kt.Quintic(moves={"leg5": (0.0, 0.76)}, duration=1.0),
    "to zero": kt.Trapezoid(moves={"leg5": (LEG, 0.0)}, duration=1.0),
    "below": kt.Cyclic(moves={"leg5": (LEG, -0.1)}, period=1.0),
    "too long": kt.ConstantRate(rates={"leg5": -0.5}, duration=2.0),
    "to and fro": kt.Sine(amplitudes={"leg5": 0.7}, period=1.0, duration=1.0),
    "overshoot": kt.StepResponse(moves={"leg5": (LEG, 0.02)}, duration=1.0, damping=0.3, order=2),
    "table": kt.Spline(times=(0.0, 0.1, 0.2, 0.3), values={"leg5": (0.6, 0.2, -0.001, 0.3)}),
}
ABOVE = {
    "near zero": kt.Quintic(moves={"leg5": (LEG, 0.001)}, duration=1.0),
    "half": kt.Sine(amplitudes={"leg5": 0.6}, period=4.0, phase=np.pi, duration=0.5),
    "angle": kt.Quintic(moves={"leg1": (LEG, LEG)}, duration=1.0),
    "slow": kt.ConstantRate(rates={"leg5": -0.5}, duration=1.0),
    "damped": kt.StepResponse(moves={"leg5": (LEG, 0.02)}, duration=1.0, damping=1.2, order=2),
}


@pytest.mark.parametrize("path", THROUGH.values(), ids=THROUGH)
def test_it_is_a_fault_of_its_place(path):
    (found,) = trajectory_faults(STEWART, path, ("here",))
    assert found.path[0] == "here" and found.path[-1] == "leg5"
    assert "takes the length of 'leg5' to" in found.message and "above 0 m" in found.mend
    with pytest.raises(kt.ModelError, match="takes the length of 'leg5'"):
        kt.kinematics.follow(STEWART, path, samples=3)


@pytest.mark.parametrize("path", ABOVE.values(), ids=ABOVE)
def test_above_zero_is_none(path):
    assert not list(trajectory_faults(STEWART, path))


def test_a_file_says_the_line(tmp_path):
    file = tmp_path / "legs.yaml"
    file.write_text(
        "kinetruss: 1\nlibrary: {name: mechanisms.stewart, at: [0, 0, 600 mm]}\nruns:\n  rise:\n    trajectory:\n"
        "      kind: quintic\n      moves:\n        leg5: [0 mm, 760 mm]\n      duration: 1 s\n    samples: 11\n"
    )
    (fault,) = check(file)
    assert (fault.line, fault.path[-1]) == (8, "leg5")


def test_angles_may_go_through_zero():
    bar = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, bars={"b": ("A", "B")}, fixed=["A"], drives={"turn": kt.AngleDrive("b")})
    assert not list(trajectory_faults(bar, kt.Quintic(moves={"turn": (1.0, -1.0)}, duration=1.0)))
