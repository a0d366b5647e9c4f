"""Names and values in the drawing lie neither over each other nor over a drive, at rest and in every picture of a motion."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import kinetruss as kt
from four_bars import four_bar

pytestmark = pytest.mark.slow

PICTURES = 60
LOOK = """(() => {
  const all = (kinds) => [...document.querySelectorAll(kinds)];
  const texts = all('.drawing .names text, .drawing .values text').filter((one) => one.getAttribute('display') !== 'none');
  const inner = ({ x, y, width, height }) => [x + 1, y + 2, x + width - 1, y + height - 2];
  const boxes = texts.map((one) => inner(one.getBBox()));
  const along = (one) => Array.from({ length: 40 }, (_, k) => one.getPointAtLength((k * one.getTotalLength()) / 39));
  const marks = all('.drawing path.drive').flatMap(along), words = texts.map((one) => one.textContent), found = [];
  const meet = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
  boxes.forEach((box, k) => {
    for (let j = 0; j < k; j++) if (meet(box, boxes[j])) found.push(`${words[k]} over ${words[j]}`);
    if (marks.some(({ x, y }) => meet(box, [x, y, x, y]))) found.push(`${words[k]} over a drive`);
  });
  return { found, shown: words.length, marks: marks.length, at: kinetruss.draw.play.index };
})()"""
WATCH = f"""(() => {{
  const {{ canvas, play }} = draw, update = canvas.update.bind(canvas);
  window.pictures = [];
  canvas.update = (quick) => {{ update(quick); if (play.playing) window.pictures.push({LOOK}); }};
}})()"""


def linkage(cells: int) -> kt.Model:
    """A four-bar whose rod is a truss of 4 `cells` - 1 bars, and a bar that stands alone; that and the crank turn all round."""
    model = four_bar((0.16, 0.9, 0.75), 0.85)
    start, end = (np.array(model.nodes[name].at) for name in "BC")
    step = (end - start) / cells
    above = 0.12 * np.array([-step[1], step[0]]) / np.linalg.norm(step)
    low, up = ["B", *(f"L{k}" for k in range(1, cells)), "C"], [f"U{k}" for k in range(cells)]
    nodes = {name: tuple(start + k * step) for k, name in enumerate(low)}
    nodes |= {name: tuple(start + (k + 0.5) * step + above) for k, name in enumerate(up)}
    pairs = [*pairwise(low), *pairwise(up), *zip(low, up, strict=False), *zip(up, low[1:], strict=True)]
    bars = {f"b{k}": pair for k, pair in enumerate(pairs)} | {"crank": ("A", "B"), "rocker": ("D", "C"), "hand": ("P", "Q")}
    loads = {f"F{name}": kt.NodalForce(node=name, force=(0, -100.0 - k)) for k, name in enumerate(["B", *up[::2], "Q"])}
    return kt.Model(
        nodes=model.nodes | nodes | {"P": (0.3, -0.1), "Q": (0.42, -0.1)}, fixed=dict.fromkeys("ADP", "xy"), bars=bars,
        loads=loads, drives={"motor": kt.AngleDrive("crank"), "other": kt.AngleDrive("hand")}, gravity=(0, 0),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("cells", "picked", "width"), [(10, ["crank", "b0", "hand"], 1440), (4, ["hand"], 1440), (10, ["crank", "hand"], 390)]
)
def test_no_words_lie_over_each_other_or_over_a_drive_while_it_plays(opened, cells, picked, width):
    model = linkage(cells)
    assert len(model.bars) == 4 * cells + 2
    hand = opened(model, width=width, height=844)
    for what in ({"members": ["crank", "b0"]}, {"members": ["hand"]}, {"nodes": ["A", "P"]}):
        hand.js("draw.ask({ do: 'dimension', ...given })", what)
    hand.js("(given.forEach((name) => draw.picked.members.add(name)), draw.repick())", picked)
    for lengths in (False, True):
        hand.js("(draw.shown.lengths !== given && draw.rail.toggle('lengths'), 0)", lengths)
        seen = hand.js(LOOK)
        assert (seen["found"], seen["marks"]) == ([], 80)
        assert seen["shown"] > 12
    hand.choose("drive that moves", "all drives")
    hand.js(WATCH)
    hand.button("▶ Play")
    hand.shown.until(f"window.pictures.length >= {PICTURES}")
    hand.js("(draw.play.pause(), 0)")
    pictures = hand.js("window.pictures")
    assert len({one["at"] for one in pictures}) > PICTURES / 4
    assert min(one["shown"] for one in pictures) > 8
    assert {words for one in pictures for words in one["found"]} == set()
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])
