"""Names of the library do for records: in Python as in files, with the near name where there is none."""

import pytest

import kinetruss as kt
from kinetruss.library import drives, materials, sections
from kinetruss.shelves import shelf, shelves

BASE = {"nodes": {"A": (0, 0), "B": (1, 0)}, "fixed": ["A"], "bars": {"b": ("A", "B")}}
ROD = kt.Part(length=0.5, mass=1, section="tube_lacy_planar")
ACTIVE = kt.Active(
    ends=("A", "B"), base=ROD, tube=kt.Part(length=0.5, material="invar_36", section="tube_lacy_spatial"),
    screw="screw_lacy_planar", gear="gear_lacy", motor="motor_lacy", amplifier="amplifier_lacy_slewing",
)  # fmt: skip


def test_every_shelf_is_that_of_the_library():
    for name in shelves():
        assert shelf(name) in (
            sections.SECTIONS,
            materials.MATERIALS,
            drives.SCREWS,
            drives.GEARS,
            drives.MOTORS,
            drives.AMPLIFIERS,
        )
        assert shelf(name)
    assert shelf("nodes") == {}


def test_python_and_files_take_the_same_names(tmp_path):
    model = kt.Model(**BASE, section="tube_lacy_planar", material="steel_s235")
    named = "section: tube_lacy_planar\nmaterial: steel_s235\n"
    (tmp_path / "m.yaml").write_text(f"kinetruss: 1\nnodes: {{A: [0, 0], B: [1, 0]}}\nfixed: [A]\nbars: {{b: [A, B]}}\n{named}")
    assert kt.read(tmp_path / "m.yaml") == model
    assert model.material_of(model.bars["b"]) is materials.STEEL_S235
    assert model.section_of(model.bars["b"]) is sections.TUBE_LACY_PLANAR
    assert kt.read(kt.write(model, tmp_path / "again.yaml")) == model


def test_names_stand_wherever_records_do():
    bar = kt.Bar(ends=("A", "B"), section="tube_lacy_spatial", material="steel_4130")
    model = kt.Model(**BASE | {"bars": {"b": bar}})
    assert model.section_of(model.bars["b"]) is sections.TUBE_LACY_SPATIAL
    driven = kt.Model(nodes=BASE["nodes"], fixed=["A"], active={"a": ACTIVE})
    assert driven.screws["screw_lacy_planar"] is drives.SCREW_LACY_PLANAR
    assert driven.motors["motor_lacy"] is drives.MOTOR_LACY
    assert driven.material_of(driven.active["a"].tube) is materials.INVAR_36
    turned = kt.Model(**BASE, drives={"turn": kt.AngleDrive("b", motor="motor_lacy", gear="gear_lacy")})
    assert set(turned.gears) == {"gear_lacy"}
    assert model.with_(material="titanium_6al4v").material_of(bar) is materials.STEEL_4130
    web = kt.library.meshes.rectangle(width=1, height=1, columns=1, rows=1)
    plate = kt.Model(
        nodes=web.nodes, fixed=web.at(x=0.0), membranes={"web": web.membrane(thickness=0.01, material="steel_s355")}
    )
    assert set(plate.materials) == {"steel_s355"}
    assert kt.DriveTrain(screw="screw_lacy_planar", motor="motor_lacy").motor is drives.MOTOR_LACY
    assert kt.Catalogue(source="made up", material="steel_s235", gears={"g": kt.Gear(ratio=2)}).material is materials.STEEL_S235


def test_a_name_of_the_model_comes_first():
    own = kt.Material(E=1e9, density=1.0)
    model = kt.Model(**BASE, material="steel_s235", materials={"steel_s235": own})
    assert model.material_of(model.bars["b"]) == own


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: kt.Model(**BASE, material="steel_235"), "material: no material called 'steel_235'. Did you mean 'steel_s235'"),
        (
            lambda: kt.Model(**BASE, section="tube_lacy"),
            "section: no section called 'tube_lacy'. Did you mean 'tube_lacy_planar'",
        ),
        (lambda: kt.Model(**BASE, material="oak"), "material: no material called 'oak'. There are: aluminium_2024_t3"),
        (
            lambda: kt.Model(**BASE, drives={"t": kt.AngleDrive("b", motor="motor_lac")}),
            "no motor called 'motor_lac'. Did you mean",
        ),
        (lambda: kt.DriveTrain(motor="motor"), "no motor called 'motor' in the library. Did you mean 'motor_lacy'"),
        (
            lambda: kt.Catalogue(source="x", material="steel"),
            "no material called 'steel' in the library. Did you mean 'steel_",
        ),
    ],
)
def test_unknown_names_offer_those_of_the_library(make, words):
    with pytest.raises(kt.ModelError) as caught:
        make()
    assert words in str(caught.value)
