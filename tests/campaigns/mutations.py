"""Model files put wrong at random: the trees they start from, changes that know what a model file is made of, damaged bytes."""

from __future__ import annotations

import contextlib
import copy
import json
import re
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from typing import Any

import yaml

import kinetruss as kt

Place = tuple[Any, ...]

NUMBERS = [
    "0", "-0.0", "1", "-1", "0.5", "3", "1e-9", "1e9", "1e15", "1e-15", "1e30", "-1e30", "1e31", "1e200", "-1e308", "1e400",
    "5e-324", "nan", ".inf", "-Infinity", "0x10", "1_000", "1,5", "1e5e5", "12:30", "9" * 400, "²", "true", "~", "",
]  # fmt: skip
UNITS = [
    "m",
    "mm",
    "kg",
    "N",
    "deg",
    "rad",
    "s",
    "Hz",
    "GPa",
    "N m/rad",
    "rev/s",
    "parsec",
    "m^99",
    "m/",
    "/m",
    "m**2",
    "m m m m m m m m",
]
MOST_TEXT = 20_000_000
"""Characters of a table that is made of thousands of equal entries."""
FACTORS = [-1, 0, 0.5, 2, 1 + 1e-9, 10, 0.1, 1e3, 1e-3, 1e6, 1e-6, 1e12, 1e-12, 1e40, 1e-40, 1e200]
NAMES = [
    "", " ", "a b", "a/b", "é", "e\u0301", "名前", "\u202eABC", "\u200b", "😀", "x" * 3000, "\x1b[31mred\x1b[0m", "\x07",
    "a\nb", "../../x", "null", "1e3", "__class__", "{0}", "%s", "<b>", "&x", "*x", "!!x", "#", "N.4", "-", "'", '"',
]  # fmt: skip
SHAPES: list[Any] = [
    "",
    "~",
    "text",
    [],
    {},
    ["1", "2", "3"],
    [["1", "2"], ["3"]],
    {"kind": "rigid"},
    {"file": "."},
    {"file": "none.csv"},
    {"": ""},
]
NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(.*)", re.DOTALL)


def _with_nothing(tree: Any) -> Any:
    """A tree of texts with None for ``null`` and ``~``: of entries taken out of a library model, and of no limit."""
    if isinstance(tree, dict):
        return {key: _with_nothing(value) for key, value in tree.items()}
    if isinstance(tree, list):
        return [_with_nothing(value) for value in tree]
    return None if tree in ("null", "~") else tree


def bases() -> dict[str, Any]:
    """Name -> tree of every shipped example file, and of some models written out in full."""
    found, models = {}, {}
    for name, paths in kt.library.example_files().items():
        found[name] = _with_nothing(yaml.load(paths[0].read_text("utf-8"), yaml.BaseLoader))
        models[name] = kt.read(paths[0])
    plate = kt.library.meshes.rectangle(width=2.0, height=0.5, columns=3, rows=2, six_nodes=True)
    models["plate"] = kt.Model(
        nodes=plate.nodes, fixed=plate.at(x=0.0), material=kt.library.materials.STEEL_S235,
        membranes={"web": plate.membrane(thickness=0.01, strain="linear")},
        loads={"tip": kt.NodalForce(node=plate.nearest((2.0, 0.25)), force=(0, -5e3))},
        runs={"go": kt.Run(analysis="dynamics.simulate", t_end=0.002, samples=5, method=kt.EnergyMomentum(step=1e-4))},
    )  # fmt: skip
    models["door"] = kt.Model(
        nodes={"A": (0, 0, 0), "B": (0, 0, 1), "C": kt.Node(at=(0.9, 0, 0.3), mass=2.0), "D": (0, -1, 0)},
        fixed=["A", "B", "D"], bars={"low": kt.Bar(ends=("A", "C"), mass=0), "high": kt.Bar(ends=("B", "C"), mass=0)},
        drives={"turn": kt.HingeDrive(axis=("A", "B"), start="D", end="C")},
        runs={"go": kt.Run(trajectory=kt.Quintic(moves={"turn": ("90 deg", "400 deg")}, duration=2.0), samples=11)},
    )  # fmt: skip
    models |= _with_inner_parts()
    with tempfile.TemporaryDirectory() as folder:
        for name, model in models.items():
            if len(model.members) < 80:
                file = kt.write(model, Path(folder) / "model.yaml")
                found[f"{name}, written out"] = _with_nothing(yaml.load(file.read_text("utf-8"), yaml.BaseLoader))
    return found


def _with_inner_parts() -> dict[str, kt.Model]:
    """Models with nodes and bars of their own: of hubs, beams, clamps and hinges."""
    matter: dict[str, Any] = {"section": kt.Rod(diameter=0.02), "material": "steel_s235"}
    four_bar = kt.Model(
        nodes={"A": (0, 0), "B": (0.05, 0.15), "C": (0.75, 0.45), "D": (0.9, 0)}, fixed=["A", "D"],
        bars={"crank": ("A", "B"), "coupler": ("B", "C"), "rocker": ("C", "D")},
        hubs={
            "B": kt.Hub(arms={"coupler": (0.03, 0.04)}, clamped=["crank"]),
            "C": kt.Hub(arms={"coupler": "40 mm"}, clamped=["rocker"]), "D": kt.Hub(reach=0.025),
        },
        **matter,
    )  # fmt: skip
    tripod = kt.Model(
        nodes={"A": (0, 0, 0), "B": (1, 0, 0), "C": (0.5, 0.8, 0), "D": (0.5, 0.3, 0.8)}, fixed=["A", "B", "C"],
        bars={"a": ("A", "D"), "b": ("B", "D"), "c": kt.Bar(ends=("C", "D"), kind="driven")},
        hubs={"D": kt.Hub(reach=0.05, hinges={"a": (-0.8, 0.5, 0)}), "A": kt.Hub(arms={"a": "30 mm"})},
        loads={"m": kt.BodyCouple(body="D.hub", moment=(0, 0, 1), member="b")}, **matter,
    )  # fmt: skip
    frame = kt.Model(
        nodes={"A": (0, 0, 0), "B": (1, 0, 0), "C": (1, 1, 0), "D": (1, 1, 1), "E": (2, 1, 1)},
        clamped=["A"], fixed=["E"], bodies={"box": kt.Body(nodes=("C", "D", "B"), mass=1.0)}, bars={"t": ("A", "D")},
        beams={
            "b": ("A", "B"), "c": kt.Beam(ends=("B", "C"), hinges={"B": (0, 0, 1)}),
            "d": kt.Beam(ends=("C", "D"), kind="rigid"),
            "e": kt.Beam(ends=("D", "E"), release=["D", "E"]),
        },
        loads={"m": kt.BodyCouple(body="B", moment=(0, 0, 1))}, **matter,
    )  # fmt: skip
    crane = kt.Model(
        nodes={"A": (0, 0), "B": (1, 0.5), "C": (2, 1), "D": (0, -1), "E": (3, 1)}, fixed=["A", "D"], clamped={"C": "box"},
        bodies={"box": kt.Body(nodes=("C", "E"), mass=1.0)}, beams={"ab": ("A", "B"), "bc": ("B", "C")},
        bars={"ram": kt.Bar(ends=("D", "B"), kind="driven")}, **matter,
    )  # fmt: skip
    return {"hubs": four_bar, "hub in space": tripod, "frame": frame, "crane": crane}


def vocabulary(trees: list[Any]) -> list[str]:
    """Keys and words of the schema and of the trees."""
    found = (part for tree in [kt.io.schema(), *trees] for place in places(tree) for part in (*place[-1:], at(tree, place)))
    return sorted({word for word in found if isinstance(word, str) and re.fullmatch(r"[A-Za-z_][\w.]{0,30}", word)})


def places(tree: Any, here: Place = ()) -> Iterator[Place]:
    """The place of everything in a tree."""
    yield here
    below = tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    for key, value in below:
        yield from places(value, (*here, key))


def at(tree: Any, place: Place) -> Any:
    """What stands at a place."""
    for key in place:
        tree = tree[key]
    return tree


class Mutant:
    """A tree, and one change after another made to it."""

    def __init__(self, dice: Random, tree: Any, others: list[Any], words: list[str]) -> None:
        self.dice, self.tree, self.others, self.words = dice, copy.deepcopy(tree), others, words

    def change(self, *, mild: bool) -> None:
        """One change; a mild one keeps most models whole, so that they can be run."""
        rough: list[Callable[[], None]] = [
            self.number, self.unit, self.rename, self.shape, self.repeat, self.long, self.nest, self.many, self.name,
        ]  # fmt: skip
        soft: list[Callable[[], None]] = [
            self.scale, self.scale, self.remove, self.refer, self.insert, self.graft, self.swap, self.word,
        ]  # fmt: skip
        change = self.dice.choice([self.scale] * 10 + soft if mild else rough + soft)
        with contextlib.suppress(IndexError, TypeError, KeyError, AttributeError):  # the tree has nothing of that sort
            change()
        if sum(1 for _ in zip(places(self.tree), range(200_000), strict=False)) == 200_000:
            self.tree = self.others[0]  # files of a size that the campaign itself cannot hold

    def _pick(self, fits: Callable[[Any], bool]) -> Place:
        return self.dice.choice([place for place in places(self.tree) if place and fits(at(self.tree, place))])

    def _put(self, place: Place, value: Any) -> None:
        at(self.tree, place[:-1])[place[-1]] = copy.deepcopy(value)

    def _set(self, values: list[Any], fits: Callable[[Any], bool]) -> None:
        self._put(self._pick(fits), self.dice.choice(values))

    def number(self) -> None:
        """Another number, or what only looks like one."""
        self._set(NUMBERS, is_number)

    def scale(self) -> None:
        """A number times a factor, its unit kept."""
        place = self._pick(is_number)
        number, unit = NUMBER.fullmatch(at(self.tree, place)).groups()  # type: ignore[union-attr]
        self._put(place, f"{float(number) * self.dice.choice(FACTORS)!r}{unit}")

    def unit(self) -> None:
        """A number in another unit."""
        place = self._pick(is_number)
        number = NUMBER.fullmatch(at(self.tree, place))[1]  # type: ignore[index]
        self._put(place, f"{number} {self.dice.choice(UNITS)}")

    def remove(self) -> None:
        """An entry is taken out."""
        place = self._pick(lambda _: True)
        del at(self.tree, place[:-1])[place[-1]]

    def rename(self) -> None:
        """A key is called otherwise; the order stays."""
        place = self._pick(lambda value: isinstance(value, dict) and bool(value))
        table = at(self.tree, place)
        old, new = self.dice.choice(list(table)), self.dice.choice([*NAMES, *self.words, *list(table)])
        self._put(place, {(new if key == old else key): value for key, value in table.items()})

    def shape(self) -> None:
        """A value of another form."""
        place = self._pick(lambda _: True)
        value = at(self.tree, place)
        self._put(place, self.dice.choice([*SHAPES, [value], [value, value], {"at": value}, {"ends": value}]))

    def repeat(self) -> None:
        """A list shorter, longer, or the other way round."""
        place = self._pick(lambda value: isinstance(value, list) and bool(value))
        values = at(self.tree, place)
        self._put(
            place, self.dice.choice([values[:-1], values[1:], [*values, values[0]], values[::-1], values * 2, values * 500])
        )

    def swap(self) -> None:
        """Two entries change places."""
        one, two = self._pick(lambda _: True), self._pick(lambda _: True)
        if one[: len(two)] != two and two[: len(one)] != one:
            first, second = at(self.tree, one), at(self.tree, two)
            self._put(one, second)
            self._put(two, first)

    def refer(self) -> None:
        """A name refers to what another one refers to."""
        self._put(self._pick(is_word), at(self.tree, self._pick(is_word)))

    def word(self) -> None:
        """A word of the schema or of another model."""
        self._set(self.words, is_word)

    def name(self) -> None:
        """A name that is none."""
        self._set(NAMES, lambda value: isinstance(value, str))

    def insert(self) -> None:
        """A key of the schema where it may not belong."""
        place = self.dice.choice([place for place in places(self.tree) if isinstance(at(self.tree, place), dict)])
        value = self.dice.choice(
            ["1", "-1", "0", "1e9", "true", "A", "1 m", "1 N", ["A", "B"], ["1", "2", "3"], {"kind": "rod"}, *SHAPES]
        )
        at(self.tree, place)[self.dice.choice(self.words)] = copy.deepcopy(value)

    def graft(self) -> None:
        """A piece of another model."""
        other = self.dice.choice(self.others)
        self._put(self._pick(lambda _: True), at(other, self.dice.choice(list(places(other))[1:])))

    def long(self) -> None:
        """A text as long as a book."""
        self._set(["x" * 100, "9" * 1000, "m " * 10**5, "é" * 10**6, "[" * 10**5], lambda value: isinstance(value, str))

    def nest(self) -> None:
        """A value in many brackets."""
        place = self._pick(lambda _: True)
        value = at(self.tree, place)
        for _ in range(self.dice.choice([3, 40, 100])):
            value = [value] if self.dice.random() < 0.5 else {"a": value}
        at(self.tree, place[:-1])[place[-1]] = value

    def many(self) -> None:
        """A table with thousands of entries."""
        table = at(self.tree, self._pick(lambda value: isinstance(value, dict) and bool(value)))
        count, entry = self.dice.choice([10, 3000]), next(iter(table.values()))
        # thousands of tables of thousands would fill the memory before anybody reads them
        count = min(count, max(10, MOST_TEXT // len(json.dumps(entry))))
        # each its own, so that the next change alters one of them
        table |= {f"k{i}": copy.deepcopy(entry) for i in range(count)}


def is_number(value: Any) -> bool:
    """A text that begins with a number."""
    return isinstance(value, str) and NUMBER.fullmatch(value) is not None


def is_word(value: Any) -> bool:
    """A text that does not."""
    return isinstance(value, str) and NUMBER.fullmatch(value) is None


def as_bytes(tree: Any, suffix: str) -> bytes:
    """The tree as a file; all scalars are text."""
    text = (
        json.dumps(tree, ensure_ascii=False) if suffix == ".json" else yaml.safe_dump(tree, sort_keys=False, allow_unicode=True)
    )
    return text.encode("utf-8", "surrogatepass")


def damaged(data: bytes, dice: Random) -> bytes:
    """The bytes as a disk, an editor or a careless hand may leave them."""
    i, j = sorted(dice.randrange(len(data) + 1) for _ in range(2))
    lines = data.split(b"\n")
    k = dice.randrange(len(lines))
    sign = dice.choice(
        [
            b"[",
            b"]",
            b"{",
            b"}",
            b": ",
            b",",
            b"\t",
            b'"',
            b"|",
            b"&x ",
            b"*x",
            b"!!python/name:os.system ",
            b"#",
            b"\x00",
            b"--- ",
            b"\x1b",
        ]
    )
    bomb = b"\n".join(
        [b"a0: &a0 [x, x, x, x]"] + [b"a%d: &a%d [%s]" % (n, n, b", ".join([b"*a%d" % (n - 1)] * 9)) for n in range(1, 12)]
    )
    return dice.choice([
        data[:i], data[:i] + data[j:], data[:i] + dice.randbytes(8) + data[i:], data[:i] + sign + data[i:], data * 2,
        b"\n".join(lines[:k] + lines[k + 1 :]), b"\n".join(lines[: k + 1] + lines[k:]),
        b"\n".join([*lines[:k], sign + lines[k], *lines[k + 1 :]]), data + b"\n" + bomb, b"[" * 10**5, b"{a: " * 10**4,
        data.decode("utf-8", "replace").encode("utf-16"), data.replace(b"\n", b"\r"),
    ])  # fmt: skip
