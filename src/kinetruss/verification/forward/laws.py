"""One mass on a bar of each law, against closed forms; a cable that catches a falling mass."""

from __future__ import annotations

import math
from typing import Any

import kinetruss as kt

TIMES = (0.5, 1.0, 2.5, 5.0)
METHOD = kt.DOP853(rtol=1e-12, atol=1e-13)

STIFFNESS, MASS, FROM = 100.0, 2.0, 1.3
"""k N/m, m kg, start m; l0 is 1 m."""
FALL = {"k": 2000.0, "m": 2.0, "g": 9.81, "drop": 0.6}
"""A mass 0.4 m under the hook of a cable of 1 m falls 0.6 m before it is caught."""
TIGHT, W = math.sqrt(2 * FALL["drop"] / FALL["g"]), math.sqrt(FALL["k"] / FALL["m"])
SLACK = TIGHT + 2 * (math.pi - math.atan(TIGHT * W)) / W
"""s: the elongation s = g/w^2 (1 - cos) + g t/w sin is zero again at tan(w tau/2) = -w t."""


def swing(law: str) -> dict[str, float]:
    """Distance of the mass at `TIMES`; it starts from rest at 1.3 m."""
    laws: dict[str, dict[str, Any]] = {
        "engineering": {"mass": 1.5},
        "damped": {"damping": 3.0, "mass": 0.0},
        "green": {"strain": "green", "mass": 0.0},
    }
    spring = kt.Bar(ends=("O", "P"), kind="elastic", stiffness=STIFFNESS, natural_length=1.0, **laws[law])
    model = kt.Model(
        nodes={"O": (0.0, 0.0), "P": kt.Node(at=(FROM, 0.0), mass=MASS)},
        fixed={"O": "xy", "P": "y"},
        bars={"bar": spring},
    )
    run = kt.dynamics.simulate(model, TIMES[-1], times=[0.0, *TIMES], method=METHOD)
    return {f"{t:g}s": run.motion.position.sel(time=t, node="P", axis="x").item() for t in TIMES}


def caught() -> dict[str, float]:
    """Height under the hook while falling, held and thrown back; when the cable becomes tight and slack."""
    model = kt.Model(
        nodes={"O": (0.0, 0.0), "P": kt.Node(at=(0.0, -0.4), mass=FALL["m"])},
        fixed={"O": "xy", "P": "x"},
        bars={"cable": kt.Bar(ends=("O", "P"), kind="cable", stiffness=FALL["k"], natural_length=1.0, mass=0.0)},
        gravity=(0.0, -FALL["g"]),
    )
    watched = {
        "tight": kt.Event(length="cable", value=1.0, direction="rising", stop=False),
        "slack": kt.Event(length="cable", value=1.0, direction="falling", stop=False),
    }
    times = [0.0, 0.3, 0.5 * (TIGHT + SLACK), SLACK + 0.2]
    run = kt.dynamics.simulate(model, times[-1], times=times, method=METHOD, events=watched)
    y = run.motion.position.sel(node="P", axis="y").values
    tension = run.forces.member_force.sel(member="cable").values
    first = {event.name: event.time for event in reversed(run.events)}
    return first | {"falling": float(y[1]), "lowest": float(y[2]), "tension": float(tension[2]), "thrown": float(y[3])}
