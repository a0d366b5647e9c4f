"""Variants of the triangular truss: how near a slow motion comes to rest.

Stretched in time, the same path has rates smaller by the factor and second rates by its square, so what the motion adds to
the forces at rest falls with the square of the duration, and so do stresses where no sign changes. The distance of the 10 s
motion from rest follows from the reference values of the 3 s motion without any computation of this package.
"""

from __future__ import annotations

import kinetruss as kt
from kinetruss.verification.thesis.triangle import truss

BASE = 3.0  # s, of the reference
PARTS = {"follower": ("follower", 0.5), "tube": ("actuator.tube", 0.0)}
"""Name in the reference -> part and station."""

Table = dict[str, dict[str, float]]


def slow(duration: float) -> Table:
    """Largest stress at rest, how far the motion lifts the stress above it, and the one over the other, by part."""
    trajectory = kt.StepResponse(moves={"actuator": (2.5, 3.7)}, duration=BASE, damping=0.8, settling_factor=6.0)
    model = truss().with_(runs={"extend": kt.Run(trajectory=trajectory, samples=3001)})
    (run,) = kt.runs.run_variants(model, {"runs.extend.trajectory.duration": [duration]}).values()
    found: Table = {}
    for name, (part, station) in PARTS.items():
        (curve,) = kt.report.curves(run, "S2", [part], station=station)
        assert curve.static is not None  # noqa: S101 - a stress has its static one
        above = curve.values - curve.static
        at, static = int(above.argmax()), float(curve.static.max())
        found[name] = {
            "static_max": static,
            "distance": float(above[at]),
            "distance_time": float(curve.time[at]),
            "distance_over_static": float(above[at]) / static,
        }
    return found
