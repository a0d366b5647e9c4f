"""Quantities that a model defines: closed forms, rates against complex steps and differences, turns, units, faults."""

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.kernels.coordinates.on_arrays import series_on_arrays
from kinetruss.kinematics.quantity_histories import _Made, quantities
from kinetruss.mechanics import compile
from kinetruss.model.expressions import looked_up, read_expression

A, B, C, D = 0.1, 0.32, 0.25, 0.4
"""Crank, coupler, rocker and ground of a crank-rocker: 0.1 + 0.4 < 0.32 + 0.25 (Grashof)."""


def crank_rocker(**more):
    """At the crank angle of 60 degrees."""
    pin = np.array([A * np.cos(np.pi / 3), A * np.sin(np.pi / 3)])
    away = np.array([D, 0.0]) - pin
    far = np.hypot(*away)
    turned = np.arctan2(away[1], away[0]) + np.arccos((B**2 + far**2 - C**2) / (2 * B * far))
    joint = pin + B * np.array([np.cos(turned), np.sin(turned)])
    return kt.Model(
        nodes={"A": (0, 0), "B": tuple(pin), "C": tuple(joint), "D": (D, 0)},
        fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("D", "C")},
        drives={"motor": kt.AngleDrive("crank")},
        **more,
    )


def turned(model, turns=1.0, samples=73, drive="motor"):
    return kt.kinematics.follow(model, kt.ConstantRate(rates={drive: 2 * np.pi * turns}, duration=1.0), samples=samples)


def of(model, motion, text):
    return quantities(model, motion, {"q": text}).sel(quantity="q")


def test_the_transmission_angle_of_a_four_bar_is_that_of_its_formula():
    """cos mu = (b^2 + c^2 - a^2 - d^2 + 2 a d cos theta)/(2 b c): Hain, Applied Kinematics (1967), section 2."""
    model = crank_rocker()
    motion = turned(model)
    theta = np.pi / 3 + 2 * np.pi * motion.time.values
    formula = np.arccos((B**2 + C**2 - A**2 - D**2 + 2 * A * D * np.cos(theta)) / (2 * B * C))
    found = of(model, motion, "angle(coupler, rocker)")
    np.testing.assert_allclose(np.abs(found.value), formula, atol=1e-12)
    # d mu/d theta = a d sin theta/(b c sin mu)
    slope = A * D * np.sin(theta) / (B * C * np.sin(formula)) * 2 * np.pi
    np.testing.assert_allclose(found.rate * np.sign(found.value), slope, atol=1e-11)


def test_a_slider_crank_has_the_place_the_velocity_and_the_acceleration_of_its_formulas():
    r, length, w = 0.05, 0.18, 3.0
    model = kt.library.mechanisms.slider_crank(crank=r, rod=length)
    drive = next(iter(model.all_drives))
    motion = kt.kinematics.follow(model, kt.ConstantRate(rates={drive: w}, duration=2.0), samples=41)
    theta = of(model, motion, f"drive({drive})")
    q, slider = theta.value.values, "S"
    root = np.sqrt(length**2 - (r * np.sin(q)) ** 2)
    first = -r * np.sin(q) - r**2 * np.sin(q) * np.cos(q) / root
    second = -r * np.cos(q) - r**2 * np.cos(2 * q) / root - r**4 * (np.sin(q) * np.cos(q)) ** 2 / root**3
    found = of(model, motion, f"{slider}.x")
    np.testing.assert_allclose(found.value, r * np.cos(q) + root, atol=1e-12)
    np.testing.assert_allclose(found.rate, first * w, atol=1e-12)
    np.testing.assert_allclose(found.second_rate, second * w**2, atol=1e-11)
    # by virtual work a force on the slider is held by the torque F dx/dtheta
    ratio = of(model, motion, f"rate({slider}.x)/rate(drive({drive}))")
    np.testing.assert_allclose(ratio.value, first, atol=1e-13)
    np.testing.assert_allclose(ratio.rate, second * w, atol=1e-12)
    assert ratio.quantity_unit.item() == "m/rad"
    assert np.isnan(ratio.second_rate).all()


def test_a_scotch_yoke_moves_as_a_cosine():
    model = kt.Model(
        nodes={"A": (0, 0), "B": (0.1, 0), "S": (0.1, 0.2)},
        fixed={"A": "xy", "S": "y"},
        bars={"crank": ("A", "B")},
        drives={"motor": kt.AngleDrive("crank")},
        couplings={
            "slot": kt.Coupling(
                terms=[(kt.CoordinateDrive(node="S", axis="x"), 1), (kt.CoordinateDrive(node="B", axis="x"), -1)]
            )
        },
    )
    motion = turned(model)
    t = 2 * np.pi * motion.time.values
    found = of(model, motion, "S.x")
    np.testing.assert_allclose(found.value, 0.1 * np.cos(t), atol=1e-12)
    np.testing.assert_allclose(found.rate, -0.1 * 2 * np.pi * np.sin(t), atol=1e-11)


def test_the_roll_centre_of_a_symmetric_suspension_is_that_of_similar_triangles():
    """Arms that meet at the instant centre (p, h); the line from the contact to it cuts the middle plane at the roll centre."""
    p, h, half = -2.0, 0.1, 0.75
    low, high = (0.3, 0.2), (0.35, 0.5)

    def towards(point, share):
        return (point[0] + share * (point[0] - p), point[1] + share * (point[1] - h))

    model = kt.Model(
        nodes={"a": low, "b": towards(low, 0.15), "c": high, "d": towards(high, 0.12), "w": (half, 0.0)},
        fixed=["a", "c"],
        bars={"lower": ("a", "b"), "upper": ("c", "d"), "hub": ("b", "d"), "g1": ("b", "w"), "g2": ("d", "w")},
        drives={"jounce": kt.AngleDrive("lower")},
        quantities={
            "centre_x": "meet(a, b, c, d).x",
            "centre_y": "meet(a, b, c, d).y",
            # the point on the line from the contact to the instant centre at x = 0
            "roll_centre": "w.y - w.x*(meet(a, b, c, d).y - w.y)/(meet(a, b, c, d).x - w.x)",
        },
    )
    motion = kt.kinematics.follow(
        model, kt.Quintic(moves={"jounce": (np.arctan2(low[1] - h, low[0] - p),) * 2}, duration=1.0), samples=2
    )
    found = quantities(model, motion).value[0]
    np.testing.assert_allclose(found, [p, h, h * half / (half - p)], atol=1e-12)


PLANE = [
    "B.x", "C.y - 20*mm", "length(coupler)", "distance(A, C)", "distance(A, C)**2", "distance(A, C)**-1.5", "angle(rocker)",
    "angle(rocker, crank)", "angle(C - A)", "dot(B - A, C - D)", "cross(crank, rocker).x", "length(cross(crank, rocker))",
    "unit(rocker).x", "meet(A, B, D, C + ex*0.1*m).y", "sin(motor)", "cos(2*motor)", "tan(angle(rocker)/3)",
    "asin(B.x/(0.5*m))", "acos(B.x/(0.5*m))", "atan(B.y/C.y)", "atan2(B.y, C.x)", "sqrt(C.y/m)", "abs(B.x + 1*m)",
    "-(C - B).y/2", "(C.x + B.x)*angle(rocker)", "3*angle(rocker) - 2*angle(crank)", "length(2*coupler - rocker/3)",
]  # fmt: skip
SPACE = [
    "angle(p, q)", "angle(p, q, ez)", "angle(ey, P - O, ex)", "normal(O, P, Q).z", "meet(O, P, R, Q + ez*m, ey).x",
    "angle(normal(O, P, Q), ez)", "dot(cross(p, q), R - O)", "length(cross(p, q))", "(P - Q).z", "turn",
]  # fmt: skip


def spatial():
    return kt.Model(
        nodes={"O": (0, 0, 0), "P": (1, 0.2, 0.3), "Q": (0.1, 0.9, -0.4), "R": (0.2, -0.3, 1.1)},
        fixed=["O"],
        bars={"p": ("O", "P"), "q": ("O", "Q")},
        drives={"turn": kt.AngleDrive("p", axis="z")},
    )


def series_of(model, text, known):
    made = _Made(compile(model), [])
    value = made.program.scalar(made.of(looked_up(model, read_expression(text))))
    return series_on_arrays(made.program, [value], known)[:, 0]


@pytest.mark.parametrize(("model", "text"), [(crank_rocker, one) for one in PLANE] + [(spatial, one) for one in SPACE])
def test_rates_are_those_of_complex_steps(model, text):
    """c1 is the derivative along v; that of c1 along v, with the accelerations, is 2 c2."""
    model = model()
    system = compile(model)
    generator = np.random.default_rng(7)
    x = system.x0.reshape(-1)
    v, a = generator.normal(size=(2, x.size))
    if system.dim == 2:
        v[2::3] = a[2::3] = 0.0
    known = np.stack([x, v, 0.5 * a])[:, :, None]
    value, first, second = series_of(model, text, known)[:, 0]
    h = 1e-30
    step = np.stack([x + 1j * h * v, v + 1j * h * a, 0.5 * a + 0j])[:, :, None]
    moved = series_of(model, text, step)[:, 0].imag / h
    assert np.isfinite([value, first, second]).all()
    assert first == pytest.approx(moved[0], rel=1e-12, abs=1e-12)
    assert 2 * second == pytest.approx(moved[1], rel=1e-11, abs=1e-11)


@pytest.mark.parametrize(
    "text", ["rate(angle(rocker))", "length(rate(C))", "rate(C.x)/rate(motor)", "rate(angle(rocker))**2*C.y"]
)
def test_rates_within_expressions_agree_with_differences(text):
    model = crank_rocker()
    h = 1e-4
    motion = kt.kinematics.follow(
        model, kt.ConstantRate(rates={"motor": 2.0}, duration=1.0), times=[0.4 - 2 * h, 0.4 - h, 0.4, 0.4 + h, 0.4 + 2 * h]
    )
    found = of(model, motion, text)
    y = found.value.values
    slope = (8 * (y[3] - y[1]) - (y[4] - y[0])) / (12 * h)
    assert found.rate.values[2] == pytest.approx(slope, rel=1e-9, abs=1e-9)
    assert np.isnan(found.second_rate).all()


def test_a_rate_of_a_rate_is_the_second_rate():
    model = crank_rocker()
    motion = turned(model)
    twice, once = of(model, motion, "rate(rate(angle(rocker)))"), of(model, motion, "angle(rocker)")
    np.testing.assert_allclose(twice.value, once.second_rate, rtol=1e-13)
    assert np.isnan(twice.rate).all()


@pytest.mark.parametrize("samples", [5, 9, 200])
def test_angles_count_on_over_full_turns(samples):
    model = crank_rocker()
    motion = turned(model, turns=3.0, samples=samples)
    found = of(model, motion, "angle(crank)")
    np.testing.assert_allclose(found.value, motion.drive_position.sel(drive="motor"), atol=1e-11)
    backwards = turned(model, turns=-2.25, samples=samples)
    np.testing.assert_allclose(of(model, backwards, "angle(crank)/2").value[-1], np.pi / 6 - 2.25 * np.pi, atol=1e-11)


def test_the_run_folder_counts_turns_over_all_its_blocks(tmp_path):
    run = kt.Run(trajectory=kt.ConstantRate(rates={"motor": 20.0}, duration=1.0), samples=101)
    model = crank_rocker(quantities={"turn": "angle(crank)"}, runs={"go": run})
    kt.run(model, out=tmp_path / "go", block=17)
    found = kt.runs.load(tmp_path / "go").quantities["all"]
    np.testing.assert_allclose(found.value[:, 0], np.pi / 3 + 20.0 * found.time, atol=1e-11)


def test_turns_that_the_samples_do_not_tell_are_not_known():
    """A given motion, sampled too coarsely: the value is NaN from there on, its rate is known."""
    model = kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"b": ("A", "B")})
    t = np.array([0.0, 0.1, 0.2, 1.2])
    angle, rate = 2 * t**4, 8 * t**3
    x = np.stack([np.zeros((4, 2)), np.stack([np.cos(angle), np.sin(angle)], axis=1)], axis=1)
    v = rate[:, None, None] * np.stack([-x[:, :, 1], x[:, :, 0]], axis=2)
    a = 24 * t[:, None, None] ** 2 * np.stack([-x[:, :, 1], x[:, :, 0]], axis=2) - rate[:, None, None] ** 2 * x
    found = of(model, kt.kinematics.from_arrays(model, t, x, v, a), "angle(b)")
    np.testing.assert_allclose(found.value[:3], angle[:3], atol=1e-12)
    assert np.isnan(found.value[3])
    np.testing.assert_allclose(found.rate, rate, atol=1e-9)


def test_simulations_and_inverse_kinematics_have_them_too():
    swing = kt.Model(
        nodes={"A": (0, 0), "B": {"at": (1, 0), "mass": 1.0}}, fixed=["A"], bars={"b": ("A", "B")}, gravity=(0, -9.81),
        quantities={"angle": "angle(b)", "energy": "rate(angle)**2/2"},
    )  # fmt: skip
    found = quantities(swing, kt.dynamics.simulate(swing, t_end=2.0))
    angle, rate = found.value.sel(quantity="angle"), found.rate.sel(quantity="angle")
    # w^2/2 = -g/l sin q from rest at q = 0
    np.testing.assert_allclose(found.value.sel(quantity="energy"), -9.81 * np.sin(angle), atol=1e-8)
    np.testing.assert_allclose(found.second_rate.sel(quantity="angle"), -9.81 * np.cos(angle), atol=1e-8)
    assert abs(rate).max() > 4


def test_at_rest_there_are_values_without_rates_and_linear_statics_has_their_change():
    frame = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (0, 1)}, fixed={"A": "xy", "C": "x"},
        bars={"b": ("A", "B"), "c": ("C", "B"), "v": ("A", "C")},
        section=kt.Rod(diameter=0.01), material=kt.Material(E=200e9, density=0.0),
        loads={"P": kt.NodalForce(node="B", force=(50, -100))},
        quantities={"d": "distance(C, B)", "q": "angle(b)", "w": "rate(angle(b))"},
    )  # fmt: skip
    linear = kt.statics.linear(frame)
    found = quantities(frame, linear)
    u = linear.displacement.sel(node="B").values, linear.displacement.sel(node="C").values
    direction = np.array([1.0, -1.0]) / np.sqrt(2)
    assert found.value.sel(quantity="d").item() == pytest.approx(np.sqrt(2) + direction @ (u[0] - u[1]), abs=1e-15)
    assert found.value.sel(quantity="q").item() == pytest.approx(u[0][1], abs=1e-18)
    assert np.isnan(found.value.sel(quantity="w"))
    assert set(found.data_vars) == {"value"}
    bars = {name: one.with_(kind="elastic") for name, one in frame.bars.items()}
    exact = quantities(frame, kt.statics.equilibrium(frame.with_(bars=bars)))
    np.testing.assert_allclose(exact.value[:2], found.value[:2], rtol=0, atol=1e-8)


def test_poses_have_the_angle_nearest_to_that_of_the_model():
    poses = {"up": {"motor": "90 deg"}, "far": {"motor": "200 deg"}, "back": {"motor": "-100 deg"}}
    model = crank_rocker(
        quantities={"q": "angle(crank)"}, runs={"rest": kt.Run(analysis="statics.at_poses", poses=poses)}, gravity=(0, -9.81),
        section=kt.Rod(diameter=0.01), material="steel_s235",
    )  # fmt: skip
    found = kt.run(model, "rest").quantities["all"]
    np.testing.assert_allclose(np.degrees(found.value[:, 0]), [90, 200, -100], atol=1e-9)


@settings(max_examples=25, deadline=None)
@given(st.floats(-3.0, 3.0), st.floats(-2.0, 2.0), st.floats(-2.0, 2.0))
def test_angles_and_distances_of_parts_do_not_depend_on_where_the_model_stands(turn, dx, dy):
    names = {
        "mu": "angle(coupler, rocker)",
        "d": "distance(B, D)",
        "s": "length(rate(C))",
        "r": "rate(angle(rocker))/rate(angle(crank))",
    }
    model = crank_rocker()
    R = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    moved = model.with_(nodes={name: tuple(R @ one.at + [dx, dy]) for name, one in model.nodes.items()})
    one, other = (quantities(each, turned(each, samples=4), names).value for each in (model, moved))
    np.testing.assert_allclose(one, other, atol=1e-10)


FAULTS = {
    "angle(rokcer)": "Did you mean 'rocker'",
    "angel(rocker)": "has no function 'angel'. Did you mean 'angle'",
    "C.y - 0.02": "puts together what is in m and what is in plain. Give a plain number its unit",
    "C": "is a vector. Take a component",
    "C.w": "has no part 'w'",
    "C + angle(rocker)": "puts a vector and a number together",
    "sin(C.y)": "takes an angle or a plain number, not one in m",
    "angle(rocker, C.x)": "takes a vector; or a vector, a vector in the plane; it has a vector, a number",
    "rocker*coupler": "multiplies or divides by a vector",
    "C.x**(1/3)": "Exponents are whole or half numbers",
    "__import__('os')": "has no function '__import__'",
    "(lambda: 1)()": "may not stand here",
    "[C.x]": "may not stand here",
    "C.x if C.y else B.x": "may not stand here",
    "C.x.real": "has no part 'real'",
    "q": "needs itself: q of q",
    "C.x +": "is no expression",
    "1e999*C.x": "too large",
    "twin.x": "is a node and a member",
    "(" * 300: "is no expression",
    "-" * 400 + "C.x": "operations in each other",
    "C.x" + "+C.x" * 300: "characters",
}


@pytest.mark.parametrize("text", FAULTS)
def test_faults_say_what_is_wrong_and_how_to_mend_it(text):
    model = crank_rocker()
    nodes, bars = {**model.nodes, "twin": (0.2, 0.9)}, {**model.bars, "twin": ("twin", "C")}
    with pytest.raises(kt.ModelError) as caught:
        model.with_(nodes=nodes, bars=bars, quantities={"q": text})
    assert FAULTS[text] in str(caught.value)
    assert "quantities" in str(caught.value)


def test_limits_have_the_unit_of_their_quantity():
    with pytest.raises(kt.ModelError, match=r"has the unit of a length, but 'q' is in rad"):
        crank_rocker(quantities={"q": {"value": "angle(rocker)", "limits": ["0 mm", "3 mm"]}})
    with pytest.raises(kt.ModelError, match=r"is in rad/s"):
        crank_rocker(quantities={"q": {"value": "rate(angle(rocker))", "limits": [None, "3 mm"]}})
    with pytest.raises(kt.ModelError, match="is not less than"):
        crank_rocker(quantities={"q": {"value": "C.x", "limits": ["3 mm", "1 mm"]}})


def test_limits_hold_in_the_load_cases_that_are_named():
    """A rod of 1 m stretches by P L/(E A); its limit is asked for in the combinations of serviceability alone."""
    rod = kt.Model(
        nodes={"A": (0, 0), "B": (0, -1)},
        fixed={"A": "xy", "B": "x"},
        bars={"rod": kt.Bar(ends=("A", "B"), section=kt.Rod(diameter=0.01), material="steel_s235")},
        loads={"hook": kt.NodalForce(node="B", force=(0, -2e3))},
        load_cases={"G": {"loads": {"hook": 1}, "category": "permanent"}},
        combinations={"uls": kt.En1990(), "sls": kt.En1990(equations=("6.14b",))},
        quantities={"drop": kt.Quantity("-1*m - B.y", limits=(None, "0.15 mm"), load_cases=("sls",))},
        runs={"stand": kt.Run(analysis="statics.linear")},
    )
    run = kt.run(rod, "stand")
    assert {row.load_case for row in run.finding.quantities} == {"sls.G"}
    assert run.finding.state == "ok"
    assert run.finding.quantities[0].value == pytest.approx(2e3 / (210e9 * np.pi / 4 * 1e-4), rel=1e-6)
    everywhere = rod.with_(quantities={"drop": rod.quantities["drop"].with_(load_cases=None)})
    assert kt.run(everywhere, "stand").finding.state != "ok"  # 1.35 times as much
    with pytest.raises(kt.ModelError, match="no load case called 'slz'. Did you mean 'sls'"):
        rod.with_(quantities={"drop": rod.quantities["drop"].with_(load_cases=("slz",))})
    with pytest.raises(kt.ModelError, match="load_cases say where limits apply"):
        kt.Quantity("B.y", load_cases=("sls",))


@pytest.mark.parametrize(
    ("limits", "used"),
    [
        ((None, 4.0), [0.0, 0.0, 0.5, 1.5]),
        ((-4.0, None), [0.75, 0.0, 0.0, 0.0]),
        ((1.0, None), [np.inf, np.inf, 0.5, 1 / 6]),
        ((None, -1.0), [1 / 3, np.inf, np.inf, np.inf]),
        ((0.0, None), [np.inf, 0.0, 0.0, 0.0]),
        ((-4.0, 8.0), [5 / 6, 1 / 3, 0.0, 2 / 3]),
    ],
)
def test_utilisation_of_limits(limits, used):
    from kinetruss.runs.quantity_limits import limit_rows

    values = np.array([-3.0, 0.0, 2.0, 6.0])
    model = crank_rocker(quantities={"q": kt.Quantity("C.x/m", limits=limits)})
    for value, expected in zip(values, used, strict=True):
        data = xr.Dataset({"value": ("quantity", [value])}, coords={"quantity": ["q"], "quantity_unit": ("quantity", [""])})
        (row,) = limit_rows(model, {"all": data})
        assert row.utilisation == pytest.approx(expected)


def test_names_that_are_no_words_of_python_stand_in_quotes():
    model = kt.Model(nodes={"n-1": (0, 0), "2": (3, 4)}, fixed=["n-1", "2"], bars={"bar.1": ("n-1", "2")})
    still = kt.kinematics.from_arrays(
        model, [0.0, 1.0], *([[list(n.at) for n in model.nodes.values()]] * 2,), np.zeros((2, 2, 2)), np.zeros((2, 2, 2))
    )
    found = quantities(model, still, {"a": 'distance("n-1", "2")', "b": 'length("bar.1")', "c": 'node("2").y'})
    assert found.value[0].values.tolist() == [5.0, 5.0, 4.0]


def test_a_result_of_another_model_is_refused():
    motion = turned(crank_rocker(), samples=3)
    with pytest.raises(kt.InputError, match="Give a result of this model"):
        quantities(spatial().with_(nodes={"O": (0, 0, 0), "P": (1, 0, 0), "Q": (0, 1, 0)}), motion, {"q": "P.x"})
    with pytest.raises(kt.InputError, match="has no positions"):
        quantities(crank_rocker(), kt.results.Result(data=motion.data[["drive_position"]]), {"q": "B.x"})


# Forces in quantities.

LOAD, AREA = 30e3, np.pi / 4 * 0.06**2
"""Weight on a piston, N, and the area of its bore, m^2."""


def lifted(**more):
    """A load on a piston, between rails without friction, fed with a given flow: p = load/area at any speed."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (0, 1)},
        fixed={"A": "xy", "B": "x"},
        bars={"rod": kt.Bar(ends=("A", "B"), kind="free")},
        drives={"up": kt.CoordinateDrive(node="B", axis="y")},
        loads={"load": kt.NodalForce(node="B", force=(0, -LOAD))},
        cylinders={"lift": kt.Cylinder(member="rod", bore=0.06, rod=0.03, pressure_A=LOAD / AREA)},
        trajectories={"rise": kt.ConstantRate(rates={"up": 0.1}, duration=1.0)},
        runs={
            "forces": kt.Run(analysis="dynamics.inverse", trajectory="rise", samples=5),
            "motion": kt.Run(analysis="kinematics.follow", trajectory="rise", samples=5),
        },
        **more,
    )


def test_forces_in_expressions_are_those_of_the_result():
    """Power is force times rate, so the sum over drives is the power of the result; vectors have components and lengths."""
    model = crank_rocker(section=kt.Rectangle(width=0.02, height=0.005), material="steel_s235", gravity=(0, -9.81))
    motion = turned(model, samples=9)
    forces = kt.dynamics.inverse(model, motion)
    texts = {
        "torque": "torque(motor)",
        "power": "power(motor)",
        "bar": "force(coupler)",
        "size": "length(reaction(A))/N",
        "up": "reaction(A, ey) + 1*kN",
        "dot": "dot(reaction(D), rate(node(C)))",
    }
    found = quantities(model, forces, texts)
    assert found.quantity_unit.values.tolist() == ["N m", "W", "N", "", "N", "W"]
    got = {name: found.value.sel(quantity=name).values for name in texts}
    force = forces.reaction.sel(support="A").values
    np.testing.assert_array_equal(got["torque"], forces.drive_force[:, 0])
    np.testing.assert_allclose(got["power"], forces.power, rtol=1e-12)
    np.testing.assert_array_equal(got["bar"], forces.member_force.sel(member="coupler"))
    np.testing.assert_allclose(got["size"], np.hypot(*force.T), rtol=1e-14)
    np.testing.assert_allclose(got["up"], force[:, 1] + 1e3, rtol=1e-14)
    speed = motion.velocity.sel(node="C").values
    np.testing.assert_allclose(got["dot"], (forces.reaction.sel(support="D").values * speed).sum(axis=1), atol=1e-12)
    assert np.isnan(found.rate).all()
    np.testing.assert_array_equal(quantities(model, motion, {"t": "torque(motor)"}).value, np.full((9, 1), np.nan))


def test_limits_of_pressures_and_forces_are_checked_where_forces_are_known(tmp_path):
    """Pressure that carries the load: 30 kN over 28.3 cm^2 is 106.1 bar; drives then have nothing to do."""
    limits = {"p": ("pressure_A(lift)", "200 bar"), "F": ("thrust(lift)", "29 kN"), "P": ("power(up)", "1 kW")}
    model = lifted(quantities={name: kt.Quantity(text, limits=(None, most)) for name, (text, most) in limits.items()})
    rows = {row.part: row for row in kt.run(model, "forces").finding.quantities}
    assert rows["p"].value == pytest.approx(LOAD / AREA)
    assert rows["p"].utilisation == pytest.approx(LOAD / AREA / 200e5)
    assert (rows["F"].status, rows["F"].unit, rows["p"].unit) == ("exceeded", "N", "Pa")
    assert rows["P"].value == pytest.approx(0.0, abs=1e-9)
    only = kt.run(model, "motion").finding
    assert {row.status for row in only.quantities} == {"not checked"}
    assert all("needs forces" in one for one in only.unknown)
    path = kt.write(model, tmp_path / "lift.yaml") or tmp_path / "lift.yaml"
    assert kt.read(path).quantities == model.quantities
    for text, fault in {
        "rate(thrust(lift))": "is the rate of 'thrust(lift)', which has none",
        "torque(up)": "has a force, no torque",
        "reaction(lift)": "no reaction at 'lift'",
        "pressure_A(up)": "has a force, no pressure_A",
        "thrust(lift) + 1*m": "puts together what is in N and what is in m",
        "force(gone)": "no part with a force called 'gone'",
    }.items():
        with pytest.raises(kt.ModelError) as caught:
            model.with_(quantities={"q": text})
        assert fault in str(caught.value)
    with pytest.raises(kt.ModelError, match=r"is in W, but 'q' is in N"):
        model.with_(quantities={"q": kt.Quantity("force(up)", limits=(None, "3 kW"))})


def test_forces_of_statics_and_simulations_are_read_case_by_case():
    """A rod that hangs: the reaction is the load of each case, in small displacements, in equilibrium, and at rest in time."""
    rod = kt.Model(
        nodes={"A": (0, 0), "B": (0, -1)},
        fixed={"A": "xy", "B": "x"},
        bars={"rod": kt.Bar(ends=("A", "B"), kind="elastic", section=kt.Rod(diameter=0.01), material="steel_s235", mass=1e-6)},
        loads={"hook": kt.NodalForce(node="B", force=(0, -2e3))},
        load_cases={"one": {"loads": {"hook": 1}}, "two": {"loads": {"hook": 2}}},
        quantities={"up": kt.Quantity("reaction(A, ey)", limits=(None, "3 kN")), "N": "force(rod)", "long": "length(rod)"},
        runs={"small": kt.Run(analysis="statics.linear"), "large": kt.Run(analysis="statics.equilibrium", load_cases=("two",))},
    )
    small, large = kt.run(rod, "small"), kt.run(rod, "large")
    for name, expected in (("up", (2e3, 4e3)), ("N", (2e3, 4e3))):
        got = [small.quantities[case].value.sel(quantity=name).item() for case in ("one", "two")]
        assert got == pytest.approx(expected, rel=1e-6)
        assert large.quantities["two"].value.sel(quantity=name).item() == pytest.approx(4e3, rel=1e-6)
    assert [row.load_case for row in small.finding.quantities if row.status == "exceeded"] == ["two"]
    linear = kt.statics.linear(rod, load_case="one")
    np.testing.assert_allclose(quantities(rod, linear).value[0], 2e3, rtol=1e-6)


def test_what_loads_do_not_change_is_told_once():
    model = lifted(
        load_cases={"one": {"loads": {"load": 1}}, "two": {"loads": {"load": 2}}},
        quantities={"y": kt.Quantity("B.y", limits=(None, 2)), "F": kt.Quantity("force(up)", limits=(None, "40 kN"))},
    )
    found = kt.run(model, "forces")
    rows = {(row.part, row.load_case): row.value for row in found.finding.quantities}
    assert rows == pytest.approx({("y", "all"): 1.1, ("F", "one"): 0.0, ("F", "two"): LOAD}, abs=1e-6)


def test_functions_of_elements_are_the_results_they_have():
    from kinetruss.elements.cylinder import LAW
    from kinetruss.model.measured_forces import FUNCTIONS

    assert {name: one.unit for name, one in LAW.values.items()} == kt.Cylinder.measured
    assert set(FUNCTIONS) >= set(kt.Cylinder.measured)
