"""Slips of units in sound models are noted, at their place in the file; nothing shipped is doubted."""

import json

import pytest
from click.testing import CliRunner
from hypothesis import given, strategies as st

import kinetruss as kt
from kinetruss.cli import main
from kinetruss.library import builders

BASE = {"nodes": {"A": (0, 0), "B": (2, 0)}, "fixed": ["A"], "bars": {"b": {"ends": ("A", "B"), "kind": "driven"}}}
ROD = {"kind": "rod", "diameter": 0.02}
STEEL = {"E": 210e9, "density": 7850, "yield_strength": 235e6}
HUB = {"drives": {"turn": {"kind": "angle", "bar": "b"}}, "bars": {"b": ("A", "B")}}

RUN = "runs.r.trajectory."
SPRING = {"coordinate": {"kind": "angle", "bar": "b"}, "stiffness": 5, "rest": 90}


def of_run(**fields):
    return {"runs": {"r": fields}}


SLIPS = {
    "section in mm": ({"section": {"kind": "tube", "outer": 100, "inner": 96}}, "section"),
    "named section in mm": ({"section": "s", "sections": {"s": {"kind": "rod", "diameter": 19}}}, "sections.s"),
    "section of a bar": ({"bars": {"b": {"ends": ("A", "B"), "section": {"kind": "rod", "diameter": 19}}}}, "bars.b.section"),
    "nodes in mm": ({"nodes": {"A": (0, 0), "B": (2000, 0)}, "section": ROD}, "section"),
    "nodes in mm, a flat section in m": (
        {"nodes": {"A": (0, 0), "B": (400, 0)}, "section": {"kind": "rectangle", "width": "20 mm", "height": "5 mm"}},
        "section",
    ),
    "nodes in mm, beams": (
        {"nodes": {"A": (0, 0), "B": (400, 0)}, "bars": {}, "clamped": ["A"], "fixed": {}, "beams": {"b": ("A", "B")},
         "section": {"kind": "rectangle", "width": "20 mm", "height": "5 mm"}, "material": "steel_s235"},
        "section",
    ),
    "E in GPa": ({"material": STEEL | {"E": 210}}, "material.E"),
    "density in g/cm^3": ({"material": STEEL | {"density": 0.00785}}, "material.density"),
    "density in kg/mm^3": ({"material": STEEL | {"density": 7.85e6}}, "material.density"),
    "yield strength in MPa": ({"materials": {"m": STEEL | {"yield_strength": 235}}}, "materials.m.yield_strength"),
    "mass of a node": ({"nodes": {"A": (0, 0), "B": {"at": (2, 0), "mass": "1e12 t"}}}, "nodes.B.mass"),
    "mass of a bar": ({"bars": {"b": {"ends": ("A", "B"), "mass": 1e9}}}, "bars.b.mass"),
    "gravity in mm/s^2": ({"gravity": (0, -9810)}, "gravity"),
    "lead a turn": ({"screws": {"s": {"lead": 0.005, "mean_diameter": 0.02, "friction": 0.1}}}, "screws.s.lead"),
    "degrees": (
        HUB | {"trajectories": {"t": {"kind": "quintic", "moves": {"turn": (0, 90)}, "duration": 1}}},
        "trajectories.t.moves.turn",
    ),
    "degrees of a run": (
        HUB | {"runs": {"r": {"trajectory": {"kind": "sine", "amplitudes": {"turn": 30}, "period": 1, "duration": 1}}}},
        "runs.r.trajectory.amplitudes.turn",
    ),
    "all in mm": (
        {"nodes": {"A": (0, 0), "B": (400, 0)}, "section": {"kind": "rectangle", "width": 20, "height": 5}},
        "section",
    ),
    "E in MPa": ({"material": STEEL | {"E": 210e3}}, "material.E"),
    "E in MPa, density left out": ({"material": {"E": 11e3, "density": 500, "yield_strength": "40 MPa"}}, "material.E"),
    "density of steel in g/cm^3": ({"material": STEEL | {"density": 7.85}}, "material.density"),
    "half degrees": (HUB | of_run(trajectory={"kind": "cyclic", "moves": {"turn": (0, 22.5)}, "period": 1}),
                     RUN + "moves.turn"),
    "degrees a second": (HUB | of_run(trajectory={"kind": "constant_rate", "rates": {"turn": 360}, "duration": 1}),
                         RUN + "rates.turn"),
    "turns a minute": (HUB | of_run(trajectory={"kind": "constant_rate", "rates": {"turn": -1500}, "duration": 1}),
                       RUN + "rates.turn"),
    "degrees of a table": (
        HUB | of_run(trajectory={"kind": "spline", "times": (0, 1, 2, 3), "values": {"turn": (0, 15, 22.5, 30)}}),
        RUN + "values.turn",
    ),
    "degrees of a phase": (
        HUB | of_run(trajectory={"kind": "sine", "amplitudes": {"turn": 0.5}, "period": 1, "phase": 90, "duration": 1}),
        RUN + "phase",
    ),
    "degrees of way points": (
        HUB | of_run(targets={"kind": "coordinates", "moves": {"turn": (0, 45, 90)}}), "runs.r.targets.moves.turn"
    ),
    "degrees of a task": (
        HUB | of_run(analysis="dynamics.simulate", t_end=1,
                     tasks={"turn": {"kind": "quintic", "moves": {"turn": (0, 90)}, "duration": 1}}),
        "runs.r.tasks.turn.moves.turn",
    ),
    "degrees of a pose": (HUB | of_run(analysis="statics.at_poses", poses={"up": {"turn": 90}}), "runs.r.poses.up.turn"),
    "degrees of a spring": (
        {"bars": {"b": ("A", "B")}, "springs": {"s": SPRING}},
        "springs.s.rest",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("change", "place"), SLIPS.values(), ids=SLIPS)
def test_slips_are_noted_at_their_place(tmp_path, change, place):
    data = BASE | change
    assert [note.where for note in kt.notes(kt.Model(**data))] == [place]
    file = tmp_path / "model.json"
    file.write_text(json.dumps({"kinetruss": 1} | data, indent=1))
    (note,) = kt.notes(file)
    assert note.where == place
    assert place.rpartition(".")[2] in file.read_text().splitlines()[note.line - 1]
    assert "bare number" in note.mend
    assert kt.check(file) == []
    done = CliRunner().invoke(main, ["check", str(file)])
    assert done.exit_code == 0
    assert f"note: {file}:{note.line}:{note.column}: {place}: " in done.output
    record = json.loads(CliRunner().invoke(main, ["check", str(file), "--json"]).output)
    assert [one["path"] for one in record["notes"]] == [list(note.path)]


@pytest.mark.parametrize(
    "change",
    [
        {"section": ROD, "material": STEEL, "gravity": (0, -9.81)},
        {"bars": {"b": {"ends": ("A", "B"), "kind": "cable", "section": {"kind": "rod", "diameter": 1e-4}, "material": STEEL}}},
        {"screws": {"s": {"lead": "5 mm/rev", "mean_diameter": 0.02, "friction": 0.1}}},
        {"screws": {"s": {"lead": "20 mm/rev", "mean_diameter": "20 mm", "friction": 0.1}}},
        HUB | {"trajectories": {"t": {"kind": "quintic", "moves": {"turn": ("0 deg", "3600 deg")}, "duration": 1}}},
        HUB | {"trajectories": {"t": {"kind": "quintic", "moves": {"turn": (0, "40 rad")}, "duration": 1}}},
        HUB | {"trajectories": {"t": {"kind": "quintic", "moves": {"turn": (0, 62.83185307179586)}, "duration": 1}}},
        HUB | of_run(trajectory={"kind": "constant_rate", "rates": {"turn": 10}, "duration": 1}),
        HUB | of_run(trajectory={"kind": "constant_rate", "rates": {"turn": "90 rad/s"}, "duration": 1}),
        HUB | of_run(trajectory={"kind": "constant_rate", "rates": {"turn": "1500 rev/min"}, "duration": 1}),
        HUB | of_run(targets={"kind": "coordinates", "moves": {"turn": ("0 deg", "720 deg")}}),
        {"material": {"E": 5e6, "density": 1100, "yield_strength": 15e6}},  # rubber
        {"material": {"E": 1.2e12, "density": 3515}},  # diamond
        {"section": {"kind": "tube", "outer": 8.0, "inner": 7.9}, "nodes": {"A": (0, 0), "B": (150, 0)}, "material": STEEL},
    ],
)
def test_sound_models_are_not_doubted(change):
    assert kt.notes(kt.Model(**BASE | change)) == []


@pytest.mark.parametrize("name", kt.library.example_files())
def test_no_example_is_doubted(name):
    assert kt.notes(kt.library.example_files()[name][0]) == []


def test_no_library_model_is_doubted():
    for name, record in builders().items():
        if not any(field.is_required() for field in record.model_fields.values()):
            assert kt.notes(kt.library.build(name)) == [], name


@given(st.sampled_from(sorted(kt.library.materials.MATERIALS)), st.floats(0.5, 30), st.floats(20, 400))
def test_bars_as_they_are_built_are_not_doubted(material, length, slenderness):
    model = kt.Model(**BASE | {"nodes": {"A": (0, 0), "B": (length, 0)}}, section=kt.Rod(diameter=length / slenderness),
                     material=kt.library.materials.MATERIALS[material])  # fmt: skip
    assert kt.notes(model) == []


LOOSE = BASE | {
    "nodes": {"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)}, "fixed": ["A", "D"],
    "bars": {"ab": {"ends": ("A", "B"), "kind": "driven"}, "bc": ("B", "C"), "cd": ("C", "D")},
    "runs": {"go": {"trajectory": {"kind": "quintic", "moves": {"ab": (1, 1.1)}, "duration": 1}}},
}  # fmt: skip


def test_python_and_the_command_line_find_the_same(tmp_path):
    """A freedom that no drive holds: in a model, in a file with its place, and by the command."""
    (alone,) = kt.check(kt.Model(**LOOSE))
    file = tmp_path / "loose.json"
    file.write_text(json.dumps({"kinetruss": 1} | LOOSE, indent=1))
    (placed,) = kt.check(file)
    assert alone.message == placed.message
    assert "one freedom that no drive holds" in placed.message
    assert file.read_text().splitlines()[placed.line - 1].strip().startswith('"go"')
    done = CliRunner().invoke(main, ["check", str(file)])
    assert done.exit_code == 2
    assert done.output == f"{file}:{placed.line}:{placed.column}: {placed}\n"
