"""The page that a run is read from."""

import json

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report
from kinetruss.errors import InputError
from kinetruss.report import curves
from kinetruss.runs import RunResult, run


def test_the_page_names_the_worst(lift):
    text = report.summary(lift).text
    assert "Completed." in text
    worst = lift.verdict.table()[0]
    assert text.index("Worst members") < text.index(worst.part, text.index("Worst members"))
    for word in ("margin", "load case", "pushed", "voltage", "energy balance", "singularity", "unique forces       all"):
        assert word in text


def test_the_page_as_data_is_plain_json(lift):
    record = json.loads(json.dumps(report.summary(lift).record, allow_nan=False))
    assert record["whole"] is True
    assert record["samples"] == {"asked": 41, "good": 41}
    assert record["worst"][0]["utilisation"] == pytest.approx(float(lift.verdict.utilisation.max()))
    assert record["checks"]["energy_balance"]["relative"] < 1e-9
    assert {motor["active"] for motor in record["motors"]} == {"LA", "LB", "LC"}


def test_the_largest_force_is_the_largest(lift):
    first = report.summary(lift).record["largest_forces"][0]
    everywhere = np.concatenate([forces.member_force.values.ravel() for forces in lift.forces.values()])
    assert abs(first["force"]) == np.abs(everywhere).max()


@pytest.mark.slow
def test_of_many_motors_those_nearest_to_a_limit_are_shown():
    """Twelve of the 120 rows of sixty motors in two load cases; the record has all."""
    model = kt.read(kt.library.example_files()["mast"][0])
    page = report.summary(run(model.with_(runs={"deploy": model.runs["deploy"].with_(samples=11)})))
    motors, trains = (page.text.split(head)[1].split("\n\n")[0] for head in ("Motors (", "Drive trains ("))
    assert len(page.record["motors"]) == 120
    assert motors.endswith("and 108 more, farther from their limits")
    assert trains.endswith("and 108 more, with less torque")
    shown = [line.split()[0] for line in trains.splitlines()[2:-1]]
    torques = sorted(page.record["trains"], key=lambda one: -one["motor_torque"])
    assert shown == [one["active"] for one in torques[:12]]
    assert motors.splitlines()[2].split()[0] == shown[0]  # all use the same stroke: the most loaded comes first


def test_drives_without_a_motor_are_listed_in_their_units(turn, lift):
    (row,) = report.summary(turn).record["drive_loads"]
    torque = next(iter(turn.forces.values())).data["drive_force"].values[:, 0]
    at = int(np.abs(torque).argmax())
    assert (row["drive"], row["unit"], row["load"]) == ("motor", "N m", torque[at])
    assert row["time"] == turn.motion.data["time"].values[at]
    power = torque * turn.motion.data["drive_velocity"].values[:, 0]
    assert row["power"] == power[np.abs(power).argmax()]
    text = report.summary(turn).text
    assert "Drives without a motor (largest values of the motion)" in text
    assert "N m " in text.split("Drives without a motor (")[1].splitlines()[2]
    # members with a screw stand in the table of motors
    assert not report.summary(lift).record["drive_loads"]


@pytest.fixture(scope="module")
def door_run() -> RunResult:
    """A door without a motor at one hinge, one fed by a motor at another, in a simulation."""
    motor = kt.Motor(inertia=2e-5, resistance=1.3, torque_constant=0.06, emf_constant=0.06)
    hinge = kt.HingeDrive(axis=("A", "B"), start="D", end="C")
    tasks = {
        "turn": kt.Quintic(moves={"turn": ("90 deg", "130 deg")}, duration=0.2),
        "leaf": kt.PositionLoop(target="30 deg", settling_time=0.1),
    }
    return run(kt.Model(
        nodes={"A": (0, 0, 0), "B": (0, 0, 1), "C": kt.Node(at=(0.9, 0, 0.3), mass=2.0), "D": (0, -1, 0),
               "E": kt.Node(at=(0.9, 0.1, 0.8), mass=0.3)},
        fixed=["A", "B", "D"],
        bars={"low": kt.Bar(ends=("A", "C"), mass=0), "high": kt.Bar(ends=("B", "C"), mass=0),
              "one": kt.Bar(ends=("C", "E"), mass=0), "two": kt.Bar(ends=("B", "E"), mass=0)},
        drives={"turn": hinge, "leaf": kt.HingeDrive(axis=("C", "B"), start="A", end="E", gear=kt.Gear(ratio=30), motor=motor)},
        runs={"go": kt.Run(analysis="dynamics.simulate", t_end=0.2, samples=21, tasks=tasks)},
    ))  # fmt: skip


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_torques_and_angles_of_hinges_are_printed_and_drawn_in_their_units(door_run):
    (row,) = report.summary(door_run).record["drive_loads"]
    assert (row["drive"], row["kind"], row["unit"]) == ("turn", "hinge", "N m")
    assert abs(row["load"]) == pytest.approx(np.abs(door_run.forces["all"].drive_force.sel(drive="turn")).max().item())
    text = report.summary(door_run).text
    assert [line for line in text.splitlines() if line.startswith("turn ") and "N m " in line and " rad/s " in line]
    (motor,) = report.summary(door_run).record["motors"]
    assert motor["active"] == "leaf"
    assert motor["current"] == pytest.approx(
        door_run.simulation.motor_current.values[np.abs(door_run.simulation.motor_current.values).argmax()].item(), rel=1e-6
    )
    (fed,) = report.summary(door_run).record["simulation"]["motors"]
    assert (fed["motor"], fed["turned"]) == ("leaf", door_run.simulation.motor_angle.values[-1, 0])
    assert fed["electrical_energy"] == door_run.simulation.electrical_energy.values[-1, 0]
    assert fed["copper_energy"] > 0
    rows = text.partition("Motors of the simulation")[2].partition("\n\n")[0].splitlines()
    assert [line for line in rows if line.startswith("leaf ") and " A " in line and " deg " in line]
    for quantity, unit in (("drive_position", "rad"), ("drive_velocity", "rad/s"), ("drive_force", "N m")):
        assert {curve.unit for curve in curves(door_run, quantity)} == {unit}
    for quantity, unit in (("motor_current", "A"), ("motor_angle", "rad"), ("motor_speed", "rad/s")):
        (curve,) = curves(door_run, quantity, ["leaf"])
        assert (curve.unit, len(curve.values)) == (unit, 21)
    assert {one["unit"] for one in report.document_page(door_run).record["drives"]} == {"rad"}
    assert "Drives without a motor" in report.document_page(door_run).html


def test_joint_forces_balance_at_a_pin(turn):
    found = report.joints(turn, node="B").found
    assert [row[:3] for row in found.rows] == [("crank", "B", "B"), ("coupler", "A", "B")]
    assert found.supports == ()
    np.testing.assert_allclose(found.rows[0][3] + found.rows[1][3], 0, atol=1e-9 * np.abs(found.rows[0][3]).max())


def test_supports_carry_what_their_members_get(turn):
    found = report.joints(turn, node="A", time=0.2).found
    assert found.time == pytest.approx(0.2, abs=0.01)
    np.testing.assert_allclose(found.rows[0][3], found.supports[0][1], rtol=1e-9)


def test_member_axes_turn_with_the_member(lift):
    found = report.joints(lift, member="LA", time=0.5, case="pushed").found
    forces = lift.forces["pushed"].data.sel(member="LA").sel(time=found.time, method="nearest")
    tension = forces["end_force"].values
    (_, _, _, world_a, local_a), (_, _, _, world_b, local_b) = found.rows
    np.testing.assert_allclose([-local_a[0], local_b[0]], tension, rtol=1e-12)
    for world, local in ((world_a, local_a), (world_b, local_b)):
        assert np.linalg.norm(world) == pytest.approx(np.linalg.norm(local), rel=1e-12)


def test_joint_forces_by_axis_and_as_text(lift):
    page = report.joints(lift, node="T", axis="z")
    assert page.found.axes == ("z",)
    text = page.text
    assert len(text.splitlines()) == 6
    record = report.joints(lift).record
    assert len(record["joint_force"]) == 6
    assert len(record["reaction"]) == 3


@pytest.mark.parametrize(
    ("what", "message"),
    [
        ({"member": "LX"}, "No member called 'LX'. There are: LA, LB, LC"),
        ({"node": "Z"}, "No node called 'Z'"),
        ({"case": "storm"}, "No load case called 'storm'. There are: standing, pushed"),
        ({"time": float("nan")}, "time is nan"),
    ],
)
def test_unknown_names_are_offered_the_known(lift, what, message):
    with pytest.raises(InputError, match=message):
        report.joints(lift, **what)


def test_a_stroke_never_hides_behind_many_other_limits(lift, monkeypatch):
    from kinetruss import actuators
    from kinetruss.actuators import Exceeded

    def one(quantity: str, value: float) -> Exceeded:
        return Exceeded(active="LA", quantity=quantity, start=0.1, end=0.2, time=0.15, value=value, limit=1.0, unit="")

    found = [one("torque", 2 + k) for k in range(20)] + [one("stroke", 1.01), one("current", 1.5)]
    monkeypatch.setattr(actuators, "exceeded", lambda demand: found)
    told = report.summary(lift).record["exceeded"]
    assert [entry["quantity"] for entry in told[:3]] == ["torque", "current", "stroke"]
    assert [entry["value"] for entry in told[3:5]] == [21, 20]  # two load cases: then the worst first
    text = report.summary(lift).text
    assert "LA: stroke from the middle between its limits too high" in text
    assert "more: torque" in text


@pytest.mark.slow
def test_bars_that_stand_for_a_body_are_no_largest_forces():
    """A plate on a hinge, and a rod that hangs from its edge."""
    nodes = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0.5, 1, 0), "E": (0.5, 1, -1)}
    found = run(
        kt.Model(
            title="plate", nodes=nodes, fixed=["A", "B"], bodies={"plate": kt.Body(nodes=("A", "B", "C"), mass=5.0)},
            bars={"rod": kt.Bar(ends=("C", "E"), mass=0.5)}, gravity=(0, 0, -9.81),
            runs={"fall": kt.Run(analysis="dynamics.simulate", t_end=0.05, samples=5)},
        ),
        "fall",
    )  # fmt: skip
    assert len(found.model.whole.inner.bars) == 2
    assert {one["member"] for one in report.summary(found).record["largest_forces"]} == {"rod"}
