"""Compiled kernels on disk under ill treatment: damaged, swept, half written; many first starts at once; no place at all.

    .venv/bin/python tests/campaigns/cache.py --work DIR [--rounds 60] [--starts 5] [--seed 1]

Rounds damage the files of a small kernel of three signatures at random, and start one or several processes on them. Then a copy
of the package is used as an image of a container is: without the right to write, without a home, on a full disk, by several at
once, after a change of one file. Every process must give the right numbers without a traceback; what is whole must be found.
Exit code 1 where that is not so.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import kinetruss

SMALL = """
import json, sys, warnings
from pathlib import Path
import numba
from kinetruss.kernels.compiled.caches import Keeper, Kept
def add(a, b):
    return a + b
found = numba.njit(add)
found._cache = Kept(Keeper({"<string>": sys.argv[1]}, [Path(place) for place in sys.argv[2:]]), add)
with warnings.catch_warnings(record=True) as told:
    warnings.simplefilter("always")
    right = [found(1, 2), found(1.5, 2.0), found(1j, 1)] == [3, 3.5, 1 + 1j]
print(json.dumps({"right": right, "hits": sum(found.stats.cache_hits.values()), "told": len(told)}))
"""
FORMS = 3
PACKAGE = """
import json, resource, sys, warnings
import numpy as np
if len(sys.argv) > 1:
    resource.setrlimit(resource.RLIMIT_FSIZE, (int(sys.argv[1]), resource.getrlimit(resource.RLIMIT_FSIZE)[1]))
with warnings.catch_warnings(record=True) as told:
    warnings.simplefilter("always")
    from kinetruss.kernels.structure.lengths import lengths
    x = np.zeros((1, 6)); x[0, 3:] = (3.0, 4.0, 12.0)
    out = [np.zeros((1, 1)) for _ in range(3)]
    lengths(np.array([0]), np.array([1]), x, 0 * x, 0 * x, *out)
hits = sum(lengths.entry.stats.cache_hits.values())
print(json.dumps({"right": bool(out[0][0, 0] == 13.0), "hits": hits, "told": len(told)}))
"""
DAMAGES = ("empty", "cut", "noise", "bit", "longer", "swapped", "gone", "unreadable", "draft")


class Campaign:
    """The rounds. faults : what was wrong. counts : what happened."""

    def __init__(self, work: Path, starts: int, seed: int) -> None:
        self.work, self.starts, self.dice = work, starts, random.Random(seed)
        self.faults: list[str] = []
        self.counts: Counter[str] = Counter()
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        self.bound = _bound()

    def fault(self, text: str) -> None:
        self.faults.append(text)
        print(f"FAULT {text}", file=sys.stderr, flush=True)

    def start(self, what: str, command: Sequence[object], *, count: int = 1, bound: bool = False,
              environment: dict[str, str] | None = None) -> list[dict[str, int]]:  # fmt: skip
        """What some processes say that are started at once."""
        line = [*(self.bound or [] if bound else []), sys.executable, "-c", *map(str, command)]
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "env": environment}
        running = [subprocess.Popen(line, **pipes) for _ in range(count)]  # type: ignore[call-overload]
        answers = []
        for one in running:
            out, error = one.communicate(timeout=300)
            self.counts[what] += 1
            if one.returncode or _beside_compiling(error):
                self.fault(f"{what}: exit code {one.returncode}: {error[-1500:]}")
                continue
            answers.append(json.loads(out))
            if not answers[-1]["right"]:
                self.fault(f"{what}: wrong numbers")
        return answers

    def expect(self, what: str, answers: Sequence[dict[str, int]], **wanted: int) -> None:
        for one in answers:
            if any(one[name] != value for name, value in wanted.items()):
                self.fault(f"{what}: {one}, expected {wanted}")

    # -- a small kernel --------------------------------------------------------------------------------------------

    def damaged(self) -> None:
        """Files broken at random, processes at once; in the end everything is found again."""
        place = self.work / "small"
        if not place.exists():
            self.start("first start", [SMALL, "s" * 16, place])
        files = sorted(place.glob("*/*.kernel"))
        hit = {self.dice.choice(files): self.dice.choice(DAMAGES) for _ in range(self.dice.randrange(1, FORMS + 1))}
        for file, how in hit.items():
            self.damage(file, how)
        what = "+".join(sorted(set(hit.values())))
        count = self.dice.choice((1, 1, 2, self.starts))
        answers = self.start(what, [SMALL, "s" * 16, place], count=count, bound=True)
        if count == 1 and (self.bound is not None or "unreadable" not in hit.values()):
            lost = sum(how != "draft" for how in hit.values())
            self.expect(what, answers, hits=FORMS - lost, told=0)
        self.expect(f"after {what}", self.start(f"after {what}", [SMALL, "s" * 16, place], bound=True), hits=FORMS, told=0)

    def damage(self, file: Path, how: str) -> None:
        data = file.read_bytes()
        at = self.dice.randrange(len(data))
        if how == "gone":
            file.unlink()
        elif how == "unreadable":
            file.chmod(0)
        elif how == "draft":  # of a process that was killed
            file.with_name(f"{file.name}.1-1.part").write_bytes(data[:at])
        else:
            file.write_bytes({
                "empty": b"", "cut": data[:at], "noise": self.dice.randbytes(len(data)), "longer": data + b"\0",
                "bit": data[:at] + bytes([data[at] ^ (1 << self.dice.randrange(8))]) + data[at + 1 :],
                "swapped": data[16:] + data[:16],
            }[how])  # fmt: skip

    def states(self) -> None:
        """Processes of two states of the source at once, on one place."""
        place = self.work / "states"
        for state in ("a" * 16, "b" * 16):
            self.start("two states", [SMALL, state, place], count=2)
        line = [sys.executable, "-c", SMALL]
        running = [subprocess.Popen([*line, state * 16, str(place)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                   for state in "abab"]  # fmt: skip
        for one in running:
            out, error = one.communicate()
            if one.returncode or _beside_compiling(error) or not json.loads(out)["right"]:
                self.fault(f"two states at once: {error[-800:]}")

    # -- the package as an image -----------------------------------------------------------------------------------

    def image(self) -> None:
        """A copy of the package, used by one who may not write."""
        root = self.work / "image"
        package = root / "kinetruss"
        shutil.copytree(
            Path(kinetruss.__file__).parent, package, ignore=shutil.ignore_patterns("__pycache__", "*.js", "examples")
        )
        kernels = package / "kernels"
        bare = {key: value for key, value in os.environ.items() if key not in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME")}
        bare |= {"PYTHONPATH": str(root), "HOME": str(self.work / "nowhere"), "PYTHONDONTWRITEBYTECODE": "1"}
        full = self.start("full disk", [PACKAGE, 1000], environment=bare)
        self.expect("full disk", full, hits=0, told=1)
        if self.bound is not None:
            shutil.rmtree(kernels / "__pycache__")
            kernels.chmod(0o555)
            self.expect("no place", self.start("no place", [PACKAGE], bound=True, environment=bare), hits=0, told=1)
            home = bare | {"XDG_CACHE_HOME": str(self.work / "user")}
            self.expect("a home", self.start("a home", [PACKAGE], bound=True, environment=home), hits=0, told=0)
            self.expect("a home", self.start("a home", [PACKAGE], bound=True, environment=home), hits=1, told=0)
            kernels.chmod(0o755)
        self.expect("at once", self.start("at once", [PACKAGE], count=self.starts, environment=bare), told=0)
        self.expect("image", self.start("image", [PACKAGE], environment=bare), hits=1, told=0)
        if self.bound is not None:
            for item in [*kernels.rglob("*"), kernels]:
                item.chmod(0o555 if item.is_dir() else 0o444)
            found = self.start("read-only image", [PACKAGE], count=2, bound=True, environment=bare)
            self.expect("read-only image", found, hits=1, told=0)
            for item in [*kernels.rglob("*"), kernels]:
                item.chmod(0o755 if item.is_dir() else 0o644)
        for name, hits in (("motion/gimbal.py", 1), ("structure/lengths.py", 0)):  # another file, and its own
            with (kernels / name).open("a") as file:
                file.write("# changed\n")
            self.expect(f"{name} changed", self.start(f"{name} changed", [PACKAGE], environment=bare), hits=hits, told=0)


def _beside_compiling(error: str) -> list[str]:
    """Lines on stderr but those that say that kernels are compiled, which come when that takes a second."""
    return [line for line in error.splitlines() if not line.startswith("kinetruss: compil")]


def _bound() -> list[str] | None:
    """What makes modes of files hold for a child of root; None where that cannot be had."""
    if os.geteuid() != 0:
        return []
    if shutil.which("setpriv") is None:
        print("no setpriv: modes of files do not bind root, so what cannot be written is left out", file=sys.stderr)
        return None
    return ["setpriv", "--bounding-set=-all", "--inh-caps=-all", "--"]


def campaign(work: Path, rounds: int, starts: int, seed: int) -> Campaign:
    """So many rounds on a small kernel, then the package."""
    found = Campaign(work, starts, seed)
    for k in range(rounds):
        found.damaged()
        if (k + 1) % 10 == 0:
            print(f"{k + 1} of {rounds} rounds, {len(found.faults)} faults", file=sys.stderr, flush=True)
    found.states()
    found.image()
    return found


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the campaign; 1 at a fault."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--work", type=Path, required=True, help="folder to work in; what is in it goes")
    options.add_argument("--rounds", type=int, default=60)
    options.add_argument("--starts", type=int, default=5, help="processes at once")
    options.add_argument("--seed", type=int, default=1)
    chosen = options.parse_args(arguments)
    found = campaign(chosen.work / "cache", chosen.rounds, chosen.starts, chosen.seed)
    print(json.dumps({"rounds": chosen.rounds, "seed": chosen.seed, "faults": len(found.faults), "counts": found.counts}))
    return 1 if found.faults else 0


if __name__ == "__main__":
    sys.exit(main())
