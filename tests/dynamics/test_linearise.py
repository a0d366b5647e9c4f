"""Linearisation: closed forms, differences of the nonlinear equations about moving states, responses, refusals."""

import numpy as np
import pytest

import kinetruss as kt
from kinetruss.dynamics.linear_state import state_at
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.mechanics.coordinates import derivatives_of, dof_basis, first_order_of

G = 9.81
SPAN = 9.144


def ten_bars(lumped: bool = False) -> kt.Model:
    """Ten bars, A = 1e-3 m^2, E = 70e9 Pa, 2700 kg/m^3, bays of 9.144 m."""
    section = kt.General(area=1e-3, I2=1e-9, I3=1e-9, c2=0.01, c3=0.01)
    at = {"1": (2, 1), "2": (2, 0), "3": (1, 1), "4": (1, 0), "5": (0, 1), "6": (0, 0)}
    pairs = ["53", "31", "64", "42", "34", "12", "54", "63", "32", "41"]
    masses = dict.fromkeys(at, 0.0)
    bars = {}
    for pair in pairs:
        length = SPAN * np.hypot(*np.subtract(at[pair[0]], at[pair[1]]))
        for end in pair:
            masses[end] += 0.5 * 2700.0 * 1e-3 * length
        bars[f"b{pair}"] = kt.Bar(ends=tuple(pair), kind="elastic", mass=0.0 if lumped else None)
    nodes = {name: kt.Node(at=(x * SPAN, y * SPAN), mass=masses[name] if lumped else 0.0) for name, (x, y) in at.items()}
    return kt.Model(nodes=nodes, fixed=["5", "6"], bars=bars, section=section, material=kt.Material(E=70e9, density=2700.0))


def pendulum(**bar):
    return kt.Model(nodes={"A": (0, 0), "B": kt.Node(at=(0, -2.0), mass=3.0)}, fixed=["A"],
                    bars={"rod": kt.Bar(ends=("A", "B"), **bar)}, gravity=(0, -G))  # fmt: skip


def swinging(**fields):
    """A double pendulum of uniform rods with a spring, a damper and a point mass."""
    shared = {
        "nodes": {"A": (0, 0), "B": (0.8, -0.6), "C": kt.Node(at=(1.4, -1.4), mass=0.5), "W": (2.0, 0.2)},
        "fixed": ["A", "W"], "gravity": (0, -G),
        "bars": {"one": kt.Bar(ends=("A", "B"), mass=1.0), "two": kt.Bar(ends=("B", "C"), mass=2.0),
                 "spring": kt.Bar(ends=("C", "W"), kind="elastic", stiffness=40.0, natural_length=1.0, damping=1.5, mass=0.1)},
    }  # fmt: skip
    return kt.Model(**shared | fields)


@pytest.mark.parametrize("lumped", [False, True])
def test_frequencies_of_ten_bars(lumped):
    consistent = [15.491233999027331, 44.31996859444556, 53.188386124047064, 103.04590629233871, 105.6536527761645,
                  121.67543929864034, 128.5745904947974, 155.9488208535349]  # fmt: skip
    by_lumps = [14.509773298653343, 40.6934574189146, 42.45055171881497, 77.44466317159073, 83.73256250506675,
                95.87391017593944, 96.16737821561277, 116.5618328435034]  # fmt: skip
    found = kt.dynamics.linearise(ten_bars(lumped))
    np.testing.assert_allclose(found.frequency, by_lumps if lumped else consistent, rtol=1e-12)
    assert found.mode_shape.dims == ("mode", "node", "axis")
    np.testing.assert_allclose(np.abs(found.mode_shape).max(("node", "axis")), 1, rtol=1e-14)
    # modes are apart in mass and stiffness, and the modal mass is that of the shape
    phi = found.mode_dofs.values
    modal = phi @ found.mass.values @ phi.T
    np.testing.assert_allclose(modal, np.diag(found.modal_mass.values), atol=1e-9 * modal.max())


@pytest.mark.slow
@pytest.mark.parametrize("dofs", [None, "B1.y", "spring", "left.angle"])
def test_rhombus_by_any_freedom(dofs):
    model = kt.library.mechanisms.rhombus_with_spring()
    found = kt.dynamics.linearise(model, kt.statics.equilibrium(model), dofs=dofs)
    assert found.angular_frequency.item() == pytest.approx(4.251519555206327, rel=1e-13)
    assert found.message == "" and found.stable


def test_small_swings_standing_and_hanging():
    model = pendulum(mass=0.6)
    found = kt.dynamics.linearise(model, dofs="rod.angle")
    square = G * (3.0 + 0.3) / (2 * (3.0 + 0.2))
    assert found.frequency_squared.item() == pytest.approx(square, rel=1e-14)
    up = kt.dynamics.linearise(model, [(0, 0), (0, 2)], dofs="rod.angle")
    assert up.frequency_squared.item() == pytest.approx(-square, rel=1e-14)
    assert np.isnan(up.frequency.item()) and not up.stable and found.stable
    np.testing.assert_allclose(sorted(up.poles.real), [-np.sqrt(square), np.sqrt(square)], rtol=1e-12)


@pytest.mark.slow
def test_a_body_and_an_active_member_as_pendulums():
    """w^2 = m g c/J about the hinge, with the centre of mass below it at rest."""
    m, e, f, inertia = 2.0, 0.4, -0.3, 0.15
    body = kt.PlanarBody(mass=m, center=(e, f), inertia=inertia)
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.6, 0.8)}, fixed=["A"], gravity=(0, -G), bars={"b": kt.Bar(ends=("A", "B"), body=body)}
    )
    rest = kt.statics.equilibrium(model)
    x, y = rest.position.sel(node="B").values
    centre = np.array([[x, -y], [y, x]]) @ [e, f]
    np.testing.assert_allclose(centre, [0, -0.5], atol=1e-12)
    found = kt.dynamics.linearise(model, rest, dofs="b.angle")
    assert found.frequency_squared.item() == pytest.approx(m * G * 0.5 / (inertia + m * 0.25), rel=1e-12)
    mb, lb, mt, lt, L = 3.0, 0.7, 1.0, 0.5, 1.1
    leg = kt.Active(ends=("A", "B"), base=kt.Part(length=lb, mass=mb), tube=kt.Part(length=lt, mass=mt))
    model = kt.Model(nodes={"A": (0, 0), "B": (0.66, -0.88)}, fixed=["A"], gravity=(0, -G), active={"M": leg})
    rest = kt.statics.equilibrium(model)
    np.testing.assert_allclose(rest.position.sel(node="B"), [0, -L], atol=1e-12)
    found = kt.dynamics.linearise(model, rest, dofs="M.angle")
    second = mb * lb**2 / 3 + mt * (lt**2 / 12 + (L - lt / 2) ** 2)
    assert found.mass.item() == pytest.approx(second, rel=1e-12)
    assert found.frequency_squared.item() == pytest.approx(G * (mb * lb / 2 + mt * (L - lt / 2)) / second, rel=1e-11)


def nonlinear(model, at, x, v):
    """Second rates of the dofs at x, v by the equations of motion."""
    state = state_at(model, (x[:, : at.system.dim], v[:, : at.system.dim]), None, None, None)
    derived = derivatives_of(at.system, at.dofs, x, v, state.a)
    a = state.a.reshape(-1)
    rate = (derived.g[0] @ v.reshape(-1)) / derived.r[:, 0]
    found = []
    for k, one in enumerate(at.dofs):
        if one.kind == "node":
            found.append(a[one.index])
            continue
        i = one.index
        d, dv, da = (y[at.system.q[i]] - y[at.system.p[i]] for y in (x, v, state.a))
        L = np.linalg.norm(d)
        if one.kind == "length":
            found.append(d @ da / L + (dv @ dv - rate[k] ** 2) / L)
        else:
            n = np.array([-d[1], d[0], 0]) / L
            found.append((n @ da - 2 * (d @ dv / L) * rate[k]) / L)
    return np.array(found)


def nearby(model, at, x, rates, change):
    """Positions and velocities with the dofs changed by `change` (dofs, then rates), on the rows."""
    from kinetruss.statics.search import projected

    system, k = at.system, len(at.dofs)
    y = x.copy()
    target = np.array([value_of(system, one, x) for one in at.dofs]) + change[:k]
    for _ in range(40):
        now = dof_basis(compile(model), [one.name for one in at.dofs], y, ())
        off = target - np.array([value_of(system, one, y) for one in at.dofs])
        y = y + (first_order_of(now) @ off).reshape(y.shape)
        y, _ = projected(now.system, y, now.system.row_value, 1.0)
    now = dof_basis(compile(model), [one.name for one in at.dofs], y, ())
    return y, (first_order_of(now) @ (rates + change[k:])).reshape(y.shape)


def value_of(system, one, x):
    if one.kind == "node":
        return x.reshape(-1)[one.index]
    d = x[system.q[one.index]] - x[system.p[one.index]]
    return np.linalg.norm(d) if one.kind == "length" else np.arctan2(d[1], d[0])


@pytest.mark.slow
@pytest.mark.parametrize("dofs", [("B.x", "C.y"), ("one.angle", "spring"), ("one.angle", "two.angle")])
def test_moving_state_against_differences_of_the_nonlinear_equations(dofs):
    model = swinging()
    system = compile(model)
    at = dof_basis(system, dofs, system.x0, ())
    rates = np.array([0.7, -1.3])
    x, v = nearby(model, at, system.x0, rates, np.zeros(4))
    found = kt.dynamics.linearise(model, (x[:, :2], v[:, :2]), dofs=dofs)
    assert "moving state" in found.message
    h = 1e-5
    for k in range(4):
        step = np.zeros(4)
        step[k] = h
        slope = (
            nonlinear(model, at, *nearby(model, at, x, rates, step)) - nonlinear(model, at, *nearby(model, at, x, rates, -step))
        ) / (2 * h)
        np.testing.assert_allclose(found.A.values[2:, k], slope, rtol=2e-7, atol=2e-6)


@pytest.mark.slow
def test_about_a_sample_of_a_motion():
    model = swinging()
    run = kt.dynamics.simulate(model, 0.6, samples=4)
    with pytest.raises(InputError, match="more than one sample. Give time="):
        kt.dynamics.linearise(model, run)
    with pytest.raises(InputError, match="Linear is not a state"):
        kt.dynamics.linearise(ten_bars(), kt.statics.linear(ten_bars()))
    found = kt.dynamics.linearise(model, run.motion, dofs=["one.angle", "two.angle"], time=0.4)
    here = run.motion.data.sel(time=0.4, method="nearest")
    same = kt.dynamics.linearise(model, (here["position"].values, here["velocity"].values), dofs=["one.angle", "two.angle"])
    np.testing.assert_allclose(found.A, same.A, rtol=1e-7, atol=1e-7)
    # driven: the forces that drives let go push with are those of inverse dynamics
    bay = kt.library.vgt.double_octahedral(payload_mass=2.0)
    motion = kt.kinematics.follow(bay, kt.library.vgt.slew(beta=(-0.1, 0.1), duration=1.0), samples=5)
    forces = kt.dynamics.inverse(bay, motion)
    found = kt.dynamics.linearise(bay, motion, dofs=["M7", "M9", "M11"], time=0.25)
    np.testing.assert_allclose(found.drive_force, forces.drive_force.sel(time=0.25), rtol=1e-9)
    np.testing.assert_allclose(found.member_force, forces.member_force.sel(time=0.25), atol=1e-9)


def test_state_that_is_no_equilibrium_says_so():
    found = kt.dynamics.linearise(pendulum(mass=0.0), [(0, 0), (2, 0)], dofs="rod.angle")
    assert "no equilibrium (largest force left" in found.message
    # theta'' = -(g/L) cos(theta) about theta = 0: no stiffness, but sin(theta) = 0
    np.testing.assert_allclose(found.A.values, [[0, 1], [0, 0]], atol=1e-12)


def test_motion_of_a_support():
    by_node = kt.dynamics.linearise(pendulum(mass=0.0), inputs="A.x", dofs="B.x", outputs=["rod.angle", "A.x.force", "B.x''"])
    np.testing.assert_allclose(by_node.B.values, [[0, 0, 0], [G / 2, 0, 0]], atol=1e-13)
    np.testing.assert_allclose(by_node.C.values, [[0.5, 0], [-3 * G / 2, 0], [-G / 2, 0]], atol=1e-12)
    np.testing.assert_allclose(by_node.D.values, [[-0.5, 0, 0], [3 * G / 2, 0, 0], [G / 2, 0, 0]], atol=1e-12)
    by_angle = kt.dynamics.linearise(pendulum(mass=0.0), inputs="A.x", dofs="rod.angle", outputs="B.x")
    np.testing.assert_allclose(by_angle.B.values, [[0, 0, 0], [0, 0, -0.5]], atol=1e-13)
    w = np.array([0.5, 1.0, 5.0])
    exact = (G / 2) / (G / 2 - w**2)
    np.testing.assert_allclose(by_angle.frequency_response(w)[:, 0, 0].values, exact, rtol=1e-12)
    np.testing.assert_allclose(by_node.frequency_response(w, of="B.x''")[:, 0, 0].values, -(w**2) * exact, rtol=1e-12)
    assert by_node.input.values.tolist() == ["A.x", "A.x'", "A.x''"]
    assert by_node.input_unit.values.tolist() == ["m", "m/s", "m/s^2"]


def test_hoisting_a_swinging_load():
    """theta'' = -(g/L) sin(theta) - 2 L' theta'/L, about a turning state and by the rate of L."""
    model = pendulum(mass=0.0, kind="driven")
    theta, w, L = 0.4, 0.9, 2.0
    at = np.array([(0, 0), (L * np.sin(theta), -L * np.cos(theta))])
    v = np.array([(0, 0), (L * w * np.cos(theta), L * w * np.sin(theta))])
    found = kt.dynamics.linearise(model, (at, v), inputs="rod", dofs="rod.angle")
    # at rest in L: what the acceleration of the load is at this instant counts too
    np.testing.assert_allclose(found.A.values, [[0, 1], [-G / L * np.cos(theta), 0]], atol=1e-12)
    np.testing.assert_allclose(found.B.values[1], [G / L**2 * np.sin(theta), -2 * w / L, 0], atol=1e-12)


def oscillator(k=50.0, c=1.2, m=2.0):
    return kt.Model(nodes={"A": (0, 0), "B": kt.Node(at=(1, 0), mass=m)}, fixed={"A": "xy", "B": "y"},
                    bars={"s": kt.Bar(ends=("A", "B"), kind="elastic", stiffness=k, damping=c)})  # fmt: skip


def test_transmissibility_of_an_oscillator():
    k, c, m = 50.0, 1.2, 2.0
    found = kt.dynamics.linearise(
        oscillator(k, c, m), inputs=["A.x", "B.x", "s"], outputs=["B.x", "A.x.force", "s.force", "B.x'", "B.x''"]
    )
    w = np.geomspace(0.1, 100, 13)
    r, z = w / np.sqrt(k / m), c / (2 * np.sqrt(k * m))
    exact = np.sqrt((1 + (2 * z * r) ** 2) / ((1 - r**2) ** 2 + (2 * z * r) ** 2))
    np.testing.assert_allclose(found.transmissibility(w, of="B.x", wrt="A.x")[:, 0, 0], exact, rtol=1e-11)
    # as much of a force on the mass arrives at the ground
    np.testing.assert_allclose(found.transmissibility(w, of="A.x.force", wrt="B.x")[:, 0, 0], exact, rtol=1e-11)
    H = 1 / (k - m * w**2 + 1j * c * w)
    np.testing.assert_allclose(found.frequency_response(w, of="B.x'", wrt="s")[:, 0, 0], 1j * w * H, rtol=1e-11)
    np.testing.assert_allclose(found.frequency_response(w, of="B.x''", wrt="s")[:, 0, 0], -(w**2) * H, rtol=1e-11)
    np.testing.assert_allclose(found.frequency_response(w, of="s.force", wrt="s")[:, 0, 0], m * w**2 * H, rtol=1e-11)
    assert found.modal_damping.item() == pytest.approx(z, rel=1e-13)
    np.testing.assert_allclose(found.pole_damping, z, rtol=1e-12)


def test_static_compliance_is_that_of_the_stiffness_method():
    model = ten_bars()
    found = kt.dynamics.linearise(model, inputs=["2.y"], outputs=["1.y", "b54.force", "6.x.force"])
    loaded = model.with_(loads={"l": kt.NodalForce(node="2", force=(0, 1.0))})
    still = kt.statics.linear(loaded, weight=False)
    wanted = [
        still.displacement.sel(node="1", axis="y"),
        still.member_force.sel(member="b54"),
        still.reaction.sel(support="6", axis="x"),
    ]
    np.testing.assert_allclose(found.frequency_response(0.0)[0, :, 0].values.real, wanted, rtol=1e-10)


@pytest.mark.slow
def test_a_drive_let_go_pushes_with_what_holds_it():
    model = kt.library.vgt.double_octahedral(payload_mass=2.0, tip_force=(5.0, -3.0, 10.0))
    held = kt.statics.at_poses(model, [{}])
    found = kt.dynamics.linearise(model, dofs=["M7", "N8.x", "M11"], free=["M9"], inputs=["M7", "M9", "M11"])
    np.testing.assert_allclose(found.drive_force, held.drive_force.values[0], rtol=1e-9)
    np.testing.assert_allclose(found.member_force, held.member_force.values[0], atol=1e-9)
    assert found.message == ""
    # a force on the drives that moves them apart from their weight: M q'' = F
    lengths = kt.dynamics.linearise(model, dofs=["M7", "M9", "M11"], inputs=["M7", "M9", "M11"])
    np.testing.assert_allclose(lengths.mass.values @ lengths.B.values[3:], np.eye(3), atol=1e-10)
    np.testing.assert_allclose(lengths.frequency_squared, found.frequency_squared, rtol=1e-8)


@pytest.mark.slow
def test_equilibrium_under_given_forces_as_state():
    model = kt.library.vgt.double_octahedral(payload_mass=2.0, gravity=(0, 0, 9.81))
    pushes = dict(zip(("M7", "M9", "M11"), kt.statics.at_poses(model, [{}]).drive_force.values[0], strict=True))
    rest = kt.statics.equilibrium(model, tasks={name: kt.GivenForce(float(value)) for name, value in pushes.items()})
    found = kt.dynamics.linearise(model, rest)
    assert found.data.sizes["dof"] == 3
    np.testing.assert_allclose(found.drive_force, list(pushes.values()), rtol=1e-9)


def test_free_truss_has_six_motions_without_frequency():
    model = kt.library.vgt.double_octahedral(payload_mass=1.0, gravity=None)
    stuff = {"kind": "elastic", "section": kt.Tube(outer=0.019, inner=0.016), "material": kt.library.materials.ALUMINIUM_LACY}
    bars = {name: bar.with_(**stuff) for name, bar in model.bars.items()}
    more = {name: kt.Bar(ends=member.ends, **stuff) for name, member in model.active.items()}
    more |= {f"base{a}{b}": kt.Bar(ends=(f"N{a}", f"N{b}"), **stuff) for a, b in ((1, 2), (2, 3), (3, 1))}
    loose = model.with_(fixed={}, active={}, poses={}, bars=bars | more, runs={}, trajectories={})
    found = kt.dynamics.linearise(loose)
    squares = found.frequency_squared.values
    assert np.abs(squares[:6]).max() < 1e-12 * squares[6]
    assert found.frequency.values[:6].tolist() == [0.0] * 6 and found.stable
    assert len(squares) == 27


def test_prestress_makes_frequency():
    """A mass between two taut springs: across them the stiffness is 2 N/l alone."""
    bar = {"kind": "elastic", "stiffness": 1000.0, "pretension": 30.0}
    model = kt.Model(nodes={"A": (0, 0), "B": kt.Node(at=(1, 0), mass=2.0), "C": (2, 0)}, fixed=["A", "C"],
                     bars={"a": kt.Bar(ends=("A", "B"), **bar), "b": kt.Bar(ends=("B", "C"), **bar)})  # fmt: skip
    found = kt.dynamics.linearise(model)
    np.testing.assert_allclose(found.frequency_squared, [30.0, 1000.0], rtol=1e-12)


def test_sums_as_inputs_and_outputs():
    model = ten_bars()
    found = kt.dynamics.linearise(
        model, inputs={"ground": {"5.x": 1, "6.x": 1}}, outputs={"mean": {"1.x": 0.5, "2.x": 0.5}, "top": "1.x"}
    )
    assert found.frequency_response(0.0).sel(output="mean").item() == pytest.approx(1.0)
    assert found.output.values.tolist() == ["mean", "top"]
    # a node without an axis stands for all
    found = kt.dynamics.linearise(model, inputs="1", outputs="2'")
    assert found.input.values.tolist() == ["1.x", "1.y"] and found.output.values.tolist() == ["2.x'", "2.y'"]


@pytest.mark.slow
def test_refusals():
    model = swinging()
    at, moved = [node.at for node in model.nodes.values()], [[0, 0], [1, 1], [0, 0], [0, 0]]
    for fields, text in (
        ({"inputs": "Q.x"}, "No coordinate called 'Q.x'"), ({"outputs": "one.farce"}, "No coordinate called 'one.farce'"),
        ({"dofs": ["B.x"]}, "has 2 freedoms here, but 1 is named"), ({"dofs": ["B.x", "B.y"]}, "do not fix the configuration"),
        ({"outputs": "B.x.force"}, "nothing carries a force there"), ({"outputs": "B.x'''"}, "write a coordinate, with '"),
        ({"inputs": {"s": {"A.x": 1, "B.x": 1}}}, "adds different quantities"), ({"inputs": ["A.x", "A.x"]}, "named twice"),
        ({"outputs": {"s": {"B.x": 1, "B.x'": 1}}}, "adds different quantities"), ({"inputs": {"s": {}}}, "names nothing"),
        ({"state": np.zeros((3, 2))}, r"shape \(3, 2\)"), ({"load_case": "x"}, "No load case called 'x'"),
        ({"tasks": {"m": kt.Free()}}, "'m'"), ({"state": (at, moved)}, "the length of 'one'"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=text):
            kt.dynamics.linearise(model, **fields)
    held = kt.library.mechanisms.four_bar()
    with pytest.raises(InputError, match="Nothing can move here: all drives are held"):
        kt.dynamics.linearise(held)
    light = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed={"A": "xy", "B": "y"},
                     bars={"s": kt.Bar(ends=("A", "B"), kind="elastic", stiffness=1.0)})  # fmt: skip
    with pytest.raises(InputError, match=r"'B.x' can move without moving any mass"):
        kt.dynamics.linearise(light)
    free = kt.dynamics.linearise(oscillator(c=0.0), inputs="B.x", outputs="B.x")
    with pytest.raises(InputError, match="resonates at w = 5 rad/s"):
        free.frequency_response(5.0)
    with pytest.raises(InputError, match="No output called 'C.x'"):
        free.frequency_response(1.0, of="C.x")


def test_frequencies_about_no_equilibrium_say_so():
    """A pendulum at rest has g/l; drawn aside it is not at rest, which the frequency itself says, and the message."""

    def named(at):
        rod = kt.Model(
            nodes={"A": (0, 0), "B": kt.Node(at=at, mass=1.0)}, fixed=["A"], bars={"b": ("A", "B")}, gravity=(0, -9.81)
        )
        found = kt.dynamics.linearise(rod, dofs="B.x")
        return found, "no equilibrium" in found.message, "no equilibrium" in found.frequency.attrs["long_name"]

    still, *said = named((0, -2.0))
    assert said == [False, False]
    assert still.angular_frequency.item() ** 2 == pytest.approx(9.81 / 2, rel=1e-12)
    aside, *said = named((0.6, -1.9))
    assert said == [True, True]
    assert "no equilibrium" in repr(aside)
