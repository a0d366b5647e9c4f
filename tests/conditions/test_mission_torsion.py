"""Torsion in missions and sizings: hinges and couples that enter hubs through members twist their arms in every pair."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kinetruss as kt

STEEL = kt.Material(E=2e11, density=7850.0, yield_strength=2.5e8)
ROD = kt.Rod(diameter=0.02)
PAIRS = (("slow", "plain"), ("slow", "laden"), ("fast", "plain"), ("fast", "laden"))


def flap(section: Any = ROD, **changes: Any) -> kt.Model:
    """A bar on a hinge whose axis is askew to its arm, so that the hinge twists and bends the arm, and a couple does so too."""
    fields: dict[str, Any] = {
        "nodes": {"O": (0, 0, 0), "A": kt.Node(at=(0.6, 0, 0.1), mass=2.0)},
        "fixed": ["O"],
        "bars": {"link": ("O", "A")},
        "gravity": (0, 0, -9.81),
        "hubs": {"O": kt.Hub(arms={"link": (0.05, 0, 0.1)}, hinges={"link": (0, 1, 0.2)}, section=section, material=STEEL)},
        "drives": {"turn": kt.HingeDrive(axis=("O.link", "O.link.axis1"), start="O", end="A")},
        "section": ROD,
        "material": STEEL,
    }
    model = kt.Model(**fields)
    start = float(kt.kinematics.sample(model, kt.ConstantRate(rates={"turn": 1.0}, duration=1.0), [0.0]).value[0, 0])
    couple = kt.BodyCouple(body="O.hub", member="link", moment=(60.0, 20.0, 120.0))
    rest = {
        "loads": {"couple": couple, "side": kt.NodalForce(node="A", force=(0, 40.0, 0))},
        "load_cases": {"none": kt.LoadCase(loads={"side": 0.1}), "both": kt.LoadCase(loads={"couple": 1.0, "side": 1.0})},
        "trajectories": {
            name: kt.Quintic(moves={"turn": (start, start + 1.2)}, duration=duration)
            for name, duration in (("slow", 2.0), ("fast", 0.4))
        },
        "conditions": {"plain": kt.Condition(), "laden": kt.Condition(payloads={"A": 3.0})},
        "runs": {
            "all": kt.Run(analysis="mission", motions=("slow", "fast"), conditions=("plain", "laden"), samples=21),
            **{
                f"{motion}_{condition}": kt.Run(trajectory=motion, condition=condition, samples=21)
                for motion, condition in PAIRS
            },
        },
    }
    return model.with_(**(rest | changes))


def alone(model: kt.Model) -> dict[tuple[str, str], float]:
    """Highest utilisation by part and rule over runs of each pair, done alone; NaN where one of them could not be checked."""
    found: dict[tuple[str, str], float] = {}
    for motion, condition in PAIRS:
        for row in kt.run(model, f"{motion}_{condition}").verdict.table():
            known = found.get((row.part, row.rule), -1.0)
            found[row.part, row.rule] = max(known, row.utilisation) if row.utilisation == row.utilisation else known
    return found


@pytest.mark.slow
def test_the_envelope_has_the_torsion_of_the_runs() -> None:
    """Part by part, rule by rule and pair by pair; torsion is what governs the arm."""
    model = flap()
    mission, wanted = kt.run(model, "all"), alone(model)
    found = {(row.part, row.rule): row.utilisation for row in mission.verdict.table() if row.checked}
    assert found == pytest.approx({key: value for key, value in wanted.items() if value >= 0}, rel=1e-9, abs=1e-14)
    for pair in range(mission.good):
        single = kt.runs.governing(mission, pair)
        worst = max(row.utilisation for row in single.verdict.table() if row.checked)
        assert mission.pairs["utilisation"].values[pair] == pytest.approx(worst, rel=1e-9)
    # the arm at its root, by hand: bending and torsion of what the sections have there; V adds to it
    run = kt.run(model, "fast_laden")
    one = kt.strength.sections(flap().with_(nodes=run.model.nodes), run.forces["both"]).data.sel(part="O.link")
    W = np.pi * 0.02**3 / 32
    s = np.abs(one.section_T) / (np.pi * 1e-4) + np.linalg.norm(one.section_M, axis=-1) / W
    by_hand = float(np.sqrt(s**2 + 3 * (one.torsion / (2 * W)) ** 2).max()) / 2.5e8
    assert by_hand <= found["O.link", "yield"] <= 1.05 * by_hand
    assert float(s.max()) / 2.5e8 < 0.9 * by_hand
    assert not mission.verdict.message


@pytest.mark.slow
def test_an_arm_whose_section_does_not_know_its_shear_stress_is_not_checked() -> None:
    """In one case it is twisted, in the other not: no number of the other case is shown for both."""
    general = kt.General(area=3e-4, I2=8e-9, I3=8e-9, c2=0.01, c3=0.01)
    model = flap(general)
    mission = kt.run(model, "all")
    runs = [kt.run(model, f"{motion}_{condition}") for motion, condition in PAIRS]
    for verdict in (mission.verdict, *(run.verdict for run in runs)):
        (row,) = [row for row in verdict.table() if (row.part, row.rule) == ("O.link", "yield")]
        assert not row.checked and "torsion" in row.note
    others = {(row.part, row.rule): row.utilisation for row in mission.verdict.table() if row.checked}
    assert others["link", "yield"] > 0 and ("O.link", "yield") not in others
    for pair in range(mission.good):
        assert mission.pairs["utilisation"].values[pair] <= max(others.values()) * (1 + 1e-12)


WALLS = tuple(range(16, 36, 2))


def sized(folder: Path, largest: int) -> kt.design.Sizing:
    """The arm from tubes with a wall of 1 mm up to an outer diameter, mm."""
    tubes = "".join(f'  "{d}x1": {{outer: {d} mm, wall: 1 mm}}\n' for d in WALLS if d <= largest)
    (folder / "tubes.yaml").write_text(f"source: own\nmaterial: steel_s235\ntubes:\n{tubes}", "utf-8")
    mission = folder / "mission.yaml"
    mission.write_text('kinetruss_mission: 1\ngroups:\n  arm: ["O.link"]\ncatalogues: {tubes: tubes.yaml}\n', "utf-8")
    return kt.design.size(swung(), mission)


def swung() -> kt.Model:
    """The flap with two runs, and an arm whose section the model decides."""
    model = flap()
    runs = {name: kt.Run(trajectory=name, samples=21) for name in ("slow", "fast")}
    return model.with_(hubs={"O": model.hubs["O"].with_(section=None, material=None)}, runs=runs)


@pytest.mark.slow
def test_a_sizing_counts_torsion_and_proves_it(tmp_path: Path) -> None:
    """The tube is the lightest that passes runs of models with each tube; with smaller ones only the message is left."""
    model, worst = swung(), {}
    for d in WALLS:
        tube = kt.Tube(outer=1e-3 * d, inner=1e-3 * (d - 2))
        with_tube = model.with_(hubs={"O": model.hubs["O"].with_(section=tube, material="steel_s235")})
        rows = [row for name in model.runs for row in kt.run(with_tube, name).verdict.table()]
        worst[d] = max(row.utilisation for row in rows if row.part == "O.link" and row.checked)
    lightest = next(d for d in WALLS if worst[d] <= 1)
    (group,) = sized(tmp_path, WALLS[-1]).groups
    assert (group.tube, group.smaller) == (f"{lightest}x1", f"{lightest - 2}x1")
    assert (group.utilisation, group.smaller_utilisation) == pytest.approx((worst[lightest], worst[lightest - 2]), rel=1e-9)
    with pytest.raises(kt.AnalysisError, match=f"reaches {worst[lightest - 2]:.4g} times what is allowed by yield"):
        sized(tmp_path, lightest - 2)
