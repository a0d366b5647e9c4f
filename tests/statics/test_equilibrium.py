"""Nonlinear equilibrium: closed forms, balance of forces, any start, prestress, mechanisms, refusals."""

import math

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import AnalysisError, InputError, ModelError
from kinetruss.mechanics import compile

G = 9.81


def chain(count: int = 3, **fields):
    """Rigid links of 1 m hanging from A, each with 1 kg at its end."""
    nodes = {"N0": (0, 0)} | {f"N{k}": kt.Node(at=(k, 0), mass=1.0) for k in range(1, count + 1)}
    bars = {f"b{k}": (f"N{k - 1}", f"N{k}") for k in range(1, count + 1)}
    return kt.Model(**{"nodes": nodes, "fixed": ["N0"], "bars": bars, "gravity": (0, -G)} | fields)


def net(rows: int = 4, **fields):
    """A square net of prestressed cables with fixed rim, loaded across its plane."""
    nodes = {f"{i}.{j}": kt.Node(at=(i, j, 0), mass=0.5) for i in range(rows + 1) for j in range(rows + 1)}
    rim = [name for name in nodes if set(name.split(".")) & {"0", str(rows)}]
    bars = {}
    for i in range(rows + 1):
        for j in range(rows + 1):
            for k, m in ((i + 1, j), (i, j + 1)):
                if max(k, m) <= rows:
                    bars[f"{i}.{j}-{k}.{m}"] = kt.Bar(
                        ends=(f"{i}.{j}", f"{k}.{m}"), kind="cable", stiffness=2e4, pretension=100.0
                    )
    return kt.Model(**{"nodes": nodes, "fixed": rim, "bars": bars, "gravity": (0, 0, -G)} | fields)


def test_rhombus_with_a_spring():
    found = kt.statics.equilibrium(kt.library.mechanisms.rhombus_with_spring())
    x, y = found.position.sel(node="B0").values
    assert np.arctan2(y, x) == pytest.approx(1.0662472589998337, rel=1e-13)
    np.testing.assert_allclose(found.member_force.sel(member=["left", "top", "right"]),
                               [-0.3717668239159057, 5.417317119214779, -11.206401062345464], rtol=1e-11)  # fmt: skip
    assert found.stable and found.message == "" and found.ways_out == []


@pytest.mark.slow
@settings(max_examples=25, deadline=None)
@given(st.lists(st.floats(-3.1, 3.1), min_size=3, max_size=3))
def test_a_chain_hangs_down_from_any_start(angles):
    steps = np.cumsum([(0, 0)] + [(np.sin(a), np.cos(a)) for a in angles], axis=0)
    found = kt.statics.equilibrium(chain(), steps)
    if np.allclose(np.sin(angles), 0, atol=1e-12):
        return
    np.testing.assert_allclose(found.position, [(0, 0), (0, -1), (0, -2), (0, -3)], atol=1e-11)
    np.testing.assert_allclose(found.member_force, [3 * G, 2 * G, G], rtol=1e-12)
    assert found.stable


@pytest.mark.slow
def test_an_unstable_equilibrium_is_kept_and_named():
    up = kt.statics.equilibrium(chain(2), [(0, 0), (0, 1), (0, 2)])
    np.testing.assert_allclose(up.position, [(0, 0), (0, 1), (0, 2)])
    assert not up.stable and "Unstable in 2 modes: N1 moves along x" in up.message
    assert up.stiffness.values[0] < 0
    # a hair beside it, it falls
    down = kt.statics.equilibrium(chain(2), [(0, 0), (1e-9, 1), (0, 2)])
    assert down.stable and down.position.sel(node="N2", axis="y").item() == pytest.approx(-2)


def test_freedoms_without_stiffness_are_named():
    found = kt.statics.equilibrium(chain(1, gravity=None))
    assert not found.stable and found.message.startswith("Left free, 1 mode without stiffness: N1 moves along y")
    slack = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"],
                     bars={"c": kt.Bar(ends=("A", "B"), kind="cable", stiffness=10.0, natural_length=2.0)})  # fmt: skip
    found = kt.statics.equilibrium(slack)
    assert found.data.attrs["neutral"] == 2 and found.member_force.item() == 0


def test_elastic_pendulum_and_green_strain():
    """k e (1 + ...) = m g: engineering l = l0 + m g/k; Green k (l^2 - l0^2) l/(2 l0^2) = m g."""
    for strain in ("engineering", "green"):
        spring = kt.Bar(ends=("A", "B"), kind="elastic", stiffness=90.0, natural_length=1.0, strain=strain)
        model = kt.Model(
            nodes={"A": (0, 0), "B": kt.Node(at=(1, 0.3), mass=2.0)}, fixed=["A"], gravity=(0, -G), bars={"s": spring}
        )
        found = kt.statics.equilibrium(model)
        length = found.length.item()
        pull = 90.0 * (length - 1) if strain == "engineering" else 45.0 * (length**2 - 1) * length
        assert pull == pytest.approx(2 * G, rel=1e-12)
        assert found.position.sel(node="B", axis="y").item() == pytest.approx(-length)


@settings(max_examples=6, deadline=None)
@given(st.tuples(st.floats(-200, 200), st.floats(-200, 200), st.floats(-200, 50)))
def test_forces_of_a_net_balance(push):
    model = net(loads={"push": kt.NodalForce(node="1.2", force=push)})
    found = kt.statics.equilibrium(model)
    total = (
        found.reaction.sum("support").values + np.array(push) + 9 * 0.5 * np.array([0, 0, -G]) + 16 * 0.5 * np.array([0, 0, -G])
    )
    np.testing.assert_allclose(total, 0, atol=1e-8)
    system = compile(model)
    x = found.position.values
    d = x[system.q] - x[system.p]
    pull = found.member_force.values[:, None] * d / np.linalg.norm(d, axis=1, keepdims=True)
    left = np.zeros_like(x)
    np.add.at(left, system.p, pull)
    np.subtract.at(left, system.q, pull)
    left[:, 2] -= 0.5 * G
    left[model_index(system, "1.2")] += push
    inner = [i for i, name in enumerate(system.nodes) if name not in model.fixed]
    np.testing.assert_allclose(left[inner], 0, atol=1e-8)
    assert (found.member_force.values >= 0).all() and found.stable


def model_index(system, name):
    return system.nodes.index(name)


def test_small_loads_give_the_stiffness_method():
    model = kt.library.vgt.double_octahedral(gravity=None)
    stuff = {"kind": "elastic", "section": kt.Tube(outer=0.019, inner=0.016), "material": kt.library.materials.ALUMINIUM_LACY}
    bars = {name: bar.with_(**stuff) for name, bar in model.bars.items()}
    bars |= {name: kt.Bar(ends=member.ends, **stuff) for name, member in model.active.items()}
    model = model.with_(active={}, poses={}, bars=bars, loads={"l": kt.NodalForce(node="N8", force=(1e-3, 2e-3, -1e-3))})
    found, linear = kt.statics.equilibrium(model), kt.statics.linear(model, weight=False)
    shift = found.position.values - np.array([node.at for node in model.nodes.values()])
    np.testing.assert_allclose(shift, linear.displacement, atol=2e-6 * np.abs(linear.displacement).max().item())
    np.testing.assert_allclose(found.member_force, linear.member_force, atol=1e-8)


def test_rigid_trusses_carry_what_inverse_dynamics_says():
    model = kt.library.vgt.double_octahedral(2, payload_mass=3.0, tip_force=(10.0, 20.0, -5.0))
    found, held = kt.statics.equilibrium(model), kt.statics.at_poses(model, [{}])
    size = np.abs(held.member_force.values).max()
    for name in ("member_force", "reaction", "drive_force"):
        np.testing.assert_allclose(found.data[name], held.data[name].values[0], atol=1e-10 * size)
    # redundant: shared likewise
    twice = model.with_(bars=model.bars | {"again": kt.Bar(ends=("B1.N4", "B1.N5"), mass=0.0)})
    found, held = kt.statics.equilibrium(twice), kt.statics.at_poses(twice, [{}])
    np.testing.assert_allclose(found.member_force, held.member_force.values[0], atol=1e-8 * size)


def test_lengths_and_given_forces_of_drives():
    model = kt.library.vgt.double_octahedral(gravity=(0, 0, -G), payload_mass=5.0)
    lengths = {"M7": 1.2, "M9": 1.15, "M11": 1.18}
    found = kt.statics.equilibrium(model, lengths=lengths)
    np.testing.assert_allclose(found.position, kt.kinematics.assemble(model, lengths), atol=1e-11)
    held = kt.statics.at_poses(model, [lengths])
    np.testing.assert_allclose(found.drive_force, held.drive_force.values[0], rtol=1e-9)
    # hanging, the same thrusts hold the same pose
    hanging = model.with_(gravity=(0, 0, G))
    pushes = {name: -held.drive_force.sel(drive=name).item() for name in lengths}
    free = kt.statics.equilibrium(hanging, found, tasks={name: kt.GivenForce(value) for name, value in pushes.items()})
    np.testing.assert_allclose(free.drive_force, [pushes[name] for name in model.all_drives], rtol=1e-12)
    np.testing.assert_allclose(free.length.sel(member=list(lengths)), list(lengths.values()), rtol=1e-8)


def test_torque_and_coordinate_force():
    crank = kt.Model(nodes={"A": (0, 0), "B": kt.Node(at=(1, 0), mass=1.0)}, fixed=["A"], bars={"b": ("A", "B")},
                     gravity=(0, -G), drives={"turn": kt.AngleDrive("b")})  # fmt: skip
    found = kt.statics.equilibrium(crank, tasks={"turn": kt.GivenForce(torque=4.0)})
    x, y = found.position.sel(node="B").values
    assert np.cos(np.arctan2(y, x)) == pytest.approx(4.0 / G) and y < 0 and found.stable
    held = kt.statics.equilibrium(crank)
    assert held.drive_force.item() == pytest.approx(G) and held.data.sizes["mode"] == 0
    slide = crank.with_(drives={"pull": kt.CoordinateDrive(node="B", axis="x")})
    found = kt.statics.equilibrium(slide, tasks={"pull": kt.GivenForce(G)})
    np.testing.assert_allclose(found.position.sel(node="B"), [np.sqrt(0.5), -np.sqrt(0.5)], rtol=1e-12)
    assert found.drive_force.item() == G


@pytest.mark.slow
def test_far_lengths_stay_on_the_branch_of_the_start():
    model = kt.library.mechanisms.four_bar()
    for turn in (0.9, 2.5, 4.0):
        found = kt.statics.equilibrium(model, lengths={"motor": turn})
        np.testing.assert_allclose(found.position, kt.kinematics.assemble(model, {"motor": turn}), atol=1e-10)


@pytest.mark.slow
def test_a_chain_stretched_out_too_short_sags():
    """Ten links of 1.2 m drawn over 10 m in one line: their lengths cannot be reached to first order from there."""
    nodes = {f"N{i}": kt.Node(at=(i, 0), mass=1.0 if 0 < i < 10 else 0.0) for i in range(11)}
    bars = {f"b{i}": kt.Bar(ends=(f"N{i}", f"N{i + 1}"), length=1.2) for i in range(10)}
    found = kt.statics.equilibrium(kt.Model(nodes=nodes, fixed=["N0", "N10"], bars=bars, gravity=(0, -G)))
    x = found.position.values
    np.testing.assert_allclose(x[::-1] * [-1, 1] + [10, 0], x, atol=1e-9)  # alike on both sides, and below
    assert x[1:-1, 1].max() < 0 and found.stable
    pull = found.member_force.values * np.diff(x[:, 0]) / 1.2
    np.testing.assert_allclose(pull, pull[0], rtol=1e-11)  # one horizontal force all along


def simplex(twist=150.0, prestress=100.0):
    """A three-strut prism: rigid struts, prestressed cables; nothing fixed but what keeps it in place."""
    low = [(np.cos(a), np.sin(a), 0.0) for a in np.radians([0, 120, 240])]
    high = [(np.cos(a), np.sin(a), 1.2) for a in np.radians([twist, twist + 120, twist + 240])]
    nodes = {f"L{k}": at for k, at in enumerate(low)} | {f"H{k}": at for k, at in enumerate(high)}
    cable = {"kind": "cable", "stiffness": 5e4, "pretension": prestress}
    bars = {f"{side}{k}": kt.Bar(ends=(f"{side}{k}", f"{side}{(k + 1) % 3}"), **cable) for side in "LH" for k in range(3)}
    pairs = [("s", 0, 0), ("s", 1, 1), ("s", 2, 2), ("v", 0, 2), ("v", 1, 0), ("v", 2, 1)]
    for sort, a, b in pairs:
        ends = (f"L{a}", f"H{b}")
        bars[f"{sort}{a}"] = kt.Bar(ends=ends) if sort == "s" else kt.Bar(ends=ends, **cable)
    return kt.Model(nodes=nodes, fixed={"L0": "xyz"}, bars=bars)


def test_simplex_finds_its_twist():
    """Self-stress of the prism exists at a twist of 150 degrees only: strut, vertical, horizontal = -1 : 1 : 1/sqrt(3)."""
    found = kt.statics.equilibrium(simplex(twist=140.0, prestress=8e3))
    x = found.position
    density = found.member_force / found.length
    q = density.sel(member="v0").item()
    np.testing.assert_allclose(density.sel(member=["s0", "s1", "s2"]), -q, rtol=1e-9)
    np.testing.assert_allclose(density.sel(member=["v1", "v2"]), q, rtol=1e-9)
    np.testing.assert_allclose(density.sel(member=["L0", "L1", "L2", "H0", "H1", "H2"]), q / np.sqrt(3), rtol=1e-9)
    low, high = (x.sel(node=[f"{side}{k}" for k in range(3)]).values for side in "LH")
    axis = high.mean(axis=0) - low.mean(axis=0)
    one, two = low[0] - low.mean(axis=0), high[0] - high.mean(axis=0)
    turn = np.degrees(np.arctan2(np.cross(one, two) @ axis / np.linalg.norm(axis), one @ two))
    assert abs(turn) == pytest.approx(150.0, abs=1e-7)
    # three turns about the fixed node are left free, nothing else; prestress holds the twist
    assert found.data.attrs["neutral"] == 3 and found.data.attrs["unstable"] == 0


@pytest.mark.slow
def test_large_net_in_reasonable_time():
    found = kt.statics.equilibrium(net(26))
    assert found.data.attrs["residual"] < 1e-9 and found.data.attrs["unstable"] == 0
    assert found.data.sizes["mode"] == 0 and found.position.min().item() < -0.1


@pytest.mark.slow
def test_failures():
    model = chain(2)
    with pytest.raises(AnalysisError, match=r"cannot be closed.*'(rope|b1|b2)' is off by") as caught:
        kt.statics.equilibrium(model.with_(bars=model.bars | {"rope": kt.Bar(ends=("N0", "N2"), length=3.5)}))
    assert caught.value.result.status is kt.Status.NOT_CONVERGED
    falling = kt.Model(nodes={"A": (0, 0), "B": kt.Node(at=(1, 0), mass=1.0)}, fixed=["A"], gravity=(0, -G))
    with pytest.raises(
        AnalysisError, match=r"No equilibrium was found.*After 50 steps 1 of the largest force is left on 'B'"
    ) as caught:
        kt.statics.equilibrium(falling, max_steps=50)
    assert caught.value.result.status is kt.Status.NO_EQUILIBRIUM
    found = kt.statics.equilibrium(falling, max_steps=50, raise_on_failure=False)
    assert found.status is kt.Status.NO_EQUILIBRIUM
    for fields, text in (
        ({"load_case": "x"}, "No load case called 'x'"), ({"lengths": {"b3": 1.0}}, "No held length or angle called 'b3'"),
        ({"lengths": {"b1": -1.0}}, "Give a length greater than 0"), ({"start": np.zeros((2, 2))}, "position: shape"),
        ({"start": np.full((3, 2), np.nan)}, r"position\[\'N0\', 0\]: nan"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=text):
            kt.statics.equilibrium(model, **fields)
    with pytest.raises(ModelError, match="M9"):
        kt.statics.equilibrium(model, tasks={"M9": kt.Free()})
    bay = kt.library.vgt.double_octahedral()
    with pytest.raises(InputError, match="Quintic, which has no meaning at rest"):
        kt.statics.equilibrium(bay, tasks={"M9": kt.Quintic(moves={"M9": (1.1, 1.2)}, duration=1.0)})


def test_following_loads_alone_are_loads():
    """A triangle of elastic bars under inner pressure: N = p L/(2 sqrt 3), so L = L0/(1 - p L0/(2 sqrt 3 EA))."""
    p, EA = 3e4, 2e5
    corners = {"A": (0, 0), "B": (1, 0), "C": (0.5, math.sqrt(3) / 2)}
    model = kt.Model(
        nodes=corners, fixed={"A": "xy", "B": "y"},
        bars={a + b: kt.Bar(ends=(a, b), kind="elastic", stiffness=EA) for a, b in ("AB", "BC", "CA")},
        loads={a + b: kt.Pressure(face=(b, a), pressure=p) for a, b in ("AB", "BC", "CA")},
    )  # fmt: skip
    rest = kt.statics.equilibrium(model)
    length = 1 / (1 - p / (2 * math.sqrt(3) * EA))
    assert rest.length.values == pytest.approx([length] * 3, rel=1e-9)
    assert rest.member_force.values == pytest.approx([p * length / (2 * math.sqrt(3))] * 3, rel=1e-9)


def test_a_given_torque_alone_is_a_load():
    """An arm of an elastic bar turned by its motor against a spring: the spring's moment about the axis is the torque."""
    spring = {"kind": "elastic", "stiffness": 1e4}
    model = kt.Model(
        nodes={"A": (0, 0), "P": (1, 0), "C": (1, -1)}, fixed=["A", "C"],
        bars={"arm": kt.Bar(ends=("A", "P"), **spring), "stay": kt.Bar(ends=("C", "P"), **spring)},
        drives={"motor": kt.AngleDrive("arm")},
    )  # fmt: skip
    rest = kt.statics.equilibrium(model, tasks={"motor": kt.GivenForce(torque=500.0)})
    P = rest.position.sel(node="P").values
    back = rest.member_force.sel(member="stay").item() * (np.array([1, -1]) - P) / rest.length.sel(member="stay").item()
    assert P[0] * back[1] - P[1] * back[0] == pytest.approx(-500.0, rel=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize("strain", ["engineering", "green"])
@pytest.mark.parametrize("above", [1e-4, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10])
def test_just_above_its_limit_load_a_von_mises_truss_snaps_through_and_just_below_it_stays(strain, above):
    rise, length = 0.3, math.hypot(1.0, 0.3)
    limit = 2 * (length ** (2 / 3) - 1) ** 1.5 if strain == "engineering" else (rise / length) ** 2 * rise * 2 / 3**1.5

    def height(load):
        model = kt.library.mechanisms.von_mises(rise=rise, strain=strain, load=load)
        found = kt.statics.equilibrium(model)
        y = found.position.sel(node="T", axis="y").item()
        side = math.hypot(1.0, y)
        carried = 2 * (length - side) * y / side if strain == "engineering" else (rise**2 - y**2) * y / length**2
        assert carried == pytest.approx(load, rel=1e-12)
        return y

    assert height(limit * (1 + above)) < -rise
    assert 0 < height(limit * (1 - above)) < rise


def test_a_coordinate_drive_is_held_where_it_is_told():
    """Two springs on a slider: the drive carries what the bar pulls with along its axis."""
    model = kt.Model(nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1)}, fixed={"A": "xy", "B": "y"},
                     bars={f"{end}c".lower(): kt.Bar(ends=(end, "C"), kind="elastic", stiffness=1e4) for end in "AB"},
                     loads={"p": kt.NodalForce(node="C", force=(0.0, -100.0))},
                     drives={"push": kt.CoordinateDrive(node="B", axis="x")})  # fmt: skip
    for place in (1.2, 0.4):
        found = kt.statics.equilibrium(model, lengths={"push": place})
        x = found.position.values
        np.testing.assert_allclose(x[1], [place, 0.0], atol=1e-15)
        u = (x[2] - x[1]) / np.linalg.norm(x[2] - x[1])
        assert found.drive_force.item() == pytest.approx(-found.member_force.sel(member="bc").item() * u[0], rel=1e-9)
        np.testing.assert_allclose(found.member_force, 1e4 * (found.length.values - [np.sqrt(2), 1.0]), rtol=1e-9)
    path = kt.statics.path(model, "p", lengths={"push": 1.2}, points=3)
    np.testing.assert_allclose(path.position.sel(node="B", axis="x"), 1.2)
    for bad, message in (
        ({"push": np.nan}, "Give a finite number"),
        ({"push": "far"}, "Give a finite number"),
        ({"pus": 1.0}, "Did you mean 'push'"),
    ):
        with pytest.raises(kt.InputError, match=message):
            kt.statics.equilibrium(model, lengths=bad)
    with pytest.raises(kt.InputError, match="released by its task"):
        kt.statics.equilibrium(model, lengths={"push": 1.0}, tasks={"push": kt.Free()})


@pytest.mark.slow
@pytest.mark.parametrize("sought", [kt.statics.buckling, kt.statics.path])
def test_lengths_that_cannot_be_closed_end_paths_and_buckling_too(sought):
    model = kt.Model(nodes={"A": (0, 0), "B": (2, 0), "C": (1, 1)}, fixed=["A", "B"],
                     bars={"a": kt.Bar(ends=("A", "C"), kind="driven"), "b": ("C", "B")},
                     loads={"p": kt.NodalForce(node="C", force=(0.0, -1.0))})  # fmt: skip
    with pytest.raises(kt.AnalysisError, match="is off by"):
        sought(model, "p", lengths={"a": 0.1})


def test_redundant_rigid_bars_are_named_once_and_elastic_ones_are_not():
    at = {"A": (-1, 1), "B": (0, 1), "C": (1, 1), "D": (2, 0), "P": {"at": (0, 0), "mass": 2.0}}
    bars = {"left": ("A", "P"), "middle": ("B", "P"), "right": ("C", "P"), "tie": ("D", "P")}
    common = {"nodes": at, "fixed": ["A", "B", "C", "D"], "gravity": (0, -9.81)}
    sentence = "The force of these members is not unique (redundant structure): left, middle, right."
    star = kt.Model(**common, bars=bars | {"tie": kt.Bar(ends=("D", "P"), kind="elastic", stiffness=1e3)})
    found = kt.statics.equilibrium(star)
    assert found.message == sentence
    assert found.data.attrs["not_unique"] == ["left", "middle", "right"]
    # what is given is in balance, whatever the share
    s, m, _, _ = found.member_force.values / (2.0 * 9.81)
    assert m + 2 * s / np.sqrt(2) == pytest.approx(1.0, abs=1e-12)
    run = kt.run(star.with_(runs={"rest": kt.Run(analysis="statics.equilibrium")}))
    assert run.forces["all"].message.count(sentence) == 1
    two = star.with_(bars={name: star.bars[name] for name in ("left", "right", "tie")})
    unique = kt.statics.equilibrium(two)
    assert (unique.message, unique.data.attrs["not_unique"]) == ("", [])
