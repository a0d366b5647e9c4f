"""TOML with places: the values of the standard library, each where it stands."""

from __future__ import annotations

import tomllib

import pytest

from kinetruss.design._catalogue import FOLDER
from kinetruss.errors import ModelError
from kinetruss.io.formats.toml import parse_toml
from kinetruss.io.formats.tree import plain

TEXT = '''# a comment with [brackets] and "quotes"
title = "a # no comment"  # but this is
long = """two
lines with "quotes" and \\"escaped\\" ones"""
raw = 'C:\\path' # literal
rawer = \'\'\'
literal "lines"\'\'\'
numbers = [1, 2.5, -3e4, # within
  0x1F, inf,
]
flag = true
day = 1979-05-27 07:32:00
a.b."c d" = 1

[tubes]
"1x2" = {outer = "1 in", inner = "0.5 in", more = {x = [{y = 1}, {y = 2}]}}
[tubes."2x3"]
outer = "2 in"

[[rows]]
n = 1
[[rows]]
n = 2
[rows.below]
m = 3
[a.e]
f = 2
'''


@pytest.mark.parametrize("text", [TEXT, TEXT.replace("\n", "\r\n"), "", "\n\n# nothing\n", "a=1", "[a]\n[a.b]\n[c]"])
def test_values_are_those_of_the_standard_library(text):
    tree, faults = parse_toml(text)
    assert faults == []
    assert plain(tree) == tomllib.loads(text)


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.toml")), ids=lambda path: path.stem)
def test_catalogues_that_are_shipped(path):
    text = path.read_text(encoding="utf-8")
    assert plain(parse_toml(text)[0]) == tomllib.loads(text)


def test_places():
    tree, _ = parse_toml(TEXT)
    lines = TEXT.split("\n")

    def at(word: str, skip: int = 0) -> tuple[int, int]:
        number = next(k for k, line in enumerate(lines) if word in line)
        return number + 1, lines[number].index(word) + 1 + skip

    assert tree.keys["title"] == at("title")
    assert tree.table["title"].place == at('"a # no')
    assert tree.table["numbers"].items[3].place == at("0x1F")
    assert tree.table["tubes"].keys["1x2"] == at('"1x2"')
    assert tree.table["tubes"].table["1x2"].table["inner"].place == at('"0.5 in"')
    assert tree.table["tubes"].table["2x3"].keys["outer"] == (18, 1)
    assert tree.table["rows"].items[1].table["below"].table["m"].place == (25, 5)
    assert tree.table["a"].table["e"].keys["f"] == (27, 1)


@pytest.mark.parametrize(
    ("text", "place"), [("a = 1\nb = \n", (2, 5)), ("a = [1,\n2\n", (2, 2)), ("a = 1\na = 2\n", (2, 6)), ("[a\n", (1, 3))]
)
def test_what_is_no_toml(text, place):
    with pytest.raises(ModelError) as caught:
        parse_toml(text)
    (fault,) = caught.value.faults
    assert (fault.line, fault.column) == place
    assert fault.message.startswith("is not TOML: ")
