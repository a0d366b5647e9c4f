"""What a mechanism does: paths, sweeps, ratios, dead points, transmission angles, quantities, in rows, pages and pictures."""

import json
import math

import numpy as np
import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss.cli import main
from kinetruss.report.mechanism_data import (
    dead_points,
    driver,
    member_turns,
    node_paths,
    path_length,
    quantity_rows,
    transmission_angles,
)
from kinetruss.report.run_figures import specifications

A, B, C, D = 0.1, 0.32, 0.25, 0.4
"""A crank-rocker."""


def crank_rocker(run=None, **more):
    """At the crank angle 0: coupler and rocker over the ground."""
    away, far = D - A, D - A
    turned = np.arccos((B**2 + far**2 - C**2) / (2 * B * away))
    joint = (A + B * np.cos(turned), B * np.sin(turned))
    trajectory = kt.ConstantRate(rates={"motor": 2 * np.pi}, duration=1.0)
    return kt.Model(
        nodes={"A": (0, 0), "B": (A, 0), "C": joint, "D": (D, 0)},
        fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("D", "C")},
        drives={"motor": kt.AngleDrive("crank")},
        runs={"turn": run or kt.Run(trajectory=trajectory, samples=361)},
        section=kt.Rod(diameter=0.01),
        material="steel_s235",
        **more,
    )


@pytest.fixture(scope="module")
def turn():
    return kt.run(crank_rocker())


def test_transmission_angles_of_a_four_bar_are_those_of_the_crank_along_the_ground(turn):
    """cos mu = (b^2 + c^2 - (d -+ a)^2)/(2 b c) at 0 and 180 degrees (Grashof; Hain 1967)."""
    ends = [math.acos((B**2 + C**2 - (D + s * A) ** 2) / (2 * B * C)) for s in (-1, 1)]
    acute = [min(one, math.pi - one) for one in ends]
    (row,) = transmission_angles(turn)
    assert (row["node"], row["member"], row["with"]) == ("C", "rocker", "coupler")
    assert row["least"] == pytest.approx(min(acute), abs=1e-12)
    assert row["largest"] == pytest.approx(math.pi / 2, abs=0.01)


def test_a_rocker_stands_where_crank_and_coupler_are_on_one_line(turn):
    """Its sweep and its dead points: the triangles of b + a and of b - a with c and d."""
    (row,) = member_turns(turn, ["rocker"])
    stretched, folded = (math.acos((C**2 + D**2 - (B + s * A) ** 2) / (2 * C * D)) for s in (1, -1))
    assert row["sweep"] == pytest.approx(stretched - folded, abs=1e-4)
    first, second = sorted(row["dead"])
    outer = math.acos(((B + A) ** 2 + D**2 - C**2) / (2 * (B + A) * D))
    inner = math.acos(((B - A) ** 2 + D**2 - C**2) / (2 * (B - A) * D)) + math.pi
    assert 2 * math.pi * first == pytest.approx(outer, abs=1e-6)
    assert 2 * math.pi * second == pytest.approx(inner, abs=1e-6)


def test_the_ratio_is_that_of_the_sines(turn):
    """q'/d' = a sin(coupler - crank)/(c sin(coupler - rocker)); its inverse is the mechanical advantage."""
    found = kt.kinematics.quantities(
        turn.model, turn.motion, {"t": "angle(crank)", "b": "angle(coupler)", "r": "angle(rocker)"}
    )
    t, b, r = found.value.values.T
    ratio = A * np.sin(b - t) / (C * np.sin(b - r))
    (row,) = member_turns(turn, ["rocker"])
    np.testing.assert_allclose(row["ratio"], [ratio.min(), ratio.max()], rtol=1e-12)
    assert row["advantage"] == pytest.approx(1 / ratio[np.abs(ratio).argmax()], rel=1e-12)


def test_torques_on_output_and_drive_are_in_the_ratio_of_the_mechanical_advantage():
    """A couple on the rocker of a mechanism without mass is held by the drive: F d' = -M q'."""
    model = crank_rocker(gravity=(0, 0), loads={"M": kt.MemberCouple(member="rocker", moment=12.0)})
    light = model.with_(material=kt.Material(E=210e9, density=0.0))
    run = kt.run(light)
    series = kt.kinematics.quantities(light, run.motion, {"k": "rate(angle(rocker))/rate(motor)"}).value[:, 0].values
    torque = run.forces["all"].drive_force.sel(drive="motor").values
    np.testing.assert_allclose(torque, -12.0 * C * series, atol=1e-10)


def test_paths_have_the_length_and_extremes_of_a_circle(turn):
    (row,) = node_paths(turn, ["B"])
    assert row["path"] == pytest.approx(2 * math.pi * A, rel=1e-12)
    assert row["speed"] == pytest.approx(2 * math.pi * A, rel=1e-12)
    assert row["acceleration"] == pytest.approx(4 * math.pi**2 * A, rel=1e-12)
    np.testing.assert_allclose([row["least"], row["largest"]], [[-A, -A], [A, A]], atol=1e-12)


@pytest.mark.parametrize("count", [20, 40])
def test_the_length_of_a_path_converges_with_the_fourth_order(count):
    """The ellipse with the half-axes 2 and 1."""

    def off(samples):
        t = np.linspace(0, 1.3, samples + 1)
        v, a = np.stack([-2 * np.sin(t), np.cos(t)], axis=1), np.stack([-2 * np.cos(t), -np.sin(t)], axis=1)
        fine = np.linspace(0, 1.3, 200001)
        whole = np.trapezoid(np.hypot(2 * np.sin(fine), np.cos(fine)), fine)
        return abs(path_length(t, v, a) - whole)

    assert off(count) / off(2 * count) == pytest.approx(16, rel=0.1)


def test_a_path_through_a_point_of_rest_has_its_whole_length():
    t = np.linspace(0, 2 * math.pi, 401)
    v, a = np.stack([-np.sin(t), 0 * t], axis=1), np.stack([-np.cos(t), 0 * t], axis=1)
    assert path_length(t, v, a) == pytest.approx(4.0, rel=1e-4)


def test_dead_points_are_roots_between_samples_and_not_where_the_drive_rests():
    t = np.linspace(0, 1, 11)
    found = dead_points(t, np.cos(5 * t), -5 * np.sin(5 * t), np.ones(11))
    np.testing.assert_allclose(found, [math.pi / 10, 3 * math.pi / 10], atol=1e-4)
    rate = np.where(t < 0.5, np.nan, 1.0)
    np.testing.assert_allclose(dead_points(t, np.cos(5 * t), -5 * np.sin(5 * t), rate), [3 * math.pi / 10], atol=1e-4)


def test_a_slider_crank_has_the_force_on_the_slider_and_its_transmission_angle():
    model = kt.library.mechanisms.slider_crank(crank=0.1, rod=0.3, angle=0.0)
    run = kt.Run(trajectory=kt.ConstantRate(rates={"motor": 2 * np.pi}, duration=1.0), samples=361)
    found = kt.run(model.with_(runs={"turn": run}), "turn")
    assert driver(found) == "motor"
    (row,) = [one for one in transmission_angles(found) if one["node"] == "S"]
    # the rod is most inclined with the crank across the line
    assert row["least"] == pytest.approx(math.pi / 2 - math.asin(0.1 / 0.3), abs=1e-12)
    assert row["largest"] == pytest.approx(math.pi / 2, abs=1e-12)


def test_two_drives_or_a_simulation_give_no_ratio():
    arms = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (2, 0)}, bars={"one": ("A", "B"), "two": ("B", "C")}, fixed=["A"],
        drives={"a": kt.AngleDrive("one"), "b": kt.AngleDrive("two")},
        runs={"both": kt.Run(trajectory=kt.ConstantRate(rates={"a": 1.0, "b": 3.0}, duration=1.0), samples=11)},
    )  # fmt: skip
    found = kt.run(arms)
    assert driver(found) == ""
    assert "ratio" not in member_turns(found, ["two"])[0]
    assert transmission_angles(found) == []


LIMITED = {
    "swing": {"value": "angle(rocker)", "limits": ["60 deg", "180 deg"]},
    "height": {"value": "C.y", "limits": [None, "200 mm"], "words": "of the joint"},
    "free": "angle(coupler)",
}


def test_limits_of_quantities_are_part_of_the_verdict():
    run = kt.run(crank_rocker(quantities=LIMITED))
    rows = {row["quantity"]: row for row in quantity_rows(run)}
    height = run.motion.position.sel(node="C", axis="y").values
    assert rows["height"]["largest"] == height.max()
    assert rows["height"]["largest_time"] == run.motion.time.values[height.argmax()]
    assert (rows["height"]["status"], rows["swing"]["status"], rows["free"]["status"]) == ("exceeded", "kept", "")
    over = next(one for one in run.finding.quantities if one.part == "height")
    assert over.utilisation == pytest.approx(height.max() / 0.2, rel=1e-12)
    swing = next(one for one in run.finding.quantities if one.part == "swing")
    angle = run.quantities["all"].value.sel(quantity="swing").values
    assert swing.utilisation == pytest.approx(np.abs(np.degrees(angle) - 120).max() / 60, rel=1e-12)
    assert run.finding.state == "over"
    assert run.finding.kind == "quantity"
    assert run.finding.sentence.startswith("Beyond a limit; height, limit: 12")
    page = kt.report.document_page(run)
    assert any("height is" in one and "beyond its limit of 200 mm" in one for one in page.record["warnings"])
    assert "Quantities of the model" in page.html
    within = kt.run(crank_rocker(quantities={"swing": LIMITED["swing"]}))
    assert within.finding.state == "ok"


def test_a_value_that_is_not_known_leaves_its_limits_open():
    rest = kt.Run(trajectory=kt.Quintic(moves={"motor": (0.0, 1.0)}, duration=1.0), samples=21)
    model = crank_rocker(rest, quantities={"k": {"value": "rate(angle(rocker))/rate(motor)", "limits": [-5, 5]}})
    run = kt.run(model)
    assert run.finding.state == "open"
    assert "k not checked: its value is not known at 2 of 21 samples" in run.finding.sentence
    assert any("not known at 2 of 21 samples" in one for one in kt.report.document_page(run).record["warnings"])


def test_a_mission_says_that_it_did_not_check_them():
    runs = {"all": kt.Run(analysis="mission", motions=["turn"])}
    model = crank_rocker(quantities=LIMITED)
    finding = kt.run(model.with_(runs={**model.runs, **runs}), "all").finding
    assert finding.state == "open"
    assert any(one.startswith("swing not checked: a mission has no histories") for one in finding.more)


def test_statics_has_the_quantities_of_each_load_case():
    truss = kt.Model(
        nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
        loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
        load_cases={"once": {"loads": {"hook": 1}}, "twice": {"loads": {"hook": 2}}},
        quantities={"sag": {"value": "-C.y", "limits": [None, "0.05 mm"]}},
        runs={"still": kt.Run(analysis="statics.linear", load_cases=["once", "twice"])},
    )  # fmt: skip
    run = kt.run(truss, "still")
    found = {case: one.value.values.item() for case, one in run.quantities.items()}
    for case, linear in run.statics.items():
        assert found[case] == pytest.approx(-linear.whole["displacement"].sel(node="C", axis="y").item(), rel=1e-12)
    assert found["twice"] == pytest.approx(2 * found["once"], rel=1e-12)
    assert [row["load_case"] for row in quantity_rows(run)] == ["once", "twice"]
    assert run.finding.quantities[0].load_case == "twice"


def test_pictures_of_a_mechanism(turn):
    names = [one.name for one in specifications(turn)]
    assert {"turning", "paths", "speeds", "drives"} <= set(names)
    whole = next(one for one in specifications(turn) if one.name == "paths")
    assert "B" in whole.title and len(whole.ways) == 2
    drives = next(one for one in specifications(turn) if one.name == "drives")
    assert [panel.quantity for panel in drives.panels] == ["torque", "power"]


def test_a_shape_after_a_full_turn_shows_the_extremes_of_the_motion():
    wiper = kt.run(kt.read(kt.library.example_files()["wiper"][0]))
    shape = specifications(wiper)[0]
    captions = [one.caption for one in shape.stands]
    assert len(set(captions)) == 3
    times = [float(one.split()[2]) for one in captions]
    (row,) = member_turns(wiper, ["arm1"])
    # the arm stands at the ends of its sweep
    for dead in row["dead"]:
        assert min(abs(dead - one) for one in times) < 0.01
    assert math.degrees(row["sweep"]) == pytest.approx(89.32, abs=0.01)


@pytest.fixture(scope="module")
def stored(tmp_path_factory):
    path = tmp_path_factory.mktemp("run") / "turn"
    kt.run(crank_rocker(quantities=LIMITED), out=path)
    return path


def said(*words, code=0):
    done = CliRunner().invoke(main, [str(one) for one in words])
    assert done.exit_code == code, done.output
    return done.output


def test_info_tells_where_a_node_goes_and_how_a_member_turns(stored):
    text = said("info", stored, "--node", "B", "--member", "rocker")
    for words in (
        "Node B",
        "628.3 mm",
        "Member rocker",
        "sweep",
        "dead points",
        "transmission angle at C",
    ):
        assert words in text
    found = json.loads(said("info", stored, "--node", "B", "--json"))
    assert found["schema"] == "kinetruss.motion/1"
    assert found["nodes"][0]["path"] == pytest.approx(2 * math.pi * A)
    whole = said("info", stored, "--motion")
    for words in ("Nodes that move", "Members that turn", "Transmission angles", "Quantities of the model"):
        assert words in whole
    assert "Quantities of the model" in said("info", stored)
    assert "Did you mean 'rocker'" in said("info", stored, "--member", "rockr", code=2)
    assert "go with --joints" in said("info", stored, "--axis", "x", code=2)


def test_plot_draws_nodes_and_quantities(stored, tmp_path):
    written = said("plot", stored, "--node", "C").split()
    assert [one.rpartition("/")[2] for one in written] == ["path_C.png", "path_C.svg", "motion_C.png", "motion_C.svg"]
    for name in ("swing", "quantity_rate", "angle"):
        said("plot", stored, "--quantity", name, "-o", tmp_path / f"{name}.svg")
    assert "Did you mean 'swing'" in said("plot", stored, "--quantity", "swng", "-o", tmp_path / "no.svg", code=2)


def test_export_has_the_quantities(stored, tmp_path):
    said("export", stored, tmp_path / "q.csv", "--group", "quantities")
    head, first = (tmp_path / "q.csv").read_text().splitlines()[:2]
    assert head.split(",")[:3] == ["time (s)", "quantities.value[swing] (rad)", "quantities.value[height] (m)"]
    assert float(first.split(",")[2]) == kt.runs.load(stored).quantities["all"].value.values[0, 1]
    said("export", stored, tmp_path / "all.csv")
    assert "quantities.rate[swing] (rad/s)" in (tmp_path / "all.csv").read_text().splitlines()[0]


def test_the_page_of_a_run_has_its_quantities(stored):
    scene = kt.viewer.scene(kt.runs.load(stored))
    assert [one["name"] for one in scene.header["quantities"]] == list(LIMITED)
    assert scene.header["quantities"][1]["limits"] == [None, 0.2]
    np.testing.assert_array_equal(scene.arrays["quantity"], kt.runs.load(stored).quantities["all"].value)


def test_the_check_of_the_energy_says_whose_the_largest_power_is(stored):
    run = kt.runs.load(stored)
    text = kt.report.summary(run).text
    line = next(one for one in text.splitlines() if one.startswith("energy balance"))
    forces = run.forces["all"]
    power = np.abs(forces.drive_force * run.motion.drive_velocity).max().item()
    assert kt.report.summary(run).record["checks"]["energy_balance"]["largest_power"] == pytest.approx(power)
    assert "that of drive motor" in line


def test_drives_have_rms_and_the_instant_of_their_largest_power(stored):
    run = kt.runs.load(stored)
    (row,) = kt.report.summary(run).record["drive_loads"]
    torque, time = run.forces["all"].drive_force.values[:, 0], run.motion.time.values
    assert row["rms"] == pytest.approx(math.sqrt(np.trapezoid(torque**2, time)))
    power = np.abs(torque * 2 * math.pi)
    assert power[time == row["power_time"]].item() == pytest.approx(power.max(), rel=1e-12)
    assert abs(row["power"]) == pytest.approx(power.max(), rel=1e-12)


def test_a_leg_walks_along_a_level_line():
    """While the foot is on the ground, below 10 mm from its lowest place, it goes 0.5 m at least."""
    run = kt.run(kt.read(kt.library.example_files()["jansen_leg"][0]))
    foot = run.motion.position.sel(node="F").values
    low = foot[:, 1] < foot[:, 1].min() + 0.01
    assert np.ptp(foot[low, 0]) > 0.5
    assert np.ptp(foot[:, 1]) > 0.2
    found = run.quantities["all"]
    np.testing.assert_allclose(found.value.sel(quantity="foot_speed"), np.hypot(*run.motion.velocity.sel(node="F").values.T))
    np.testing.assert_allclose(
        found.value.sel(quantity="advance"), run.motion.velocity.sel(node="F", axis="x") / (-2 * math.pi), rtol=1e-10
    )


def test_camber_toe_and_roll_centre_of_a_double_wishbone():
    """Against the axis of the wheel from positions, and the roll centre by the plane's own geometry of the arms."""
    run = kt.run(kt.read(kt.library.example_files()["double_wishbone"][0]))
    found, x = run.quantities["all"].value, run.motion.position
    axis = (x.sel(node="S") - x.sel(node="W")).values
    np.testing.assert_allclose(found.sel(quantity="camber"), -np.arcsin(axis[:, 2] / np.linalg.norm(axis, axis=1)), atol=1e-12)
    np.testing.assert_allclose(found.sel(quantity="toe"), np.arctan2(axis[:, 0], axis[:, 1]), atol=1e-12)

    def line(ball, front, rear, at):
        """Ball joint, and the pins' axis in the plane x = at, without x."""
        p, q, r = (x.sel(node=name).values[0] for name in (ball, front, rear))
        pin = q + (r - q) * (at - q[0]) / (r[0] - q[0])
        return p[1:], pin[1:]

    at = x.sel(node="W", axis="x").values[0]
    (a, b), (c, d) = line("LB", "LF", "LR", at), line("UB", "UF", "UR", at)
    s, _ = np.linalg.solve(np.stack([b - a, c - d], axis=1), c - a)
    y, z = a + s * (b - a)
    contact = x.sel(node="G").values[0]
    first = found.isel(time=0)
    np.testing.assert_allclose([first.sel(quantity="centre_y"), first.sel(quantity="centre_z")], [y, z], rtol=1e-10)
    height = -contact[1] * (z - contact[2]) / (y - contact[1])
    np.testing.assert_allclose(first.sel(quantity="roll_centre"), height, rtol=1e-10)
    ratio = found.sel(quantity="motion_ratio").values[1:-1]
    strut = run.motion.length_rate.sel(member="strut")[1:-1] / run.motion.velocity.sel(node="W", axis="z")[1:-1]
    np.testing.assert_allclose(ratio, -strut, rtol=1e-9)


def test_links_turn_and_transmit_as_bars_do(turn):
    """Coupler and rocker as links; a third pin leaves the angle, and no one direction in which the link transmits."""
    tip = {"P": (D + 2.0 * (turn.model.nodes["C"].at[0] - D), 2.0 * turn.model.nodes["C"].at[1])}
    with_bars = turn.model
    linked = with_bars.with_(bars={"crank": with_bars.bars["crank"]}, links={"coupler": ("B", "C"), "rocker": ("D", "C")})
    longer = linked.with_(nodes={**with_bars.nodes, **tip}, links={"coupler": ("B", "C"), "rocker": ("D", "C", "P")})
    expected = {row["member"]: row for row in member_turns(turn)}
    for model in (linked, longer):
        run = kt.run(model)
        for row in member_turns(run):
            assert row["sweep"] == pytest.approx(expected[row["member"]]["sweep"], abs=1e-9)
            assert row.get("ratio") == pytest.approx(expected[row["member"]].get("ratio"), abs=1e-9)
    (one,), (other,) = transmission_angles(kt.run(linked)), transmission_angles(turn)
    assert (one["node"], one["member"], one["with"]) == ("C", "rocker", "coupler")
    assert one["least"] == pytest.approx(other["least"], abs=1e-9)
    assert transmission_angles(run) == []
