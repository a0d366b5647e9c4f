"""What cannot be sized, and missions and catalogues that are faulty: said with member, rule, amount, file and line."""

from __future__ import annotations

from pathlib import Path

import pytest

import kinetruss as kt
from kinetruss.io import read_catalogue, read_mission
from kinetruss.verification import missions as task
from samples import tripod

TUBES = "source: made up\nmaterial: aluminium_6061_t6\ntubes:\n"


def refused(mission: kt.Mission, model: kt.Model) -> str:
    with pytest.raises(kt.AnalysisError) as caught:
        kt.design.size(model, mission)
    assert caught.value.exit_code == 1
    return str(caught.value)


def faults(text: str, tmp_path: Path, model: kt.Model | None = None) -> list[str]:
    path = tmp_path / "mission.yaml"
    path.write_text(text)
    with pytest.raises(kt.ModelError) as caught:
        read_mission(path, model)
    return [line.removeprefix(f"{path}:") for line in caught.value.lines()]


def catalogue_faults(text: str, tmp_path: Path) -> list[str]:
    path = tmp_path / "stock.yaml"
    path.write_text(text)
    with pytest.raises(kt.ModelError) as caught:
        read_catalogue(path)
    return [line.removeprefix(f"{path}:") for line in caught.value.lines()]


def test_no_tube_carries_by_hand():
    """30x1 bears pi^2 E I/2 = 3313 N of the 8000/(2 sin 60 deg) = 4619 N."""
    model, mission = task.bracket_task(8000.0)
    said = refused(mission, model)
    assert "No tube of the catalogue carries group 'struts': with the best of them, 30x1" in said
    assert "reaches 1.394 times what is allowed by buckling at 0 s (all)" in said


def test_a_base_rod_too_weak_for_any_tube():
    model = tripod(5, load_cases={})
    heavy = model.with_(nodes=dict(model.nodes) | {"T": model.nodes["T"].with_(mass=1000.0)}, safety=kt.Safety(buckling=3.0))
    said = refused(kt.Mission(catalogues={"tubes": "aluminium_tubes_inch"}, groups={"legs": ["L?"]}), heavy)
    assert "by buckling at" in said
    assert "; its base rod counts too, the weaker of base and tube buckles" in said


def test_masses_that_run_away():
    model, mission = task.chain_task(0.26)
    said = refused(mission, model)
    assert said.startswith("The sizing does not settle: the masses run away.")
    assert "under the masses of pass 2 no tube" in said
    assert "M11 reaches 1.016 times" in said


def test_too_few_passes():
    model, mission = task.chain_task(0.3)
    said = refused(mission.with_(settle={"passes": 2}), model)
    assert said.startswith("The sizing does not converge within 2 passes: ")
    assert said.endswith("Raise settle.passes in the mission.")
    kt.design.size(model, mission.with_(settle={"passes": 3}))


def test_a_member_outside_all_groups():
    model, mission = task.chain_task(0.3)
    only = {"lower": mission.groups["lower"]}
    said = refused(mission.with_(groups=only), model)
    assert "is in no group and does not carry: buckling reaches" in said


def test_a_run_that_ends_early():
    model, mission = task.bracket_task()
    wide = kt.Quintic(moves={"left": (1.0, 2.5)}, duration=1.0)
    said = refused(mission, model.with_(runs={"stand": kt.Run(trajectory=wide, samples=21)}))
    assert said.startswith("Run 'stand' ends early: ")


def test_members_without_yield_strength():
    model, mission = task.bracket_task()
    soft = model.with_(material=kt.Material(E=70e9, density=0.0))
    with pytest.raises(kt.ModelError, match="groups.struts: member 'left' has no yield strength, so no tube can be judged"):
        kt.design.size(soft, mission)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("runs: [slow]", "1:8: runs.0: the model has no run called 'slow'. Did you mean 'slew'?"),
        ("load_cases: [x]", "1:14: load_cases.0: no load case called 'x'. There are: none."),
        ("groups: {a: [B1.M1, B1.M99]}", "1:21: groups.a.members.1: no member fits 'B1.M99'. Did you mean"),
        ("groups: {a: ['B1.*'], b: [B1.M3]}", "1:27: groups.b.members.0: 'B1.M3' takes B1.M3, which 'a' has already."),
        ("drives: {a: [B1.M3]}", "1:14: drives.a.0: no active member fits 'B1.M3'. Did you mean"),
        ("margin: 0.5", "1:9: margin: '0.5' must be at least 1."),
        ("settle: {passes: 1}", "1:18: settle.passes: '1' must be at least 2."),
        ("self_locking: yes", "1:15: self_locking: 'yes' is not true or false."),
        ("speed: 3", "1:1: speed: 'speed' is not known here."),
        ("safety: {yielding: 0.9}", "1:20: safety.yielding: "),
        ("kinetruss_mission: 2", "1:1: kinetruss_mission: mission format '2' is not known here."),
    ],
)
def test_faults_of_a_mission(line, said, tmp_path):
    model, _ = task.chain_task()
    found = faults(f"{line}\ncatalogues: {{tubes: aluminium_tubes_inch}}\n", tmp_path, model)
    assert len(found) == 1
    assert found[0].startswith(said)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "1:1: model: is empty. Start with kinetruss_mission: 1"),
        ("- a", "1:1: model: is not a table of names."),
        ("runs: [a", "1:7: model: is not YAML"),
        ("runs: [slew]", "1:1: catalogues: 'catalogues' is missing. Add it."),
        ("catalogues: {}", "1:1: model: names no catalogue."),
        ("nodes: {A: [0, 0]}", "1:1: nodes: is a model, not a mission. Name the model first, then the mission."),
        ("groups: {a: [M1]}\ncatalogues: {motors: x}", "1:10: groups.a: has no catalogue of tubes."),
    ],
)
def test_files_that_are_no_mission(text, said, tmp_path):
    model = kt.library.vgt.double_octahedral().with_(
        runs={"slew": kt.Run(trajectory=kt.library.vgt.slew(beta=(0.0, 0.1)), samples=3)}
    )
    found = faults(text, tmp_path, model)
    assert found[0].startswith(said)


def test_all_faults_of_a_mission_at_once(tmp_path):
    model, _ = task.chain_task()
    text = "runs: [slow]\ngroups:\n  a: [x]\n  b: ['B1.M*']\n  c: [B1.M7]\ncatalogues: {tubes: aluminium_tubes_inch}\n"
    assert [line.split(":")[0] for line in faults(text, tmp_path, model)] == ["1", "3", "5"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (TUBES + '  "a": {outer: 25, wall: 1 mm}', "4:16: tubes.a.outer: 25 has no unit. Write for example '25 mm'."),
        (TUBES + '  "a": {outer: "25", wall: 1 mm}', "4:16: tubes.a.outer: 25 has no unit."),
        (TUBES + '  "a": {outer: 25 mm, wall: 13 mm}', "4:3: tubes.a: a wall of 0.013 m leaves no bore"),
        (TUBES + '  "a": {outer: 25 mm, inner: 26 mm}', "4:3: tubes.a: inner diameter 0.026 m must be greater than 0"),
        (TUBES + '  "a": {outer: 25 mm, inner: 0 mm}', "4:3: tubes.a: inner diameter 0 m must be greater than 0"),
        (TUBES + '  "a": {outer: 25 mm}', "4:3: tubes.a: has neither wall nor inner diameter."),
        (TUBES + '  "a": {outer: 25 mm, wall: 1 mm, inner: 23 mm}', "4:3: tubes.a: has both wall and inner diameter."),
        (TUBES + '  "a": {outer: -25 mm, wall: 1 mm}', "4:16: tubes.a.outer: -0.025 must be greater than 0."),
        (TUBES + '  "a": {outer: 25 kg, wall: 1 mm}', "4:16: tubes.a.outer: '25 kg' is not a length (m)."),
        (TUBES + '  "a": {outr: 25 mm, wall: 1 mm}', "4:9: tubes.a.outr: 'outr' is not known here. Did you mean 'outer'?"),
        (TUBES + '  "a": {wall: 1 mm}', "4:3: tubes.a.outer: 'outer' is missing."),
        (TUBES + '  "a b": {outer: 25 mm, wall: 1 mm}', "4:3: tubes.a b: 'a b' is no name"),
        (TUBES + "  a:\n    outer: 25\n    wall: 0.001", "5:12: tubes.a.outer: 25 has no unit."),
        (TUBES + "  a: {outer: 25 mm, wall: 1 mm}\n  a: {outer: 26 mm, wall: 1 mm}", "5:3: tubes.a: 'a' is given twice"),
        ("tubes:\n  a: {outer: 2 mm, wall: 0.5 mm}", "1:1: source: 'source' is missing."),
        ('source: " "\ntubes:\n  a: {outer: 2 mm, wall: 0.5 mm}', "1:9: source: is empty. Say where"),
        ("source: s", "1:1: model: holds nothing. Add tables tubes, screws, gears or motors."),
        ("source: s\nmaterial: cheese\ngears:\n  g: {ratio: 2}", "2:11: material: no material called 'cheese' in the library."),
        ("source: s\nscrews:\n  s: {lead: 2 mm, mean_diameter: 9 mm}", "3:13: screws.s.lead: '2 mm' is not a lead"),
        ("source: s\nscrews:\n  s: {lead: 2 mm/rev, mean_diameter: 9 mm, core_diameter: 9 mm}",
         "3:3: screws.s: core diameter 0.009 m must be less than the mean one"),
        ("source: s\ngears:\n  g: {ratio: -1}", "3:3: gears.g: gear ratio -1 must be greater than 0"),
        ("source: s\nmotors:\n  m: {inertia: 1e-6, resistance: 2 ohm, torque_constant: 0.04 N m/A, "
         "emf_constant: 0.04 V s/rad, max_speed: 3000}", "3:16: motors.m.inertia: 1e-6 has no unit."),
        ("tubes: [", "2:1: model: is not YAML: did not find expected node content"),
        ("[]", "1:1: model: is not a table of names."),
        ("", "1:1: model: is empty. Start with title and source"),
    ],
)  # fmt: skip
def test_faults_of_a_catalogue(text, said, tmp_path):
    found = catalogue_faults(text, tmp_path)
    assert any(line.startswith(said) for line in found), found


def test_all_faults_of_a_catalogue_at_once(tmp_path):
    rows = ["  a: {outer: 25, wall: 1 mm}", "  b: {outer: 20 mm, wall: 1 mm}", "  c: {outer: 2 mm, wall: 1 mm}"]
    assert [line.split(":")[0] for line in catalogue_faults(TUBES + "\n".join(rows), tmp_path)] == ["4", "6"]


def test_catalogues_that_are_not_there_or_lack_what_is_asked(tmp_path):
    model, mission = task.bracket_task()
    with pytest.raises(kt.ModelError, match="catalogues.tubes: no catalogue called 'aluminium_tubes_inc'. Did you mean"):
        kt.design.size(model, mission.with_(catalogues={"tubes": "aluminium_tubes_inc"}))
    with pytest.raises(kt.ModelError, match="the catalogue has no tubes"):
        kt.design.size(model, mission.with_(catalogues={"tubes": "planetary_gears"}))
    with pytest.raises(kt.ModelError, match="there is no such file"):
        kt.design.size(model, mission.with_(catalogues={"tubes": str(tmp_path / "no.yaml")}))
    with pytest.raises(kt.ModelError, match="catalogues: the model has no active members"):
        kt.design.size(model, mission.with_(catalogues={"motors": "dc_motors_25v"}, groups=None))


def test_a_catalogue_in_toml_is_told_how_to_be_written(tmp_path):
    model, mission = task.bracket_task()
    (tmp_path / "old.toml").write_text('source = "s"')
    with pytest.raises(kt.ModelError, match=r"old\.toml:1:1: model: is TOML, which is not read\. Write it as YAML"):
        kt.design.size(model, mission.with_(catalogues={"tubes": str(tmp_path / "old.toml")}))


def test_paths_of_catalogues_are_relative_to_the_mission(tmp_path, monkeypatch):
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "own.yaml").write_text(TUBES + "  a: {outer: 25 mm, wall: 2 mm}")
    (tmp_path / "sub" / "m.yaml").write_text("catalogues: {tubes: own.yaml}\n")
    monkeypatch.chdir(tmp_path)
    mission = read_mission("sub/m.yaml")
    assert kt.design.catalogue(mission.catalogues.tubes).tubes["a"].section.inner == pytest.approx(0.021)
