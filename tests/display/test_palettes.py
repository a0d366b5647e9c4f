"""Colours: enough contrast in light and dark, and one meaning each, also for colour-blind readers."""

import itertools

import numpy as np
import pytest

from kinetruss.display import DIVERGING, DRIVEN, ELASTIC, LOAD, OVER, SEQUENTIAL, THEMES, contrast, rgb
from kinetruss.report.pictures.specs import ALARM, INK, QUIET

TEXT, GRAPHICS = 4.5, 3.0  # WCAG 2.2, 1.4.3 and 1.4.11

# Machado, Oliveira and Fernandes (2009), IEEE Trans. Vis. Comput. Graph. 15, 1291: table 1, severity 1, for linear RGB
SEEN = {
    "all": np.eye(3),
    "protan": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deutan": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
}


def apart(one: str, other: str, seen: str) -> float:
    """Difference of two colours in CIELAB (CIE 1976), as a kind of reader sees them."""
    found = []
    for colour in (one, other):
        share = rgb(colour) / 255
        linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
        to_xyz = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
        xyz = to_xyz @ np.clip(np.array(SEEN[seen]) @ linear, 0, 1) / [0.9505, 1.0, 1.089]
        x, y, z = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
        found.append(np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)]))
    return float(np.linalg.norm(found[0] - found[1]))


@pytest.mark.parametrize("theme", THEMES)
def test_text_and_graphics_stand_out_from_the_page(theme):
    colours = THEMES[theme]
    for ground in ("back", "card"):
        for text in ("ink", "faint", "accent", "alarm", "pen-1", "pen-2", "pen-3"):
            assert contrast(colours[text], colours[ground]) >= TEXT, (text, ground)
    assert contrast(colours["ink"], colours["pressed"]) >= TEXT
    # rims make members of any colour visible
    for mark in ("outline", "node", "support", "halo"):
        assert contrast(colours[mark], colours["back"]) >= GRAPHICS, mark
    for mark in (DRIVEN, LOAD, OVER):
        assert contrast(mark, colours["back"]) >= GRAPHICS, mark
    assert contrast("#ffffff", OVER) >= TEXT  # the verdict of an overload


def test_quiet_text_on_paper_can_be_read():
    for text in (INK, QUIET, ALARM):
        assert contrast(text, "#ffffff") >= TEXT


@pytest.mark.parametrize("seen", SEEN)
def test_a_colour_has_one_meaning(seen):
    meanings = {"driven": DRIVEN, "compression": DIVERGING[1], "load": LOAD, "elastic": ELASTIC}
    for (one, a), (other, b) in itertools.combinations(meanings.items(), 2):
        assert apart(a, b, seen) > 12, (one, other)
    assert min(apart(OVER, one, seen) for one in (DRIVEN, LOAD, *SEQUENTIAL)) > 15
