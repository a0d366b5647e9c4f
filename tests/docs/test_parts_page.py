"""Every part of docs/parts.md has a picture of its own code, in the words of the trade, that can be read."""

import math
import re
import sys
import xml.etree.ElementTree as ET
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

import kinetruss as kt

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "docs" / "site"))

import parts  # noqa: E402
import signs  # noqa: E402

pytestmark = pytest.mark.slow

PAGE = parts.PAGE.read_text("utf-8")
ENTRIES = re.findall(r"^### (.+)\n\n!\[[^\]]+\]\(made/parts/(\w+)\.svg\)\{\.part\}\n", PAGE, re.MULTILINE)
SVG = "{http://www.w3.org/2000/svg}"
TRADE = {
    "boom": "rocker, lever", "bell_crank": "angle lever", "plate": "gusset", "rod": "tie rod", "frame": "portal",
    "arm": "leaf spring", "rope": "cable, stay", "prop": "contact", "coil_spring": "tension spring",
    "damper": "shock absorber", "gas_spring": "gas strut", "bush": "silent block", "point_mass": "payload",
    "body": "flywheel", "pin": "ball joint", "weld": "stiff joint", "door": "door", "hinge_in_space": "revolute",
    "cardan": "universal joint", "slide": "linear guide", "clamp": "built-in", "roller": "bearing",
    "elastic_clamp": "semi-rigid", "inclined_roller": "inclined", "foot": "lift off", "settlement": "foundation",
    "slider": "slider crank", "slotted_lever": "quick-return", "bearing": "bushing", "hinge_spring": "backlash",
    "end_stops": "limits", "hub": "eccentric", "motor": "servo", "geared_motor": "gearbox", "motor_in_space": "robot",
    "jack": "linear actuator", "electric_cylinder": "lead screw actuator", "hydraulic_cylinder": "pneumatic",
    "gears": "spur gears", "belt": "chain drive", "rack": "pinion", "wheel": "rolls", "lead_screw": "ball screw",
    "differential": "planetary gear", "pulley": "sheave", "tackle": "several falls", "in_step": "synchronised",
    "bumper": "buffer",
}  # fmt: skip
"""A word of the trade by which each is found."""


@pytest.fixture(scope="module")
def models():
    return dict(parts.models(PAGE))


def marks(svg, tag):
    return list(ET.fromstring(svg).iter(SVG + tag))


def test_every_entry_has_a_picture_and_a_model(models):
    assert len(ENTRIES) == len({name for _, name in ENTRIES}) == 48
    assert [name for _, name in ENTRIES] == list(models)


def test_a_part_is_found_by_the_words_of_its_trade():
    heads = {name: heading.lower() for heading, name in ENTRIES}
    assert [name for name in heads if TRADE[name] not in heads[name]] == []


@pytest.mark.parametrize("name", [name for _, name in ENTRIES])
def test_a_picture_can_be_read(models, name):
    """Its node names are all there, apart from each other and from pins; nothing is cut off; it is small."""
    model, svg = models[name], signs.drawn(models[name])
    left, top, wide, high = map(float, ET.fromstring(svg).get("viewBox").split())
    assert wide <= 340 and high <= 280 and len(svg) < 9000
    words = {mark.text: np.array([float(mark.get("x")), float(mark.get("y")) - 4.5]) for mark in marks(svg, "text")}
    assert {node for node in model.nodes if "." not in node} <= set(words)
    assert all(left + 4 <= x <= left + wide - 4 and top + 6 <= y <= top + high - 6 for x, y in words.values())
    assert all(np.linalg.norm(a - b) > 12 for a, b in combinations(words.values(), 2))
    pins = [mark for mark in marks(svg, "circle") if mark.get("r") == "4.0"]
    for pin in pins:
        at = np.array([float(pin.get("cx")), float(pin.get("cy"))])
        assert all(np.linalg.norm(at - word) > 9 for word in words.values())


def rims(svg):
    """Centre and radius of the largest circles."""
    found = [tuple(float(mark.get(key)) for key in ("cx", "cy", "r")) for mark in marks(svg, "circle")]
    return sorted(found, key=lambda one: -one[2])


def test_gear_wheels_touch_in_the_ratio_of_their_coupling(models):
    (x, y, r), _, (u, v, s), *_ = rims(signs.drawn(models["gears"]))  # each with its inner circle
    assert math.hypot(u - x, v - y) == pytest.approx(r + s, abs=0.3) and r / s == pytest.approx(2, rel=5e-3)
    (_, _, r), (_, _, s), *_ = rims(signs.drawn(models["belt"]))
    assert r / s == pytest.approx(2, rel=5e-3)


def test_a_turned_roller_is_drawn_as_it_is_turned(models):
    upright, turned = (
        re.findall(r'<path d="M([\d. L-]+)Z" style="fill:#ffffff', signs.drawn(models[name]))[-1]
        for name in ("roller", "inclined_roller")
    )
    ways = []
    for path in (upright, turned):
        tip, *base = (np.array(pair.split(), float) for pair in path.split("L"))
        ways.append(sum(base) / 2 - tip)
    angle = math.degrees(math.atan2(*ways[0])) - math.degrees(math.atan2(*ways[1]))
    assert abs(angle) == pytest.approx(30, abs=1)


def test_a_sign_is_as_large_as_another_whatever_the_model(models):
    big = models["roller"].with_(nodes={name: tuple(128 * x for x in node.at) for name, node in models["roller"].nodes.items()})
    assert signs.drawn(big) == signs.drawn(models["roller"])


def test_code_without_a_model_is_refused():
    with pytest.raises(TypeError, match="gear.svg does not end with a model"):
        list(parts.models("![A gear](made/parts/gear.svg){.part}\n\n```python\nx = 1\n```\n"))


def test_pictures_are_drawn_again_if_the_page_changes(tmp_path, monkeypatch):
    page = tmp_path / "parts.md"
    page.write_text(
        "![M](made/parts/one.svg)\n```python\nimport kinetruss as kt\nkt.Model(nodes={'A': (0, 0)}, fixed=['A'])\n```\n"
    )
    monkeypatch.setattr(parts, "PAGE", page)
    parts.write(tmp_path, "key")
    (tmp_path / "one.svg").unlink()
    parts.write(tmp_path, "key")
    assert not (tmp_path / "one.svg").exists()
    page.write_text(page.read_text() + "\n")
    parts.write(tmp_path, "key")
    assert (tmp_path / "one.svg").exists() and kt.__version__
