"""One mass on a bar of each law, against closed forms; a cable that catches a falling mass."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from scipy.special import ellipj

from kinetruss import dynamics
from kinetruss.model import DOP853, Bar, Event, Model, Node
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

TIMES = (0.5, 1.0, 2.5, 5.0)
METHOD = DOP853(rtol=1e-12, atol=1e-13)
HARMONIC = Reference("closed-form", "x = l0 + (x0 - l0) cos(w t), w^2 = k/(m + m_bar/3)")
DAMPED = Reference("closed-form", "x = l0 + (x0 - l0) e^(-d t) (cos w t + d/w sin w t), d = c/(2 m), w^2 = k/m - d^2")
DUFFING = Reference("closed-form", "x = x0 dn(x0 sqrt(k/(4 m)) t/l0 | 2 - 2 l0^2/x0^2), Green's strain")
CAUGHT = Reference("closed-form", "free fall, half a swing about the stretched rest, free flight")

STIFFNESS, MASS, FROM = 100.0, 2.0, 1.3
"""k N/m, m kg, start m; l0 is 1 m."""
FALL = {"k": 2000.0, "m": 2.0, "g": 9.81, "drop": 0.6}
"""A mass 0.4 m under the hook of a cable of 1 m falls 0.6 m before it is caught."""


def swing(law: str) -> dict[str, float]:
    """Distance of the mass at `TIMES`; it starts from rest at 1.3 m."""
    laws: dict[str, dict[str, Any]] = {
        "engineering": {"mass": 1.5},
        "damped": {"damping": 3.0, "mass": 0.0},
        "green": {"strain": "green", "mass": 0.0},
    }
    spring = Bar(ends=("O", "P"), kind="elastic", stiffness=STIFFNESS, natural_length=1.0, **laws[law])
    model = Model(
        nodes={"O": (0.0, 0.0), "P": Node(at=(FROM, 0.0), mass=MASS)},
        fixed={"O": "xy", "P": "y"},
        bars={"bar": spring},
    )
    run = dynamics.simulate(model, TIMES[-1], times=[0.0, *TIMES], method=METHOD)
    return {f"{t:g}s": run.motion.position.sel(time=t, node="P", axis="x").item() for t in TIMES}


def _swung(law: str, t: float) -> float:
    amplitude = FROM - 1
    if law == "engineering":
        return 1 + amplitude * math.cos(math.sqrt(STIFFNESS / (MASS + 0.5)) * t)
    if law == "damped":
        d = 3.0 / (2 * MASS)
        w = math.sqrt(STIFFNESS / MASS - d * d)
        return 1 + amplitude * math.exp(-d * t) * (math.cos(w * t) + d / w * math.sin(w * t))
    return FROM * float(ellipj(FROM * math.sqrt(STIFFNESS / (4 * MASS)) * t, 2 - 2 / FROM**2)[2])


def caught() -> dict[str, float]:
    """Height under the hook while falling, held and thrown back; when the cable becomes tight and slack."""
    model = Model(
        nodes={"O": (0.0, 0.0), "P": Node(at=(0.0, -0.4), mass=FALL["m"])},
        fixed={"O": "xy", "P": "x"},
        bars={"cable": Bar(ends=("O", "P"), kind="cable", stiffness=FALL["k"], natural_length=1.0, mass=0.0)},
        gravity=(0.0, -FALL["g"]),
    )
    watched = {
        "tight": Event(length="cable", value=1.0, direction="rising", stop=False),
        "slack": Event(length="cable", value=1.0, direction="falling", stop=False),
    }
    tight, slack = _tight_slack()
    times = [0.0, 0.3, (tight + slack) / 2, slack + 0.2]
    run = dynamics.simulate(model, times[-1], times=times, method=METHOD, events=watched)
    y = run.motion.position.sel(node="P", axis="y").values
    pull = run.forces.member_force.sel(member="cable").values
    first = {event.name: event.time for event in reversed(run.events)}
    return first | {"falling": float(y[1]), "lowest": float(y[2]), "pull": float(pull[2]), "thrown": float(y[3])}


def _tight_slack() -> tuple[float, float]:
    tight, w = math.sqrt(2 * FALL["drop"] / FALL["g"]), math.sqrt(FALL["k"] / FALL["m"])
    # stretch s = g/w^2 (1 - cos) + v/w sin is zero again at tan(w tau/2) = -v w/g
    v = FALL["g"] * tight
    return tight, tight + 2 * (math.pi - math.atan(v * w / FALL["g"])) / w


def _caught() -> dict[str, float]:
    """Closed form of the same."""
    tight, slack = _tight_slack()
    w, g, v = math.sqrt(FALL["k"] / FALL["m"]), FALL["g"], FALL["g"] * tight
    sag = g / w**2
    lowest = sag + math.hypot(sag, v / w)
    return {
        "tight": tight,
        "slack": slack,
        "falling": -0.4 - g / 2 * 0.3**2,
        "lowest": -1 - lowest,
        "pull": FALL["k"] * lowest,
        "thrown": -1 + v * 0.2 - g / 2 * 0.2**2,
    }


def cases() -> Iterator[Case]:
    """Ten digits where the law is smooth; nine through the kinks of a cable."""
    for law, source in (("engineering", HARMONIC), ("damped", DAMPED), ("green", DUFFING)):
        for t in TIMES:
            yield Case(f"forward.law.{law}.{t:g}s", source, _swung(law, t), 1e-10, swing, (law,), (f"{t:g}s",))
    for name, value in _caught().items():
        yield Case(f"forward.law.cable.{name}", CAUGHT, value, 1e-9, caught, (), (name,))
