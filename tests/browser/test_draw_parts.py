"""Active members, beams, bodies, springs of angles and runs, drawn in Chromium by mouse and keys alone; comments, pictures."""

from __future__ import annotations

import urllib.request
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt
from hand import drawn
from kinetruss import dynamics, kinematics, runs, statics
from served import start

pytestmark = pytest.mark.slow

PLACES = {"A": (0.0, 0.0), "B": (1.0, 0.0), "C": (0.0, -0.8), "D": (1.4, 0.4), "E": (1.8, 0.0)}


def the_same_in_python(clamped: list[str]) -> kt.Model:
    """A beam, pinned or clamped, on an active strut; a plate on its tip is held by a spring of the angle between them."""
    tube = {"kind": "tube", "outer": 0.05, "inner": 0.04}
    rod = {"kind": "tube", "outer": 0.036, "inner": 0.03}
    part = {"length": 0.96, "material": "aluminium_6082_t6"}
    return kt.Model(
        nodes=PLACES,
        gravity=(0, -9.81),
        fixed={"A": "xy", "C": "xy"},
        bars={"link": kt.Bar(ends=("B", "D"))},
        beams={"arm": kt.Beam(ends=("A", "B"), section=tube, material="steel_s235")},
        clamped=clamped,
        active={
            "strut": kt.Active(
                ends=("C", "B"), base={**part, "section": tube, "mass": 2.5}, tube={**part, "section": rod},
                screw="screw_lacy_slewing", gear="gear_lacy_slewing", motor="motor_lacy", limits=(1.0, 1.6),
            )
        },
        bodies={"plate": kt.Body(nodes=("B", "D", "E"), mass=3.0)},
        springs={"hinge": kt.Spring(coordinate=kt.HingeDrive(axis=("B",), start="A", end="D"), stiffness=2000.0)},
        loads={"F_E": kt.NodalForce(node="E", force=(0, -20))},
    )  # fmt: skip


def compare(state: dict, model: kt.Model) -> None:
    """The forces of a page are those of the model in equilibrium, and its supports hold all weight and load."""
    rest = np.array(statics.equilibrium(model).whole["position"].values)
    motion = kinematics.from_arrays(model, [0.0], rest[None], 0 * rest[None], 0 * rest[None])
    wanted = dynamics.inverse(model, motion, static=False).arrays
    names = [str(name) for name in wanted["member"].values]
    forces = dict(zip(names, wanted["member_force"].values[0], strict=True))
    largest = max(map(abs, forces.values()))
    assert largest > 20
    found = {one["name"]: force for one, force in zip(state["members"], state["force"], strict=True)}
    for name in ("strut", "link"):
        assert found[name] == pytest.approx(forces[name], abs=1e-12 * largest)
    for name in "AC":  # the clamp also holds nodes that the beam has added
        held = [str(one).startswith(name) for one in wanted["support"].values]
        assert state["reaction"][name] == pytest.approx(wanted["reaction"].values[0][held].sum(axis=0), abs=1e-12 * largest)
    weight = 9.81 * (3 + float(sum(model_mass(model)))) + 20
    assert sum(reaction[1] for reaction in state["reaction"].values()) == pytest.approx(weight, rel=1e-9)


def test_active_member_beam_body_and_angle_spring_are_drawn_and_have_the_forces_of_the_library(show, served):
    hand = drawn(show, served)
    hand.closer("0.2", -5)
    hand.press("n")
    for place in PLACES.values():
        hand.click((*place, 0))
    assert hand.state()["nodes"] == list(PLACES)
    hand.press("b")
    for a, b, name in (("A", "B", "arm"), ("C", "B", "strut"), ("B", "D", "link")):
        hand.pull(a, b)
        hand.write(f"name of {hand.state()['members'][-1]['name']}", name)
    for name in "AC":
        hand.held(name)
    hand.choose("pick a node", "E")
    hand.write("force on E along y", "-20 N")

    hand.choose("pick a member", "arm")
    hand.choose("kind of arm", "beam")
    hand.choose("beams.arm.material", "steel_s235")
    hand.write("beams.arm.section.outer", "50 mm")
    hand.write("beams.arm.section.inner", "40 mm")

    hand.choose("pick a member", "strut")
    hand.choose("kind of strut", "active")
    for rod, outer, inner in (("base", "50 mm", "40 mm"), ("tube", "36 mm", "30 mm")):
        hand.write(f"active.strut.{rod}.section.outer", outer)
        hand.write(f"active.strut.{rod}.section.inner", inner)
    hand.page.get_by_label("More fields of active.strut.base", exact=True).click()
    hand.write("active.strut.base.mass", "2.5 kg")
    hand.choose("active.strut.motor", "motor_lacy")
    hand.write("active.strut.limits", "1 m, 160 cm")

    hand.page.locator("h1").click()
    hand.press("v")
    hand.click((0.4, 0, 0))
    hand.page.keyboard.down("Shift")
    hand.click((1.2, 0.2, 0))
    hand.page.keyboard.up("Shift")
    hand.button("Angle spring")
    hand.write("springs.spring1.stiffness", "2 kN m/rad")
    hand.write("name of springs spring1", "hinge")
    offered = hand.page.get_by_label("springs.hinge.coordinate.start", exact=True)
    assert offered.evaluate("one => [...one.list.options].map(option => option.value)") == list(PLACES)

    hand.click("B")
    hand.page.keyboard.down("Shift")
    hand.click("D")
    hand.click("E")
    hand.page.keyboard.up("Shift")
    hand.button("Body")
    hand.write("bodies.body1.mass", "3 kg")
    hand.write("name of bodies body1", "plate")
    assert hand.page.locator("path.body").count() == hand.page.locator("path.spring").count() == 1

    state = hand.state()
    assert (state["faults"], [one["name"] for one in state["drives"]]) == ([], ["strut"])
    assert state["why"].startswith("Forces are those of the equilibrium")
    compare(state, the_same_in_python([]))
    hand.button("New run")
    hand.write("runs.run1.trajectory.duration", "4 s")
    hand.write("runs.run1.trajectory.moves.strut", "1.28062485, 1.3 m")
    hand.choose("runs.run1.analysis", "statics.equilibrium")  # without the trajectory, which it does not use
    hand.page.get_by_label("do run run1").click()
    hand.shown.until("kinetruss.draw.entries.ran.run1")
    link = hand.page.get_by_role("link", name="Show the result")
    assert "1 of 1 samples." in hand.page.locator(".about").first.inner_text()
    with urllib.request.urlopen(f"{served.address}{link.get_attribute('href')}") as answer:
        assert b"kinetruss-scene" in answer.read()
    hand.choose("pick a member", "arm")
    hand.choose("end of arm at A", "clamped")
    compare(hand.state(), the_same_in_python(["A"]))
    hand.page.locator("h1").click()
    hand.press("Control+z", "Control+s")
    saved = kt.read(served.folder / "model.yaml")
    assert saved.active["strut"].base.mass == 2.5
    assert not saved.clamped
    assert runs.run(saved, "run1").status.ok
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])


def model_mass(model: kt.Model) -> Iterator[float]:
    """Masses of the beam and of the rods of the strut, kg."""
    beam = model.beams["arm"]
    yield model.material_of(beam).density * model.section_of(beam).area * 1.0
    for part in (model.active["strut"].base, model.active["strut"].tube):
        yield part.mass or model.material_of(part).density * model.section_of(part).area * part.length


def test_comments_survive_what_is_drawn_and_a_restart_keeps_the_picture(show, served, tmp_path):
    hand = drawn(show, served)
    area = hand.page.get_by_label("model as text")
    area.fill("# my arm\nkinetruss: 1\nnodes: # where\n  A: [0, 0] # the pin\n  B: [20 cm, 0]\n# all bars\nbars:\n"
              "  b1: [A, B]   # the arm\nfixed: [A]\ngravity: [0, -9.81]\n")  # fmt: skip
    hand.shown.until("kinetruss.draw.state.members.length === 1")
    hand.page.locator("h1").click()
    hand.press("f", "b")
    hand.pull("B", (0.2, 0.1, 0))
    hand.choose("pick a member", "b1")
    hand.choose("kind of b1", "beam")
    text = hand.state()["text"]
    assert [line for line in text.splitlines() if "#" in line] == [
        "# my arm",
        "nodes: # where",
        "  A: [0, 0] # the pin",
        "# all bars",
    ]
    assert "B: [20 cm, 0]" in text
    hand.page.locator("h1").click()
    hand.press("Control+z")
    assert "  b1: [A, B]   # the arm\n" in hand.state()["text"]
    assert area.input_value() == hand.state()["text"]

    picture = Path(tmp_path) / "sketch.svg"
    picture.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100"><rect width="9" height="9"/></svg>')
    hand.page.locator("summary", has_text="Picture to trace").click()
    hand.page.get_by_label("picture to trace", exact=True).set_input_files(picture)
    hand.shown.until("kinetruss.draw.picture.image")
    hand.settle()
    placed = hand.js("draw.picture.image")
    hand.page.get_by_label("opacity of the picture").fill("0.25")
    hand.settle()
    assert sorted(one.name for one in (served.folder / ".kinetruss").glob("*.picture.*")) == [
        "untitled.picture.json", "untitled.picture.txt"]  # fmt: skip
    served.process.kill()
    hand.shown.until("kinetruss.draw.closed")
    again = start(served.folder)
    try:
        other = drawn(show, again)
        other.shown.until("kinetruss.draw.picture.image")
        assert other.js("draw.picture.image") == placed
        assert other.js("draw.picture.opacity") == 0.25
        assert other.page.locator("svg.drawing image").count() == 1
        other.page.locator("summary", has_text="Picture to trace").click()
        other.button("remove the picture")
        assert not list((served.folder / ".kinetruss").glob("*.picture.*"))
        assert (other.shown.requests, other.shown.complaints) == ([], [])
    finally:
        again.process.kill()
        again.process.communicate()
