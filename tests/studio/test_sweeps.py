"""Drives through their range, as a drawing plays them: closed forms of poses, forces and of where they block."""

from __future__ import annotations

import math

import numpy as np
import pytest

import kinetruss as kt
from drawn import asked, unpacked
from four_bars import four_bar
from kinetruss.strength import utilisation
from kinetruss.studio import Session
from kinetruss.studio.poses import at_rest, strength_of
from kinetruss.studio.sweeps import film, swept, with_strength


def crank(mass: float = 0.0, radius: float = 0.2) -> kt.Model:
    """A crank upright about A, with 100 N down at its tip B."""
    return kt.Model(
        nodes={"A": (0, 0), "B": kt.Node(at=(0, radius), mass=mass)}, fixed={"A": "xy"}, bars={"b": ("A", "B")},
        drives={"motor": kt.AngleDrive("b")}, loads={"F": kt.NodalForce(node="B", force=(0, -100))}, gravity=(0, 0),
    )  # fmt: skip


def test_a_crank_turns_all_round_and_its_torque_and_reaction_are_those_of_the_lever():
    model = crank()
    found = swept(model, kt.kinematics.assemble(model), ["motor"])
    header, arrays, _ = film(found, model)
    angle = found.values[:, 0]
    assert found.whole
    assert (found.here, found.ends) == (0, ("", ""))
    np.testing.assert_allclose(angle, np.linspace(math.pi / 2, 2.5 * math.pi, len(angle)), atol=1e-12)
    tip = 0.2 * np.column_stack([np.cos(angle), np.sin(angle)])
    np.testing.assert_allclose(arrays["position"][:, 1], tip, atol=1e-14)
    np.testing.assert_allclose(arrays["drive_force"][:, 0], 100 * tip[:, 0], atol=1e-10)  # it works against the load
    np.testing.assert_allclose(arrays["reaction"][:, header["supports"].index("A")], [[0, 100]] * len(angle), atol=1e-10)


def test_at_speed_the_support_carries_the_centripetal_force():
    mass, rate = 3.0, 10.0
    model = crank(mass)
    found = swept(model, kt.kinematics.assemble(model), ["motor"], rate=rate)
    assert found.time[-1] == pytest.approx(2 * math.pi / rate)
    angle = found.values[:, 0]
    inward = -mass * 0.2 * rate**2 * np.column_stack([np.cos(angle), np.sin(angle)])
    for at_speed in (False, True):
        _, arrays, _ = film(found, model, at_speed)
        np.testing.assert_allclose(arrays["reaction"][:, 0], inward * at_speed + [0, 100], atol=1e-9)


def test_a_four_bar_blocks_where_rod_and_rocker_are_in_line():
    a, b, c, ground = 0.3, 0.2, 0.25, 0.5
    model = four_bar((a, b, c), ground, 0.8)
    found = swept(model, kt.kinematics.assemble(model), ["motor"])
    end = math.acos((a**2 + ground**2 - (b + c) ** 2) / (2 * a * ground))  # law of cosines
    angle = found.values[:, 0]
    assert not found.whole
    assert angle[-1] == pytest.approx(end, abs=math.radians(0.1))
    assert angle[0] == pytest.approx(-end, abs=math.radians(0.1))
    assert np.abs(angle).max() < end
    for words in found.ends:
        assert words.startswith("motor blocks at ")
        assert words.endswith("rod and rocker are in line at C.")
    x = found.position
    for p, q, length in ((0, 1, a), (1, 2, b), (3, 2, c)):
        np.testing.assert_allclose(np.linalg.norm(x[:, p] - x[:, q], axis=1), length, atol=1e-12)
    inner = slice(len(angle) // 4, 3 * len(angle) // 4)  # away from the ends, where rates grow without bound
    rates = np.gradient(x, found.time, axis=0, edge_order=2)
    np.testing.assert_allclose(found.velocity[inner], rates[inner], atol=2e-3 * np.abs(rates[inner]).max())


def test_a_cylinder_blocks_where_it_is_in_line_with_the_link_that_it_lifts():
    model = kt.Model(
        nodes={"A": (0, 0), "P": (0.8, 0.6), "T": (1.6, 1), "B": (0.4, 0)}, fixed={"A": "xy", "B": "xy"},
        links={"boom": ("A", "P", "T")}, bars={"jack": kt.Bar(ends=("B", "P"), kind="driven")},
    )  # fmt: skip
    found = swept(model, kt.kinematics.assemble(model), ["jack"])
    assert found.values[0, 0] == pytest.approx(0.6, abs=2e-3)  # |AP| - |AB|: P, A and B in line
    assert found.ends[0] == "jack blocks at 600 mm: jack and boom are in line at P."


def test_the_work_of_the_drive_is_that_of_the_load():
    model = four_bar((0.1, 0.35, 0.3), 0.4)
    found = swept(model, kt.kinematics.assemble(model), ["motor"])
    assert found.whole
    _, arrays, _ = film(found, model)
    torque, height = arrays["drive_force"][:, 0], arrays["position"][:, 2, 1]
    work = np.r_[0, np.cumsum(np.diff(found.values[:, 0]) * (torque[1:] + torque[:-1]) / 2)]
    np.testing.assert_allclose(work, 100 * (height - height[0]), atol=1e-4 * np.ptp(100 * height))


def test_a_jack_goes_through_its_limits_and_several_drives_go_together():
    bars = {"boom": kt.Bar(ends=("A", "B")), "jack": kt.Bar(ends=("C", "B"), kind="driven")}
    model = kt.Model(nodes={"A": (0, 0), "B": (1, 0.3), "C": (0.5, -0.5)}, fixed={"A": "xy", "C": "xy"}, bars=bars)
    found = swept(model, kt.kinematics.assemble(model), ["jack"])
    start = math.hypot(0.5, 0.8)
    assert found.values[found.here, 0] == pytest.approx(start, abs=1e-12)
    np.testing.assert_allclose(found.values[[0, -1], 0], [0.6 * start, 1.5 * start], atol=1e-9)
    assert (np.diff(found.time) > 0).all()
    legs = {"boom": kt.Bar(ends=("A", "B"), kind="driven"), "jack": bars["jack"]}
    both = swept(model.with_(bars=legs), kt.kinematics.assemble(model), ["boom", "jack"])
    np.testing.assert_allclose(both.values[both.here], [math.hypot(1, 0.3), start], atol=1e-12)
    share = (both.values - both.values[both.here]) / (both.values[-1] - both.values[both.here])
    np.testing.assert_allclose(share[both.here :, 0], share[both.here :, 1], atol=1e-9)


def test_the_strength_along_a_motion_is_that_of_every_pose_by_itself():
    model = four_bar((0.1, 0.35, 0.3), 0.4)
    rod = {"section": kt.Rod(diameter=0.005)}
    own = {
        "crank": rod | {"material": "steel_s235"},
        "rod": {},
        "rocker": rod | {"material": kt.Material(E=2.1e11, density=7850)},
    }
    bars = {name: kt.Bar(ends=bar.ends, **own[name]) for name, bar in model.bars.items()}
    model = model.with_(bars=bars, loads={"F": kt.NodalForce(node="C", force=(100, 80))})
    found = swept(model, kt.kinematics.assemble(model), ["motor"], samples=37)
    header, arrays, _ = with_strength(film(found, model), model)
    assert header["judged"] == ["crank", "rod", "rocker"]
    used = arrays["used"]
    for k in range(0, len(found.time), 6):
        forces = at_rest(model, found.position[k])
        pose = strength_of(model, forces)[1]
        known = ~np.isnan(used[k])
        assert dict(zip(np.array(header["judged"])[known], used[k][known], strict=True)) == pytest.approx(pose)
        rules = utilisation(model, forces).utilisation.sel(part="crank").values
        assert pose["crank"] == pytest.approx(float(np.nanmax(rules)))
        # without a yield strength a bar is judged where it is pushed, and not where it is pulled: that is no use of 0 %
        assert ("rocker" in pose) == bool(forces.member_force.sel(member="rocker") < 0)
    assert np.isnan(used[:, 2]).any()
    assert (used[:, 2] > 0).any()
    assert np.isnan(used[:, 1]).all()  # no section
    bare, arrays, _ = with_strength(film(found, model), four_bar((0.1, 0.35, 0.3), 0.4))
    assert (bare["judged"], "used" in arrays) == ([], False)
    assert film(found, model)[0]["judged"] is None


def test_a_page_gets_the_motion_or_why_there_is_none_and_takes_over_a_pose_of_it():
    desk = Session(crank(), draw=True)

    def ask(**command) -> dict | bytes:
        return asked(desk, **command)

    header, arrays = unpacked(ask(do="sweep", drives=["motor"], rate="720 deg/s"))
    assert (header["kind"], header["whole"], header["revision"]) == ("sweep", True, desk.drawing.revision)
    assert arrays["time"][-1] == pytest.approx(0.5)
    assert "No drive called 'moter'" in ask(do="sweep", drives=["moter"])["message"]
    assert "No drive called 'moter'" in ask(do="sweep", drives=["moter"], rate="1 rpm")["message"]
    assert "has no drive" in ask(do="sweep", drives=[])["message"]
    assert "not an angular rate" in ask(do="sweep", drives=["motor"], rate="10 mm/s")["message"]
    assert "above 0" in ask(do="sweep", drives=["motor"], rate=-1)["message"]
    assert header["rate"] == pytest.approx(4 * math.pi)
    put = ask(do="put", values={"motor": math.radians(30)})
    np.testing.assert_allclose(put["places"][1], [0.2 * math.cos(math.radians(30)), 0.1], atol=1e-14)
    assert put["undo"] == "the other pose"
    loose = Session(crank().with_(drives={}), draw=True)
    assert "no drive" in asked(loose, do="sweep", drives=[])["message"]


def test_the_strength_of_a_motion_that_was_played_is_that_of_its_forces_and_nothing_else_is_computed_again(monkeypatch):
    rod = {"section": kt.Rod(diameter=0.005), "material": "steel_s235"}
    model = crank().with_(bars={"b": kt.Bar(ends=("A", "B"), **rod)})
    desk, moved = Session(model, draw=True), []
    monkeypatch.setattr("kinetruss.studio.films.sweeps.film", lambda *given: moved.append(given) or film(*given))

    def play(**command) -> tuple[dict, dict[str, np.ndarray]]:
        return unpacked(asked(desk, do="sweep", drives=["motor"], **command))

    header, bare = play()
    assert header["judged"] is None
    assert "used" not in bare
    header, shown = play(strength=True)
    assert (header["judged"], len(moved)) == (["b"], 1)
    found = swept(model, kt.kinematics.assemble(model), ["motor"])
    np.testing.assert_array_equal(shown["used"], with_strength(film(found, model), model).arrays["used"].astype("<f4"))
    for name, values in bare.items():
        np.testing.assert_array_equal(shown[name], values)
    assert "used" not in play()[1]  # off again
    for count, command in enumerate([{"rate": 3.0}, {"rate": 3.0, "at_speed": True}, {}], 2):
        play(**command, strength=True)
        assert len(moved) == count
    asked(desk, do="move", places={"B": [0, 0.3]})  # of another drawing everything is another one
    _, longer = play(strength=True)
    assert len(moved) == 5
    assert np.abs(longer["drive_force"]).max() == pytest.approx(30)
    assert longer["position"][0, 1].tolist() == pytest.approx([0, 0.3])


def test_a_pose_that_is_kept_leaves_springs_without_force_where_they_were():
    hinge, cable = (
        kt.Spring(coordinate=kt.AngleDrive("b"), stiffness=7.0),
        {"kind": "cable", "stiffness": 1e3, "pretension": 20.0},
    )
    model = crank().with_(
        nodes={"A": (0, 0), "B": (0, 0.2), "C": (0.5, 0)}, fixed={"A": "xy", "C": "xy"}, springs={"hinge": hinge}, loads={},
        bars={"b": ("A", "B"), "rope": kt.Bar(ends=("C", "B"), **cable)},
    )  # fmt: skip
    desk = Session(model, draw=True)
    angle, free = math.radians(120), math.hypot(0.5, 0.2) - 20 / 1e3
    answer = asked(desk, do="put", values={"motor": angle})
    tip = np.array([0.2 * math.cos(angle), 0.2 * math.sin(angle)])
    way = np.array([0.5, 0]) - tip
    pull = 1e3 * (np.linalg.norm(way) - free)
    assert answer["force"][1] == pytest.approx(pull, rel=1e-9)
    moment = pull * (tip[0] * way[1] - tip[1] * way[0]) / np.linalg.norm(way)
    (motor,) = answer["drives"]
    assert motor["force"] == pytest.approx(7.0 * (angle - math.pi / 2) - moment, rel=1e-9)
