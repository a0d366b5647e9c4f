"""Error budgets: two bars in closed form, and a bay by the nonlinear model."""

from __future__ import annotations

import kinetruss as kt


def two_bars() -> dict[str, float]:
    """Sensitivities of the foot of two hanging bars of 1.25 m over a base of 1.5 m to the length of one; worst case and root of
    squares for 0.1 mm each.
    """
    model = kt.Model(
        nodes={"A": (-0.75, 0), "B": (0.75, 0), "C": (0, -1)},
        fixed=["A", "B"],
        bars={"left": ("A", "C"), "right": ("B", "C")},
    )
    found = kt.runs.budget(model, ["C.x", "C.y"], {"*.length": 1e-4}, samples=4)
    slope = found.data["sensitivity"].sel(parameter="left.length").values
    return {
        "x": float(slope[0]),
        "y": float(slope[1]),
        "worst_case": float(found.data["worst_case"].values[1]),
        "root_sum_square": float(found.data["root_sum_square"].values[1]),
    }


def monte_carlo() -> dict[str, float]:
    """Largest difference of Monte Carlo and root of squares, in standard errors, over pose and forces of a bay."""
    model = kt.library.vgt.double_octahedral(gravity=(0, 0, 9.81), tip_force=(0, 0, 46))
    of = ["bay.beta", "bay.gamma", "bay.height", "M6.force", "M7.drive_force"]
    found = kt.runs.budget(model, of, {"M*.length": 1e-4}, at={"bay.beta": 0.1}, samples=2000, seed=1).data
    off = abs(found["monte_carlo"] - found["root_sum_square"]) / found["monte_carlo_error"]
    return {"within_four_standard_errors": float(off.max() < 4)}
