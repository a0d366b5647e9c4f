"""Forces of static runs at their instants: those of the run, without inertia."""

import numpy as np
import pytest

import kinetruss as kt

SLEW = kt.Quintic(moves={"bay.beta": ("-10 deg", "10 deg")}, duration=0.2)
RUNS = {
    "linear": kt.Run(analysis="statics.linear"),
    "equilibrium": kt.Run(analysis="statics.equilibrium"),
    "poses": kt.Run(analysis="statics.at_poses", poses={"low": {"M7": 1.15}, "high": {"M7": 1.19}}),
    "along": kt.Run(analysis="statics.at_poses", trajectory=SLEW, samples=5),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", RUNS)
def test_forces_at_an_instant_are_those_of_the_run(name):
    model = kt.library.vgt.double_octahedral(tip_force=(0, 0, -50)).with_(runs={name: RUNS[name]})
    whole = next(iter(kt.run(model, name).forces.values()))
    t = float(whole.data.time[-1])
    at = kt.runs.forces_at(model, name, [t])
    assert at.member_force.values[0] == pytest.approx(whole.member_force.values[-1], rel=1e-9, abs=1e-9)
    peak = kt.runs.forces_at_peak(model, name, ("M6",))
    assert abs(peak.member_force.sel(member="M6").values[0]) == pytest.approx(np.abs(whole.member_force.sel(member="M6")).max())
    body = kt.dynamics.free_body(model, at.motion, at, node="N8")
    assert body.residual < 1e-9 * body.largest
