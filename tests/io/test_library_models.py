"""Files that start from a library model, or name library records."""

import pickle

import pytest

import kinetruss as kt


@pytest.fixture
def read(tmp_path):
    """Read a model from text."""

    def reading(text):
        path = tmp_path / "model.yaml"
        path.write_text(text)
        return kt.read(path)

    return reading


def test_library_model_alone(read):
    assert read("library: vgt.triangular\n") == kt.library.vgt.triangular()


def test_parameters_have_units(read):
    model = read("library: {name: vgt.double_octahedral, bays: 2, longeron: 36 in, beta: 5 deg}\ntitle: two\n")
    assert model == kt.library.vgt.double_octahedral(2, longeron=0.9144, beta="5 deg", title="two")


def test_entries_are_laid_over_by_name(read):
    text = """
library: {name: vgt.double_octahedral, tip_force: [0, 0, 46 N], motor: motor_lacy, screw: screw_lacy_spatial}
nodes: {N8: {mass: 3 kg}}
fixed: [N4]
bars: {M1: {section: tube_lacy_planar}, extra: [N1, N9]}
active: {M7: {base: {mass: 4 kg}, limits: [1 m, 2 m]}}
motors: {motor: {max_current: 9 A}}
sections: {tube: {kind: rod, diameter: 1 cm}}
loads: {tip_N7: ~, tip_N8: {force: [1, 2, 3]}}
gravity: ~
safety: {buckling: 2}
"""
    base = kt.library.vgt.double_octahedral(tip_force=(0, 0, 46), motor="motor_lacy", screw="screw_lacy_spatial")
    model = read(text)
    assert model.nodes["N8"] == base.nodes["N8"].with_(mass=3)
    assert model.fixed == base.fixed | {"N4": "xyz"}
    assert model.bars["M1"] == base.bars["M1"].with_(section="tube_lacy_planar")
    assert model.sections["tube_lacy_planar"] == kt.library.sections.TUBE_LACY_PLANAR
    assert model.bars["extra"].ends == ("N1", "N9")
    assert model.active["M7"].base == base.active["M7"].base.with_(mass=4)
    assert model.active["M7"].tube == base.active["M7"].tube
    assert model.motors["motor"] == base.motors["motor"].with_(max_current=9)
    assert model.sections["tube"] == kt.Rod(diameter=0.01)
    assert list(model.loads) == ["tip_N8", "tip_N9"]
    assert model.loads["tip_N8"].force == (1, 2, 3)
    assert model.gravity is None
    assert model.safety == kt.Safety(buckling=2)


def test_records_named_only(read):
    model = read("""
nodes: {A: [0, 0], B: [1, 0], C: [0, 1]}
material: steel_s235
section: tube_lacy_planar
bars: {b: {ends: [A, B], material: invar_36}}
active:
  m: {ends: [A, C], base: {length: 1}, tube: {length: 1}, screw: screw_lacy_planar, gear: gear_lacy, motor: motor_lacy}
""")
    assert model.materials == {name: kt.library.materials.MATERIALS[name] for name in ("steel_s235", "invar_36")}
    assert model.motors["motor_lacy"] == kt.library.drives.MOTOR_LACY
    assert list(model.sections), list(model.screws) == (["tube_lacy_planar"], ["screw_lacy_planar"])


def test_own_records_come_first(read):
    model = read("nodes: {A: [0, 0]}\nmaterial: steel_s235\nmaterials: {steel_s235: {E: 1 GPa, density: 1}}\n")
    assert model.materials["steel_s235"].E == 1e9


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("library: [vgt]\n", "library: does not name a library model"),
        ("library: {bays: 2}\n", "library: does not name a library model"),
        ("library: materials.MATERIALS\n", "no library model called"),
        ("library: {name: vgt.double_octahedral, longeron: 0.5 m}\n", "library.longeron: 0.5 m cannot span"),
        ("library: {name: vgt.double_octahedral, bays: two}\n", "library.bays: 'two' is not a whole number"),
        ("library: {name: vgt.double_octahedral, motor: motor_laci}\n", "library.motor: there is no 'motor_laci'"),
        ("library: vgt.triangular\nnodes: {Q: {mass: 1 kg}}\n", "2:9: nodes.Q.at: 'at' is missing"),
    ],
)
def test_faults(read, text, message):
    with pytest.raises(kt.ModelError, match=message):
        read(text)


def test_faults_of_what_came_from_the_library_are_told_where_it_is_named(read):
    with pytest.raises(kt.ModelError, match=r":2:1: bars\.M1\.orientation: no node called 'N1'"):
        read("kinetruss: 1\nlibrary: vgt.double_octahedral\nnodes: {N1: ~}\nfixed: {N1: ~}\n")


def test_parameters_of_the_library_model_can_be_replaced(tmp_path):
    path = tmp_path / "truss.yaml"
    path.write_text("library: {name: vgt.triangular, material: {E: 71 GPa, density: 2711.5 kg/m^3}}\nnodes: {O2: {mass: 2 kg}}")
    model = kt.io.set_values(kt.read(path), {"library.payload_mass": "40 kg", "library.material.density": "2700 kg/m^3"})
    assert (model.nodes["B"].mass, model.nodes["O2"].mass, model.materials["tube"].density) == (40, 2, 2700)
    # what is changed beside stays, in both orders
    for order in (["nodes.O2.mass", "library.payload_mass"], ["library.payload_mass", "nodes.O2.mass"]):
        other = model.with_(title="Light")
        for one in order:
            other = kt.io.set_value(other, one, 7.0)
        assert (other.title, other.nodes["B"].mass, other.nodes["O2"].mass, other.materials["tube"].density) == (
            "Light",
            7,
            7,
            2700,
        )
    other = kt.io.set_value(pickle.loads(pickle.dumps(model)), "library.payload_mass", "3 kg")
    assert (other.nodes["B"].mass, other.nodes["O2"].mass) == (3, 2)
    path.write_text("library: vgt.triangular")
    model = kt.read(path)
    assert kt.io.set_value(model, "library.payload_mass", 3).nodes["B"].mass == 3
    assert kt.io.set_value(model, "library.material.density", 3).materials["tube"].density == 3  # of the default
    with pytest.raises(kt.ModelError, match="library.payload_mas: .*Did you mean 'payload_mass'"):
        kt.io.set_value(model, "library.payload_mas", 3)
    path.write_text("library: {name: vgt.triangular, material: steel_s235}")
    with pytest.raises(kt.ModelError, match=r"library.material: is not a table in the file. Set it as a whole"):
        kt.io.set_value(kt.read(path), "library.material.density", 3)
    path.write_text("nodes: {A: [0, 0], B: [1, 0]}\nbars: {b: [A, B]}\nfixed: [A]")
    with pytest.raises(kt.ModelError, match="library: the model was not built from a library model"):
        kt.io.set_value(kt.read(path), "library.payload_mass", 3)


def crank_and_rod(crank, rod, at="x"):
    """A slider-crank at a quarter turn."""
    return kt.Model(
        nodes={"O": (0, 0), "A": (0, crank), "B": ((rod**2 - crank**2) ** 0.5, 0)}, fixed={"O": "xy", "B": "y"},
        bars={"crank": ("O", "A"), "rod": ("A", "B")}, drives={"motor": kt.AngleDrive("crank")}, title=at,
        runs={"turn": kt.Run(trajectory=kt.ConstantRate(rates={"motor": 2.0}, duration=0.1), samples=3)},
    )  # fmt: skip


def test_parameters_of_a_function_vary_like_values_of_the_model():
    model = kt.library.parametric(crank_and_rod, crank=0.3, rod=0.5)
    again = kt.io.set_values(model, {"parameters.crank": "200 mm", "bars.rod.mass": "3 kg", "parameters.at": "y"})
    assert (again.nodes["A"].at, again.bars["rod"].mass, again.title) == ((0, 0.2), 3, "y")
    with pytest.raises(kt.ModelError, match=r"parameters.cranc: .*Did you mean 'crank'"):
        kt.io.set_value(model, "parameters.cranc", 1)
    # x_B = sqrt(rod^2 - crank^2); at a quarter turn its velocity is -crank w, whatever the rod
    wrt = ["parameters.crank", "parameters.rod"]
    place, speed = (kt.Response(f"first({name}[B, x])", kt.run, model) for name in ("position", "velocity"))
    assert kt.gradient(place, wrt).values == pytest.approx([-0.3 / 0.4, 0.5 / 0.4], rel=1e-9)
    assert kt.gradient(speed, wrt).values == pytest.approx([-2.0, 0.0], rel=1e-9, abs=1e-10)
