"""Variable-geometry trusses of the library: names, places, masses, parameters as text, faults."""

import math

import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss.errors import ModelError
from kinetruss.library import build, builders
from kinetruss.library.vgt import double_octahedral, lacy_step, slew, triangular

# Lacy (1991), table 4.1, by node numbers, first node first; M19 from 7 to 9
TABLE = {
    "M1": "6 2", "M2": "6 1", "M3": "4 1", "M4": "4 3", "M5": "5 3", "M6": "5 2", "M7": "4 5", "M9": "5 6", "M11": "4 6",
    "M13": "6 9", "M14": "6 7", "M15": "4 7", "M16": "4 8", "M17": "5 8", "M18": "5 9", "M19": "7 9",
    "M20": "8 7", "M21": "8 9",
}  # fmt: skip


def length(model, name):
    p, q = (model.nodes[end].at for end in model.members[name].ends)
    return math.dist(p, q)


def test_one_bay_has_the_members_of_the_thesis():
    model = double_octahedral()
    assert list(model.nodes) == [f"N{k}" for k in range(1, 10)]
    assert {name: " ".join(end[1:] for end in member.ends) for name, member in model.members.items()} == TABLE
    assert list(model.active) == ["M7", "M9", "M11"]
    assert model.fixed == {"N1": "xyz", "N2": "xyz", "N3": "xyz"}
    assert model.poses["bay"].drives == ("M7", "M9", "M11")


def test_default_bay_stands_upright_on_equal_actuators():
    model = double_octahedral()
    assert [length(model, name) for name in model.active] == pytest.approx([1.1684] * 3, abs=1e-15)
    assert model.nodes["N8"].at == pytest.approx((0, 0.7039054482, 1.121825346), abs=5e-10)


def test_slewed_bay_stands_where_the_stored_one_does():
    # independent computation of the single-bay slew at its start
    model = double_octahedral(beta=math.radians(-10))
    assert model.nodes["N8"].at == pytest.approx((0, 0.790985064, 0.9953245634), abs=5e-10)
    assert [length(model, name) for name in model.active] == pytest.approx([1.248818925, 1.11651438, 1.11651438], abs=5e-10)


def test_masses_of_the_thesis():
    model = double_octahedral(payload_mass=2)
    area = math.pi / 4 * (0.01905**2 - 0.016002**2)
    tube, material = model.section_of(model.active["M9"].tube), model.material_of(model.bars["M1"])
    assert tube.area == pytest.approx(area, rel=1e-14)
    assert material.density == 2711.5
    base = model.active["M9"].base
    assert (base.mass, base.length, model.active["M9"].tube.length, base.section) == (3.0, 0.7, 0.254, None)
    assert [node.mass for node in model.nodes.values()] == [0] * 6 + [2] * 3


@pytest.mark.slow
@settings(deadline=None, max_examples=20)
@given(st.integers(2, 5), st.floats(-0.2, 0.2), st.floats(-0.2, 0.2))
def test_chain_of_bays(bays, beta, gamma):
    model = double_octahedral(bays, beta=beta, gamma=gamma)
    one = double_octahedral(beta=beta, gamma=gamma)
    assert len(model.nodes) == 3 + 6 * bays
    assert len(model.members) == 18 * bays
    assert list(model.poses) == [f"B{k}" for k in range(1, bays + 1)]
    for name in model.members:
        assert length(model, name) == pytest.approx(length(one, name.partition(".")[2]), abs=1e-13)


def test_bays_share_nodes():
    model = double_octahedral(3)
    assert "B2.N1" not in model.nodes
    assert model.bars["B2.M2"].ends == ("B2.N6", "B1.N7")
    assert model.bars["B2.M1"].ends == ("B2.N6", "B1.N9")
    assert model.bars["B3.M3"].ends == ("B3.N4", "B2.N7")
    assert model.bars["B3.M5"].ends == ("B3.N5", "B2.N8")


def test_payload_loads_and_drive_train():
    model = double_octahedral(
        payload_mass="5 lb", payload_gravity=(0, 0, 0), tip_force=(0, 0, "46 N"), gravity=(0, 0, 9.81),
        screw="screw_lacy_spatial", gear=kt.Gear(ratio=3), motor="motor_lacy", limits=("1 m", "1.3 m"),
    )  # fmt: skip
    assert model.nodes["N7"].mass == pytest.approx(2.26796185)
    assert model.nodes["N7"].gravity == (0, 0, 0)
    assert {load.node: load.force for load in model.loads.values()} == dict.fromkeys(("N7", "N8", "N9"), (0, 0, 46))
    assert model.motors["motor"].resistance == 2.0
    assert {(a.screw, a.gear, a.motor, a.limits) for a in model.active.values()} == {("screw", "gear", "motor", (1.0, 1.3))}
    assert model.gears["gear"].ratio == 3


def test_triangle_of_the_thesis():
    model = triangular()
    assert model.nodes["B"].at == pytest.approx((1.5625, math.sqrt(2.5**2 - 1.5625**2)), rel=1e-15)
    assert (length(model, "follower"), length(model, "actuator")) == pytest.approx((2.0, 2.5), rel=1e-15)
    assert model.bars["follower"].ends == ("O1", "B")
    assert model.active["actuator"].ends == ("O2", "B")
    assert (model.bars["follower"].rotary_inertia, model.active["actuator"].base.rotary_inertia) == (True, False)
    assert (model.nodes["B"].mass, model.gravity) == (10, (0, -9.81))


def test_motions_fit_their_models():
    assert list(lacy_step().moves) == ["actuator"]
    moves = slew(2, beta=("-10 deg", "10 deg"), height=(1.1, 1.2), duration=2).moves
    assert list(moves) == ["B1.beta", "B1.height", "B2.beta", "B2.height"]
    assert moves["B1.beta"][1] == pytest.approx(math.radians(10))
    assert list(slew(gamma=(0, 0.1)).moves) == ["bay.gamma"]


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ({"longeron": "0.5 m"}, "longeron: 0.5 m cannot span the base edge of 1.2192 m"),
        ({"active_length": "3 m"}, "active_length: 3 m does not close the bay. .*between 0 m and 1.73 m"),
        ({"height": 1.4}, "height: 1.4 m is out of reach. Stay below"),
        ({"beta": "70 deg"}, "beta: the pose 70 deg, 0 deg is out of reach"),
        ({"motor": "motor_lucy"}, "motor: there is no 'motor_lucy' in the library"),
        ({"material": "cheese"}, "material: there is no 'cheese'"),
        ({"tube_section": "tube"}, "tube_section: there is no 'tube'"),
        ({"base": "5 kg", "beta": "1 m"}, "base: .*\n.*beta: "),
        ({"bays": 0}, "bays: "),
    ],
)
def test_faulty_parameters_are_named(parameters, message):
    with pytest.raises(ModelError, match=f"(?s){message}"):
        double_octahedral(**parameters)


def test_triangle_that_does_not_close():
    with pytest.raises(ModelError, match=r"actuator_length: 4\.5 m does not close the triangle.*between 0 m and 4 m"):
        triangular(actuator_length=4.5)


def test_build_by_name_reads_text():
    built = build("vgt.double_octahedral", {"longeron": "889 mm", "beta": "5 deg", "bays": 2})
    assert built == double_octahedral(2, beta=math.radians(5))
    assert {"mechanisms.four_bar", "mechanisms.andrews", "vgt.double_octahedral", "vgt.triangular"} <= set(builders())
    with pytest.raises(ModelError, match=r"no library model called 'vgt\.triangle'\. Did you mean 'vgt\.triangular'"):
        build("vgt.triangle")
    with pytest.raises(ModelError, match="paylod_mass"):
        build("vgt.triangular", {"paylod_mass": 3})
    assert "anyOf" in builders()["vgt.triangular"].model_json_schema()["properties"]["span"]


@pytest.mark.parametrize("build", [kt.library.vgt.double_octahedral, kt.library.vgt.triangular])
def test_base_rods_with_a_section_are_of_the_material_of_the_tubes(build):
    steel = kt.library.materials.STEEL_S355
    model = build(base_section=kt.Rod(diameter=0.02), material=steel)
    for member in model.active.values():
        assert model.materials[member.base.material] == steel == model.materials[member.tube.material]
    assert not kt.strength.check(model, kt.statics.at_poses(model, [{}])).not_checked()
    bare = build(material=steel)
    assert {member.base.material for member in bare.active.values()} == {None}
