"""The tree at hand against BASE, the revision before the house was cut anew: the same questions to both, by name.

    python tests/campaigns/base/compare.py [--count N] [--runs N] [--examples N] [--wrong N] [--seed N] [--work build/base]

--count random cases are assembled by every engine, --runs others solved through the public interface: both bit for bit.
What people read of --examples shipped models (reports, summaries, JSON, scenes) and of --wrong files put wrong at random is
compared as text (`shown`), line by line.
An entry of intended.toml says where a difference is meant, why, and how large it may be (`bound`, of the scale of the
quantity; "allowed": what another order of sums does, 1e-13 of the sum of the absolute values of the terms of what is
assembled, about that of its condition of what is solved, see `solved`).
BASE comes from the history and compiles its own kernels; its answers are kept in the work folder. Exit code 1 for a difference
that is not meant, or for a kind of element, load, drive or law that no case has;
3 where the history lacks BASE, so that nothing was compared.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from difflib import SequenceMatcher
from fnmatch import fnmatchcase
from functools import cache
from itertools import zip_longest
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "bench"))

from answers import Answer, Part, Refused, read, state_of
from revision import NoHistoryError, checkout, hash_of

HERE = Path(__file__).resolve().parent
TREE = HERE.parents[2]
BASE = "788c38d11ad5ff1e75b77ff7d7ba8d5b3f5cab91"
"""Commit that the tree must agree with."""
NOT_CHECKED = 3
MOST = 60
"""Differences that are listed."""
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
PROBE = "tests/campaigns/base/probe.py"
"""What a revision's engines assemble for a case, by its own modules."""
Side = tuple[Path, Path, Path]


@dataclass(frozen=True)
class Difference:
    """One quantity of one case that is not the same; where it is worst, share : of the scale, entries : that differ.

    allowed : share that another order of sums explains.
    """

    number: int
    name: str
    quantity: str
    place: str
    old: str
    new: str
    share: float
    entries: int = 1
    allowed: float = 0.0

    def __str__(self) -> str:
        more = f", and {self.entries - 1} more places" if self.entries > 1 else ""
        return (
            f"{self.number} {self.name}: {self.quantity} at {self.place}: {self.old} is now {self.new} ({self.share:.1e}){more}"
        )


@dataclass
class Found:
    """What a comparison found. counts : of quantities that agree; refused : of those that are errors on both sides."""

    differences: list[Difference] = field(default_factory=list)
    intended: Counter[str] = field(default_factory=Counter)
    counts: Counter[str] = field(default_factory=Counter)
    refused: Counter[str] = field(default_factory=Counter)
    covers: Counter[str] = field(default_factory=Counter)

    def take(self, old: Answer, new: Answer, rules: list[dict[str, Any]]) -> None:
        """Compare two answers to one question."""
        self.covers.update(old.covers)
        if old.fingerprint != new.fingerprint:
            self.differences.append(
                Difference(old.number, old.name, "question", "model", old.fingerprint, new.fingerprint, 1.0)
            )
            return
        for quantity in sorted(old.parts.keys() | new.parts.keys()):
            one, two = old.parts.get(quantity), new.parts.get(quantity)
            if isinstance(one, Refused) and one == two:
                self.refused[quantity] += 1
            elif (found := compared(one, two)) is None:
                self.counts[quantity] += 1
            else:
                allowed = one.allowed if isinstance(one, Part) else 0.0
                self.note(Difference(old.number, old.name, quantity, *found, allowed), rules, old.covers)

    def note(self, one: Difference, rules: list[dict[str, Any]], covers: Iterable[str]) -> None:
        for rule in rules:
            asked = ((one.quantity, "quantity"), (one.name, "kind"), (one.place, "place"), (one.old, "old"), (one.new, "new"))
            bound = one.allowed if rule["bound"] == "allowed" else rule["bound"]
            fits = all(fnmatchcase(what, rule.get(key, "*")) for what, key in asked)
            if fits and rule.get("covers", "") in ("", *covers) and one.share <= bound:
                self.intended[rule["reason"]] += 1
                return
        self.differences.append(one)


def compared(old: Part | Refused | None, new: Part | Refused | None) -> tuple[str, str, str, float, int] | None:
    """Where two parts differ most: place, both values, share of the scale, number of places; None where they agree."""
    if not (isinstance(old, Part) and isinstance(new, Part)):
        one, two = ("an answer" if isinstance(side, Part) else str(side) for side in (old, new))
        return "whole", one, two, np.inf, 1
    if tuple(map(sorted, old.places)) != tuple(map(sorted, new.places)):
        apart = {name for a, b in zip(old.places, new.places, strict=False) for name in {*a} ^ {*b}}
        return ", ".join(sorted(apart)[:4]) or "axes", str(old.value.shape), str(new.value.shape), np.inf, len(apart)
    was, now = sorted_by_name(old.value, old.places), sorted_by_name(new.value, new.places)
    scale = sorted_by_name(np.broadcast_to(np.asarray(old.scale, float), old.value.shape), old.places)
    same = (was == now) | (np.isnan(was) & np.isnan(now))
    if same.all():
        return None
    with np.errstate(invalid="ignore", divide="ignore"):
        off = np.where(same, -1.0, np.abs(now - was) / scale)
    off = np.where(np.isnan(off), np.inf, off)
    at = np.unravel_index(int(off.argmax()), off.shape)
    place = " / ".join(sorted(names)[k] for names, k in zip(old.places, at, strict=True)) or "value"
    return place, f"{was[at]:.17g}", f"{now[at]:.17g}", float(off.max()), int((~same).sum())


def sorted_by_name(value: np.ndarray, places: tuple[tuple[str, ...], ...]) -> np.ndarray:
    """The array with the places along every axis in the order of their names."""
    for axis, names in enumerate(places):
        value = np.take(value, sorted(range(len(names)), key=names.__getitem__), axis=axis)
    return value


def tree_of(revision: str, work: Path) -> Path:
    """The source of a revision in the work folder; its compiled kernels are kept beside it."""
    folder = work / revision[:12]
    if not (folder / "whole").exists():
        shutil.rmtree(folder, ignore_errors=True)
        checkout(revision, folder, "src", PROBE)
        (folder / "whole").touch()
    return folder / "src"


def asked(probe: Path, source: Path, answers: Path, options: list[str]) -> subprocess.Popen[bytes]:
    """A process in which a probe answers for a source; the cases and questions are those of this tree."""
    environment = {key: value for key, value in os.environ.items() if key != "NUMBA_CACHE_DIR"}
    environment |= {
        "PYTHONPATH": f"{source}{os.pathsep}{HERE}",
        "PYTHONFAULTHANDLER": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
    }
    return subprocess.Popen([sys.executable, str(probe), str(answers), *options], env=environment)


def pairs(old: Path, new: Path) -> Iterator[tuple[Answer, Answer]]:
    """Answers of both sides, as many as both were asked for."""
    for file in sorted(new.glob("*.answers"), key=lambda path: (path.name[:4], int(path.name.split("-")[1]))):
        yield from zip(read(old / file.name), read(file), strict=True)


def campaign(work: Path, seed: int, count: int, runs: int, source: Path = TREE / "src") -> Found:
    """Ask BASE and a source, and compare. work : folder in which BASE and its answers stay."""
    base = hash_of(BASE)
    files = [file for file in HERE.glob("*.py") if file.name not in ("probe.py", "compare.py", "shown.py")]
    files += [HERE.parents[1] / f"{name}.py" for name in ("action_models", "random_trusses")]
    kept = work / f"answers-{base[:12]}-{state_of(files)}-{seed}"
    was = tree_of(base, work)
    return side_by_side((was.parent / PROBE, was, kept), (TREE / PROBE, source, work), seed, count, runs)


def side_by_side(old: Side, new: Side, seed: int, count: int, runs: int) -> Found:
    """Ask two sides at once and compare. A side: the probe, the source, the folder for its answers; those of `new` go again."""
    options = ["--seed", str(seed), "--count", str(count), "--runs", str(runs)]
    with tempfile.TemporaryDirectory(dir=new[2]) as folder:
        sides = [(*new[:2], Path(folder), options)]
        if not (old[2] / f"whole-{count}-{runs}").exists():
            sides.append((*old, [*options, "--conditions"]))
        codes = [0] * len(sides)
        for turn in range(2):  # a process that was killed goes on from its last batch, once
            started = [asked(*side) if not turn or code < 0 else None for side, code in zip(sides, codes, strict=True)]
            codes = [code if one is None else one.wait() for one, code in zip(started, codes, strict=True)]
        if any(codes):
            raise RuntimeError(f"Probes ended with {codes} (new, old); their own words are above.")
        found = Found()
        for one, two in pairs(old[2], Path(folder)):
            found.take(one, two, intended())
        return found


@cache
def intended() -> list[dict[str, Any]]:
    """The differences that are meant."""
    found: list[dict[str, Any]] = tomllib.loads((HERE / "intended.toml").read_text()).get("difference", [])
    return found


def read_alike(work: Path, source: Path, examples: int, wrong: int, seed: int, found: Found) -> None:
    """Compare what both sides show, line by line; a text or line that one side lacks is a difference too."""
    sys.path.insert(0, str(HERE.parent))
    import fuzz

    with tempfile.TemporaryDirectory(dir=work) as folder:
        files, sides = Path(folder) / "wrong", [Path(folder) / "old", Path(folder) / "new"]
        files.mkdir()
        mill = fuzz.Mill(files)
        for number in range(wrong):
            mill.file(fuzz.Case(100_000 * seed + number, runs=False))
        options = ["--examples", str(examples), "--wrong", str(files)]
        sources = [tree_of(hash_of(BASE), work), source]
        started = [asked(HERE / "shown.py", one, side, options) for one, side in zip(sources, sides, strict=True)]
        if any(codes := [one.wait() for one in started]):
            raise RuntimeError(f"What is shown ended with {codes} (old, new); their own words are above.")
        for name in sorted({path.name for side in sides for path in side.glob("*.txt")}):
            old, new = (_lines(side / name) for side in sides)
            if old == new:
                found.counts["shown"] += 1
            else:
                for one in _differences(name.removesuffix(".txt"), old, new):
                    found.note(one, intended(), ())


def _lines(path: Path) -> list[str]:
    return path.read_text(encoding="utf-8", errors="surrogatepass").splitlines() if path.exists() else []


def _differences(name: str, old: list[str], new: list[str]) -> Iterator[Difference]:
    """Where two texts differ: every line, put beside the one that took its place."""
    for what, begin, end, now, last in SequenceMatcher(None, old, new, autojunk=False).get_opcodes():
        if what == "equal":
            continue
        both = zip_longest(old[begin:end], new[now:last], fillvalue="nothing")
        for line, (one, two) in enumerate(both, begin + 1):
            at = max(next(k for k, pair in enumerate(zip_longest(one, two)) if len({*pair}) > 1) - 40, 0)
            here = slice(at, at + 160)
            yield Difference(0, name, "shown", f"line {line}", one[here], two[here], _apart(one, two))


def _apart(one: str, two: str) -> float:
    """Largest relative difference of the numbers of two lines; infinite where other words stand between."""
    if NUMBER.split(one) != NUMBER.split(two):
        return np.inf
    pairs = [(float(a), float(b)) for a, b in zip(NUMBER.findall(one), NUMBER.findall(two), strict=True)]
    return max((abs(a - b) / max(abs(a), abs(b)) for a, b in pairs if a != b), default=np.inf)


def told(found: Found, missing: list[str]) -> None:
    """Print what was found."""
    print("agree: " + ", ".join(f"{name} {count}" for name, count in sorted(found.counts.items())))
    for word, counter in (
        ("refused alike", found.refused),
        ("intended", found.intended),
    ):
        if counter:
            print(f"{word}: " + ", ".join(f"{name} {count}" for name, count in sorted(counter.items())))
    if found.covers:
        print("cases with: " + ", ".join(f"{name} {count}" for name, count in sorted(found.covers.items())))
    for one in found.differences[:MOST]:
        print(one)
    if found.differences:
        by = Counter(one.quantity for one in found.differences)
        print(f"{len(found.differences)} differences: " + ", ".join(f"{name} {count}" for name, count in by.most_common()))
    if missing:
        print("no case has: " + ", ".join(missing))


def main() -> int:
    """The campaign of the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=2000, help="cases that are assembled (default: 2000)")
    parser.add_argument("--runs", type=int, default=100, help="cases that are solved (default: 100)")
    parser.add_argument("--examples", type=int, default=100, help="shipped models whose texts are compared (default: all)")
    parser.add_argument("--wrong", type=int, default=1000, help="files put wrong whose messages are (default: 1000)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--work", type=Path, default=TREE / "build" / "base")
    parser.add_argument("--source", type=Path, default=TREE / "src", help="the new side (default: this tree)")
    given = parser.parse_args()
    try:
        work, source = given.work.resolve(), given.source.resolve()
        found = campaign(work, given.seed, given.count, given.runs, source)
        read_alike(work, source, given.examples, given.wrong, given.seed, found)
    except NoHistoryError as error:
        print(f"NOT CHECKED: {error}")
        return NOT_CHECKED
    from covers import EVERY

    missing = [name for name in EVERY if not found.covers[name]]
    told(found, missing)
    agree = found.counts.total()
    print(f"{agree} quantities agree, {len(found.differences)} differ, {found.intended.total()} differ as intended")
    return 1 if found.differences or missing or not agree else 0


if __name__ == "__main__":
    sys.exit(main())
