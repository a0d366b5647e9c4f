"""Small models that tests of runs, reports and the command line share."""

from __future__ import annotations

import kinetruss as kt

MOTOR = kt.Motor(
    inertia=6.76e-6, resistance=2.0, torque_constant=0.0398, emf_constant=0.0398, max_voltage=25.0, max_current=10.0
)
SCREW = kt.LeadScrew(lead=2.5266e-4, mean_diameter=0.0127, friction=0.1)
ALUMINIUM = kt.Material(E=71e9, density=2711.5, yield_strength=240e6)
FOURBAR_MOVES = kt.ConstantRate(rates={"motor": 10.0}, duration=0.6283)


def fourbar(samples: int = 41, **changes: object) -> kt.Model:
    """A four-bar linkage turned once by its crank; run ``turn``."""
    fields = {
        "title": "four-bar",
        "nodes": {"A": (0, 0), "B": (0, 0.10), "C": (0.30, 0.25), "D": (0.40, 0)},
        "fixed": ("A", "D"),
        "bars": {"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        "section": kt.Rectangle(width=0.020, height=0.005),
        "material": ALUMINIUM,
        "drives": {"motor": kt.AngleDrive("crank")},
        "runs": {"turn": kt.Run(trajectory=FOURBAR_MOVES, samples=samples)},
    }
    return kt.Model(**fields | changes)


def tripod(samples: int = 41, **changes: object) -> kt.Model:
    """Three active legs that carry a mass; run ``lift``, two load cases."""
    part = {"section": kt.Tube(outer=0.019, inner=0.016), "material": ALUMINIUM}
    leg = {"base": kt.Part(length=0.6, mass=2.0, **part), "tube": kt.Part(length=0.5, **part), "screw": SCREW, "motor": MOTOR,
           "gear": kt.Gear(ratio=5.2), "limits": (0.8, 1.3)}  # fmt: skip
    fields = {
        "title": "tripod",
        "nodes": {"A": (0.5, 0, 0), "B": (-0.25, 0.4330127, 0), "C": (-0.25, -0.4330127, 0),
                  "T": kt.Node(at=(0, 0, 0.9), mass=20.0)},
        "fixed": ("A", "B", "C"),
        "active": {name: kt.Active(ends=(foot, "T"), **leg) for name, foot in (("LA", "A"), ("LB", "B"), ("LC", "C"))},
        "gravity": (0, 0, -9.81),
        "loads": {"push": kt.NodalForce(node="T", force=(30.0, 0, 0))},
        "load_cases": {"standing": kt.LoadCase(loads={}), "pushed": kt.LoadCase(loads={"push": 1.0})},
        "runs": {"lift": kt.Run(trajectory=kt.Quintic(moves={"LA": (1.0295630, 1.15), "LB": (1.0295630, 1.05)}, duration=1.0),
                                samples=samples)},
    }  # fmt: skip
    return kt.Model(**fields | changes)
