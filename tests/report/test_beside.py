"""Ideal beside real in one table."""

from __future__ import annotations

import csv
from typing import Any

import numpy as np
import pytest

import kinetruss as kt


def four_bar(**real: Any) -> tuple[kt.Model, Any]:
    """A linkage and its forces."""
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.05, 0.15), "C": (0.75, 0.45), "D": (0.9, 0)},
        fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        drives={"motor": kt.AngleDrive("crank")},
        gravity=(0, -9.81),
        section=kt.Rod(diameter=0.02),
        material="steel_s235",
        **real,
    )
    start = float(np.arctan2(0.15, 0.05))
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"motor": (start, start + 1)}, duration=0.4), samples=9)
    return model, kt.dynamics.inverse(model, motion)


def test_forces_stresses_and_places(tmp_path: Any) -> None:
    """By the names that both have; the numbers are those of the results."""
    hubs = {"B": kt.Hub(arms={"coupler": (0.03, 0.04)}, clamped=["crank"]), "D": kt.Hub(reach=0.02)}
    ideal, real = four_bar(), four_bar(hubs=hubs)
    page = kt.report.beside(ideal, real)
    rows = {(row.quantity, row.of): row for row in page.found}
    assert {of for quantity, of in rows if quantity == "member_force"} == {"crank", "coupler", "rocker"}
    both = [forces.data.drive_force.sel(drive="motor").values for _, forces in (ideal, real)]
    torque = rows["drive_force", "motor"]
    assert torque.ideal == both[0][np.argmax(np.abs(both[0]))]
    assert torque.difference == np.abs(both[1] - both[0]).max()
    assert rows["position", "A"].difference == 0
    assert rows["position", "C"].difference > 1e-3
    assert rows["von_mises", "crank"].ratio > 1
    head, *lines = csv.reader(page.write(tmp_path / "both.csv").read_text().splitlines())
    assert head[:2] == ["quantity", "of"] and len(lines) == len(page.found) == len(page.record)
    assert page.text.splitlines()[0].split()[0] == "quantity"


def test_other_instants_are_refused() -> None:
    """Both must be at the same times."""
    model, forces = four_bar()
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"motor": (1.25, 1.5)}, duration=0.4), samples=5)
    with pytest.raises(kt.InputError, match="other instants"):
        kt.report.beside((model, forces), (model, kt.dynamics.inverse(model, motion)))
