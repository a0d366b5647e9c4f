"""Section forces of bars that are driven, pinned, loaded or heavy between their ends, against the sums done by hand."""

import numpy as np
import pytest

import kinetruss as kt

G = 9.81
STEEL = {"section": kt.Rectangle(width=0.02, height=0.02), "material": kt.library.materials.STEEL_S235}
ALL = np.linspace(0, 1, 41)


def at_rest(model, stations=ALL):
    return kt.strength.sections(model, kt.statics.at_poses(model, [{}]), stations)


def bending(found, part):
    """Size of the bending moment at every station, N m."""
    return np.linalg.norm(np.atleast_2d(found.section_M.sel(part=part).values[0].T), axis=0)


@pytest.mark.slow
@pytest.mark.parametrize("ends", [("O", "A"), ("A", "O")])
@pytest.mark.parametrize("how", ["angle", "hinge", "hinge turned round", "geared"])
def test_a_cantilever_that_a_motor_holds(ends, how):
    """M = w (L - x)^2/2 + P (L - x) from the wall, whichever end is the first and whatever holds it."""
    L, m, P = 1.3, 4.0, 25.0
    drive = {
        "angle": kt.AngleDrive("crank"),
        "hinge": kt.HingeDrive(axis="O", start="G", end="A"),
        "hinge turned round": kt.HingeDrive(axis="O", start="A", end="G"),
        "geared": kt.AngleDrive("wheel"),
    }[how]
    model = kt.Model(
        nodes={"O": (0, 0), "A": (L, 0), "G": (0, -1)}, fixed=["O", "G"], gravity=(0, -G),
        bars={"crank": kt.Bar(ends=ends, mass=m)}, loads={"tip": kt.NodalForce(node="A", force=(0, -P))}, **STEEL,
        drives={} if how == "geared" else {"motor": drive},
    )  # fmt: skip
    if how == "geared":
        mesh = kt.Coupling(terms=((kt.AngleDrive("crank"), 3.0), (drive, -1.0)))
        model = model.with_(
            nodes=dict(model.nodes) | {"W": (0.1, -1)}, bars=dict(model.bars) | {"wheel": kt.Bar(ends=("G", "W"), mass=0)},
            couplings={"mesh": mesh}, drives={"motor": drive},
        )  # fmt: skip
    x = (ALL if ends[0] == "O" else 1 - ALL) * L
    np.testing.assert_allclose(bending(at_rest(model), "crank"), m * G / L * (L - x) ** 2 / 2 + P * (L - x), atol=1e-9)
    row = next(row for row in kt.strength.check(model, kt.statics.at_poses(model, [{}])).table() if row.part == "crank")
    # at the wall, with the mean shear of a rectangle counted where it is largest: the corner governs
    assert row.value == pytest.approx((m * G * L / 2 + P * L) / (0.02**3 / 6), rel=1e-9)
    assert row.position == pytest.approx(0.0 if ends[0] == "O" else L, abs=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("reach", [0.0, 0.35, -0.4, 1.3])
def test_a_door_about_a_slanted_or_upright_axis(reach):
    """Both bars of a panel lean out from the axis: the motor's couple is in them, in the shares of the foot of the far node."""
    w, m = 0.8, 5.0
    model = kt.Model(
        nodes={"A": (0, 0, 0), "B": (0, 1, 0), "S": (0, 0, -1), "C": kt.Node(at=(w, reach, 0), mass=m)}, fixed=["A", "B", "S"],
        bars={"a": kt.Bar(ends=("A", "C"), mass=0), "b": kt.Bar(ends=("C", "B"), mass=0)}, gravity=(0, 0, -G),
        drives={"turn": kt.HingeDrive(axis=("A", "B"), start="S", end="C")}, **STEEL,
    )  # fmt: skip
    forces = kt.statics.at_poses(model, [{}])
    assert abs(forces.drive_force.values.item()) == pytest.approx(m * G * w)
    found = kt.strength.sections(model, forces, ALL)
    far = {"a": np.hypot(w, reach), "b": np.hypot(w, 1 - reach)}
    share = {"a": abs(1 - reach), "b": abs(reach)}
    np.testing.assert_allclose(bending(found, "a"), share["a"] * m * G * far["a"] * (1 - ALL), atol=1e-9)
    np.testing.assert_allclose(bending(found, "b"), share["b"] * m * G * far["b"] * ALL, atol=1e-9)
    # as vectors the two couples at the axis make the torque about it and nothing else
    total = forces.action_couple.values[0].sum(axis=0)
    np.testing.assert_allclose(np.abs(total), [0, m * G * w, 0], atol=1e-9)


@pytest.mark.parametrize("kind", ["coordinates", "node", "offset"])
def test_scissor_arms_with_a_pin_in_the_middle(kind):
    """A load P on one end of an arm whose other end stands on a roller: the pin bends it, by P w/2 in the middle."""
    P, w, h = 900.0, 1.2, 0.9
    nodes = {"A": (0, 0), "B": (w, 0), "C": (w, h), "D": (0, h)}
    bars = {"ac": kt.Bar(ends=("A", "C"), mass=0)}

    def pin(names, factors):
        return {
            f"pin.{axis}": kt.Coupling(
                terms=tuple((kt.CoordinateDrive(node=n, axis=axis), f) for n, f in zip(names, factors, strict=True))
            )
            for axis in "xy"
        }

    if kind == "coordinates":
        bars |= {"bd": kt.Bar(ends=("B", "D"), mass=0)}
        couplings = pin("ACBD", (0.5, 0.5, -0.5, -0.5))
    else:
        nodes["P"] = (w / 2, h / 2)
        bars |= {"bp": kt.Bar(ends=("B", "P"), mass=0), "pd": kt.Bar(ends=("P", "D"), mass=0)}
        couplings = pin("PAC", (1.0, -0.5, -0.5))
        angle, offset = kt.HingeDrive(axis="P", start="B", end="D"), kt.OffsetCoordinate(line=("B", "D"), point="P")
        couplings["straight"] = kt.Coupling(terms=((angle if kind == "node" else offset, 1.0),))
    model = kt.Model(
        nodes=nodes, bars=bars, couplings=couplings, fixed={"A": "xy", "B": "y"}, **STEEL,
        drives={"b": kt.CoordinateDrive(node="B", axis="x")}, loads={"down": kt.NodalForce(node="D", force=(0, -P))},
    )  # fmt: skip
    forces = kt.statics.at_poses(model, [{}])
    found = kt.strength.sections(model, forces, ALL)
    # D is on arm bd alone, half of w beside the pin
    peak = P * w / 2
    if kind == "coordinates":
        np.testing.assert_allclose(bending(found, "bd"), peak * (1 - np.abs(2 * ALL - 1)), atol=1e-8)
    else:
        np.testing.assert_allclose(bending(found, "bp"), peak * ALL, atol=1e-8)
        np.testing.assert_allclose(bending(found, "pd"), peak * (1 - ALL), atol=1e-8)
    # nothing is on C, so arm ac takes no force across at its free end, and none from A but along it
    np.testing.assert_allclose(bending(found, "ac"), 0.0, atol=1e-8)
    verdict = kt.strength.check(model, forces)
    stress = max(row.value for row in verdict.table() if row.rule == "yield")
    assert peak / (0.02**3 / 6) < stress < 1.05 * peak / (0.02**3 / 6)
    assert not verdict.message


def test_a_mass_clamped_on_a_bar():
    """M grows to m g a b/L at the clamp; with inertia of its own and off the axis it twists the bar there."""
    L, a, m, f = 2.0, 0.71, 3.0, 0.25  # between two stations: at a jump rounding decides
    plain = kt.Model(
        nodes={"O": (0, 0), "A": (L, 0)}, fixed={"O": "xy", "A": "y"}, gravity=(1.5, -G), **STEEL,
        bars={"beam": kt.Bar(ends=("O", "A"), mass=0)},
    )  # fmt: skip
    clamp = kt.Body(nodes=("A", "O"), mass=m, center=(a, f), inertia=0.4)
    found = at_rest(plain.with_(bodies={"clamp": clamp}))
    couple = -m * 1.5 * f  # of the weight m (1.5, -G), f above the axis
    lift = (m * G * (L - a) + couple) / L
    x = ALL * L
    wanted = lift * x - np.where(x > a + 1e-9, m * G * (x - a) + couple, 0)
    np.testing.assert_allclose(np.abs(found.section_M.sel(part="beam").values[0, :, 0]), np.abs(wanted), atol=1e-9)
    np.testing.assert_allclose(found.section_T.sel(part="beam").values[0], np.where(x > a + 1e-9, 0, m * 1.5), atol=1e-9)
    spread = at_rest(plain.with_(bodies={"cover": kt.Body(nodes=("O", "A"), mass=m)}))
    own = at_rest(plain.with_(bars={"beam": kt.Bar(ends=("O", "A"), mass=m)}))
    for name in ("section_T", "section_V", "section_M"):
        np.testing.assert_allclose(spread.data[name].values, own.data[name].values, atol=1e-9)


def test_loads_on_a_bar_act_where_they_are():
    L, F, p, b, M = 1.6, 50.0, 2000.0, 0.05, 7.0
    base = kt.Model(
        nodes={"O": (0, 0), "A": (L, 0)}, fixed={"O": "xy", "A": "y"}, bars={"beam": kt.Bar(ends=("O", "A"), mass=0)}, **STEEL,
    )  # fmt: skip
    x = ALL * L

    def moment(load):
        return np.abs(at_rest(base.with_(loads={"one": load})).section_M.sel(part="beam").values[0, :, 0])

    point = kt.BodyForce(body="beam", at=(0.4, 0.0), force=(0, -F))
    np.testing.assert_allclose(moment(point), np.where(x < 0.4, F * (L - 0.4) * x / L, F * 0.4 * (L - x) / L), atol=1e-9)
    press = kt.Pressure(face=("O", "A"), pressure=p, depth=b)
    np.testing.assert_allclose(moment(press), p * b * x * (L - x) / 2, atol=1e-9)
    twist = kt.BodyCouple(body="beam", moment=M)
    np.testing.assert_allclose(moment(twist), np.where(x <= L / 2, M * x / L, M * (L - x) / L), atol=1e-9)


def test_a_strut_whose_length_is_coupled_bears_the_force_of_the_coupling():
    """A weight hangs on a strut of kind `free` whose length is coupled to a crank: it is in tension by the weight."""
    m, r = 12.0, 0.05
    model = kt.Model(
        nodes={"O": (0, 0), "A": (0.3, 0), "H": (1, 2), "W": kt.Node(at=(1, 1), mass=m)},
        fixed={"O": "xy", "H": "xy", "W": "x"},
        bars={"crank": kt.Bar(ends=("O", "A"), mass=0), "rope": kt.Bar(ends=("H", "W"), kind="free", mass=0)},
        couplings={"winch": kt.Coupling(terms=((kt.LengthDrive("rope"), 1.0), (kt.AngleDrive("crank"), -r)))},
        drives={"motor": kt.AngleDrive("crank")}, gravity=(0, -G), **STEEL,
    )  # fmt: skip
    forces = kt.statics.at_poses(model, [{}])
    assert forces.member_force.sel(member="rope").item() == pytest.approx(m * G)
    np.testing.assert_allclose(kt.strength.sections(model, forces).section_T.sel(part="rope").values, m * G)
    # the motor and the winch turn the crank against each other at its pin: nothing bends it
    np.testing.assert_allclose(bending(kt.strength.sections(model, forces, ALL), "crank"), 0.0, atol=1e-9)
    assert abs(forces.drive_force.item()) == pytest.approx(m * G * r)
    assert kt.statics.equilibrium(model).member_force.sel(member="rope").item() == pytest.approx(m * G)


@pytest.mark.slow
@pytest.mark.parametrize("given", ["torque", "motor"])
def test_a_simulated_arm_bends_by_its_motor(given):
    """From rest by a torque tau: at the root M = tau, whatever gives it."""
    L, m, torque = 0.9, 2.0, 6.0
    arm = kt.Model(
        nodes={"O": (0, 0), "A": (L, 0)}, fixed=["O"], gravity=(0, -G), bars={"arm": kt.Bar(ends=("A", "O"), mass=m)},
        drives={"joint": kt.AngleDrive("arm", motor=kt.Motor(
            inertia=1e-5, resistance=1.0, torque_constant=0.05, emf_constant=0.05), gear=kt.Gear(ratio=60.0))}, **STEEL,
    )  # fmt: skip
    task = {"torque": kt.GivenForce(torque=torque), "motor": kt.StepInput(voltage=3.0)}[given]
    run = kt.dynamics.simulate(arm, 0.05, samples=4, tasks={"joint": task})
    found = bending(kt.strength.sections(arm, run.forces, ALL), "arm")
    told = abs(run.forces.drive_force.values[0].item())
    assert found[-1] == pytest.approx(told, rel=1e-9)
    assert told > 1.0
    if given == "torque":
        assert told == pytest.approx(torque)
    np.testing.assert_allclose(found[0], 0.0, atol=1e-9)


@pytest.mark.slow
def test_what_no_bar_carries_is_named():
    """A hinge drive of a triangle none of whose bars leads from the axis to the node; a bracket on a bar; a plate on three."""
    base = {"gravity": (0, -G), "section": STEEL["section"], "material": STEEL["material"]}
    frame = kt.Model(
        nodes={"O": (0, 0), "P": (1, 0), "Q": (0.5, 0.5), "G": (0, -1)}, fixed=["O", "G"], **base,
        bars={"oq": ("O", "Q"), "qp": ("Q", "P"), "gp": kt.Bar(ends=("G", "P"), kind="driven")},
        drives={"motor": kt.HingeDrive(axis="O", start="G", end="P")},
    )  # fmt: skip
    verdict = kt.strength.check(frame, kt.statics.at_poses(frame, [{}]))
    assert "drive 'motor'" in verdict.message
    assert "P, O" in verdict.message
    notes = {row.part: row.note for row in verdict.table() if row.rule == "yield"}
    assert all("without bending by drive 'motor'" in notes[name] for name in ("oq", "qp", "gp"))
    assert kt.strength.sections(frame, kt.statics.at_poses(frame, [{}])).message == verdict.message

    bracket = kt.Model(
        nodes={"O": (0, 0), "A": (1, 0), "P": (0.4, 0.3)}, fixed={"O": "xy", "A": "y"}, **base, bars={"beam": ("O", "A")},
        bodies={"bracket": kt.Body(nodes=("O", "A", "P"))}, loads={"pull": kt.NodalForce(node="P", force=(5, 3))},
    )  # fmt: skip
    verdict = kt.strength.check(bracket, kt.statics.at_poses(bracket, [{}]))
    assert "body 'bracket'" in verdict.message
    assert verdict.data.attrs["not_held"]
    assert not kt.strength.check(kt.library.vgt.triangular(), kt.statics.at_poses(kt.library.vgt.triangular(), [{}])).message
