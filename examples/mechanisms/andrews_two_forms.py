"""Andrews' mechanism in both forms, ten bars, and nine bars with a rigid beam for the crank: the same known end."""

import math

import numpy as np

import kinetruss as kt

BETA = 15.81077119515370709711938  # crank angle after 0.03 s, quadrature of the energy of the one freedom

found = {}
for form in ("bars", "beam"):
    model = kt.library.mechanisms.andrews(form=form)
    run = kt.dynamics.simulate(
        model, 0.03, tasks={"motor": kt.GivenForce(torque=0.033)}, samples=2, method=kt.DOP853(rtol=1e-11, atol=1e-13)
    )
    found[form] = run.motion.position.isel(time=-1)
    mobility = kt.kinematics.mobility(model)
    F = found[form].sel(node="F").values
    wanted = 0.007 * np.array([math.cos(BETA), math.sin(BETA)])
    print(f"{form}: {mobility.coordinates} coordinates, {mobility.fixed} fixed, F off by {np.abs(F - wanted).max():.1e} m")
    assert np.allclose(F, wanted, rtol=0, atol=1e-11)
assert abs(float(found["beam"].sel(node="beta", axis="x")) - BETA) < 1e-9
