"""Plant the faults of mutants.toml in the source, one at a time, and run the tests of that part: they must find each.

    .venv/bin/python tests/campaigns/mutants.py [--workers 2] [--only NAME] [--again]

A fault is a function, an expression of it and what takes its place, compared as syntax trees: so a place is found wherever the
function stands and however it is laid out. A worker has a copy of the source and of the tests, with the compiled kernels. First
the tests of every fault must pass without it. What is known of a fault, of the tests and of the source stays in DIR, so that a
run that was ended goes on. Progress goes to stderr; exit code 1 where a fault survives, has no place, or spoils the run itself.
"""

from __future__ import annotations

import argparse
import ast
import hashlib
import json
import os
import queue
import shlex
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import astuple, dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
TABLE = Path(__file__).with_suffix(".toml")
LONGEST = 300.0
"""Seconds that the tests of a fault may take."""
PLUGINS = ("-p", "no:cacheprovider", "-p", "_hypothesis_pytestplugin")
LEFT_OUT = shutil.ignore_patterns("kernels-*", ".hypothesis", ".pytest_cache")


@dataclass(frozen=True)
class Mutant:
    """A fault: in `function`, or Class.method, the expression or statement `before` becomes `after`; tests : for pytest."""

    name: str
    kind: str
    function: str
    before: str
    after: str
    tests: str


def read(table: Path = TABLE) -> list[Mutant]:
    """The faults of a table."""
    return [Mutant(name=name, **fields) for name, fields in tomllib.loads(table.read_text()).items()]


class PlaceError(LookupError):
    """A fault without a place, or with several."""


def _functions(tree: ast.AST, name: str) -> Iterator[ast.AST]:
    """The functions of a name, or those of Class.method."""
    owner, _, own = name.rpartition(".")
    within = [node for node in ast.walk(tree) if isinstance(node, ast.ClassDef) and node.name == owner] if owner else [tree]
    for one in within:
        yield from (node for node in ast.walk(one) if isinstance(node, ast.FunctionDef) and node.name == own)


def _syntax(text: str) -> ast.AST:
    """The tree of an expression or a statement."""
    node: ast.AST = ast.parse(text).body[0]
    return node.value if isinstance(node, ast.Expr) else node


def _same(node: ast.AST, other: ast.AST) -> bool:
    """Whether two trees are one expression, read or written."""
    return type(node) is type(other) and _form(node) == _form(other)


def _form(node: ast.AST) -> str:
    return ast.dump(node).replace("Store()", "Load()")


class Source:
    """The files of a package, with the trees of those that were asked for."""

    def __init__(self, folder: Path) -> None:
        self.texts = {file.relative_to(folder): file.read_bytes() for file in sorted(folder.rglob("*.py"))}
        self._trees: dict[Path, ast.AST] = {}

    def _tree(self, file: Path) -> ast.AST:
        if file not in self._trees:
            self._trees[file] = ast.parse(self.texts[file])
        return self._trees[file]

    def mutated(self, one: Mutant) -> tuple[Path, bytes]:
        """The file of a fault and its text with the fault. Lines keep their numbers."""
        wanted, head, found = _syntax(one.before), f"def {one.function.rpartition('.')[2]}(".encode(), []
        for file in (file for file, text in self.texts.items() if head in text):
            for function in _functions(self._tree(file), one.function):
                found += [(file, node) for node in ast.walk(function) if _same(node, wanted)]
        if len(found) != 1:
            raise PlaceError(f"the place is gone: {one.function} has {one.before!r} {len(found)} times, not once")
        file, node = found[0]
        text = self.texts[file]
        starts = [0]
        for line in text.splitlines(keepends=True):
            starts.append(starts[-1] + len(line))
        first, last = starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset
        lines = text[first:last].count(b"\n")
        after = one.after if isinstance(node, ast.stmt) else f"({one.after}{chr(10) * lines})"
        changed = text[:first] + after.encode() + text[last:]
        ast.parse(changed)
        return file, changed


class Worker:
    """A copy of the project in which tests run. kernels : where compiled ones are, shared by all workers."""

    def __init__(self, root: Path, place: Path, kernels: Path) -> None:
        self.place, self.own = place, place.with_name(f"{place.name}-kernels")
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        shutil.copy2(root / "pyproject.toml", place)
        for name in ("src", "tests"):
            shutil.copytree(root / name, place / name, ignore=LEFT_OUT)
        cache = place / "src/kinetruss/kernels/__pycache__"
        cache.mkdir(parents=True, exist_ok=True)
        (cache / kernels.name).symlink_to(kernels)
        self.package = place / "src/kinetruss"
        self.environment = os.environ | {"PYTHONPATH": str(place / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
        self.environment["PYTEST_DISABLE_PLUGIN_AUTOLOAD"] = "1"  # those of other packages take seconds to start
        for name in ("NUMBA_CACHE_DIR", "PYTEST_ADDOPTS"):
            self.environment.pop(name, None)
        where = self._python("-c", "import kinetruss; print(kinetruss.__file__)").stdout.strip()
        if Path(where) != self.package / "__init__.py":
            raise RuntimeError(f"the copy {self.package} is not what is imported, but {where}")

    def _python(self, *arguments: str, **more: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, *arguments], cwd=self.place, env=self.environment | more,
                              capture_output=True, text=True, timeout=LONGEST)  # fmt: skip

    def run(self, tests: str, **more: str) -> dict[str, Any]:
        """What becomes of tests: `found`, `survived` or `error`, with seconds and the line that says it."""
        start = time.monotonic()
        line = ["-m", "pytest", "-x", "-q", *PLUGINS, "--hypothesis-seed=0", *shlex.split(tests)]
        try:
            ended = self._python(*line, **more)
            verdict = {0: "survived", 1: "found"}.get(ended.returncode, "error")
            said = [text for text in ended.stdout.splitlines() if text.startswith(("FAILED", "ERROR"))]
            said += [text for text in ended.stdout.splitlines()[-1:] + ended.stderr.splitlines()[-1:] if text]
            if verdict == "found" and not said[0].startswith("FAILED"):
                verdict = "error"  # a fixture that fails, or a module that cannot be imported
        except subprocess.TimeoutExpired:
            verdict, said = "error", [f"not ended after {LONGEST:g} s"]
        return {"verdict": verdict, "seconds": round(time.monotonic() - start, 1), "said": said[0][:300] if said else ""}

    def run_mutated(self, one: Mutant, file: Path, text: bytes) -> dict[str, Any]:
        """What becomes of a fault. Kernels with it go to a place of their own, and with it."""
        target = self.package / file
        before = target.read_bytes()
        shutil.rmtree(self.own, ignore_errors=True)
        try:
            target.write_bytes(text)
            return self.run(one.tests, NUMBA_CACHE_DIR=str(self.own))
        finally:
            target.write_bytes(before)
            shutil.rmtree(self.own, ignore_errors=True)


def _hash(*parts: object) -> str:
    return hashlib.sha256(repr(parts).encode()).hexdigest()[:16]


def state_of(root: Path) -> str:
    """A hash of the source and of what tests have in common."""
    files = [*(root / "src").rglob("*.py"), *(root / "tests").glob("*.py"), *(root / "tests/reference").rglob("*.py")]
    return _of_files(root, files)


def tests_of(root: Path, tests: str) -> str:
    """A hash of tests and of their files."""
    places = [root / word for word in shlex.split(tests) if (root / word).exists()]
    return _hash(tests, _of_files(root, [file for one in places for file in ([one] if one.is_file() else one.rglob("*.py"))]))


def _of_files(root: Path, files: Iterable[Path]) -> str:
    return _hash(*((str(file.relative_to(root)), hashlib.sha256(file.read_bytes()).digest()) for file in sorted(files)))


class Campaign:
    """The faults, what is known of them, and the workers."""

    def __init__(self, mutants: Sequence[Mutant], root: Path, work: Path, workers: int, again: bool) -> None:
        self.mutants, self.work, self.workers, self.root = mutants, work, workers, root
        self.log, self.state = work / "found.jsonl", state_of(root)
        work.mkdir(parents=True, exist_ok=True)
        lines = self.log.read_text().splitlines() if self.log.exists() and not again else []
        self.known = {one["key"]: one for one in map(json.loads, lines)}
        self.free: queue.Queue[Worker] = queue.Queue()
        self.source = Source(root / "src/kinetruss")

    def outcomes(self) -> dict[str, dict[str, Any]]:
        """What becomes of every fault, by name."""
        found, ready = {}, []
        for one in self.mutants:
            try:
                ready.append((one, *self.source.mutated(one)))
            except (PlaceError, SyntaxError) as error:
                found[one.name] = {"verdict": "no place", "seconds": 0.0, "said": str(error)}
        keys = {one.name: self._key(one.tests, astuple(one)) for one, *_ in ready}
        left = [job for job in ready if keys[job[0].name] not in self.known]
        if left:
            self._start(min(self.workers, len(left)))
            sound = {tests: self._key(tests) for tests in dict.fromkeys(job[0].tests for job in left)}
            new = [tests for tests, key in sound.items() if key not in self.known]
            self._each([(f"without faults: {tests}", sound[tests], (tests,)) for tests in new])
            good = [job for job in left if self.known[sound[job[0].tests]]["verdict"] == "survived"]
            self._each([(job[0].name, keys[job[0].name], job) for job in good])
        bad = {"verdict": "error", "seconds": 0.0, "said": "the tests fail without the fault, too"}
        return found | {one.name: self.known.get(keys[one.name], bad) for one, *_ in ready}

    def _key(self, tests: str, *more: object) -> str:
        return _hash(self.state, tests_of(self.root, tests), *more)

    def _start(self, count: int) -> None:
        kernels = next(iter((self.root / "src/kinetruss/kernels/__pycache__").glob("kernels-*")), None)
        name = kernels.name if kernels else f"kernels-{sys.version_info[0]}{sys.version_info[1]}"
        (shared := self.work / name).mkdir(exist_ok=True)
        if kernels is not None:
            shutil.copytree(kernels, shared, dirs_exist_ok=True)
        for k in range(count):
            self.free.put(Worker(self.root, self.work / f"worker-{k}", shared))

    def _each(self, jobs: Sequence[tuple[str, str, tuple[Any, ...]]]) -> None:
        """Run jobs (what is said of it, key, arguments) by all workers; lines of progress and of the log."""
        with ThreadPoolExecutor(max(1, self.free.qsize())) as pool:
            waiting = [pool.submit(self._one, job) for job in jobs]
            for k, (text, outcome) in enumerate((one.result() for one in as_completed(waiting)), 1):
                self.known[outcome["key"]] = outcome
                with self.log.open("a") as log:
                    log.write(json.dumps(outcome) + "\n")
                shown = f"{k} of {len(jobs)}: {text}: {outcome['verdict']}, {outcome['seconds']} s: {outcome['said']}"
                print(shown, file=sys.stderr, flush=True)

    def _one(self, job: tuple[str, str, tuple[Any, ...]]) -> tuple[str, dict[str, Any]]:
        text, key, arguments = job
        worker = self.free.get()
        try:
            outcome = worker.run_mutated(*arguments) if len(arguments) > 1 else worker.run(*arguments)
        finally:
            self.free.put(worker)
        return text, {"key": key, "name": text, **outcome}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the campaign; 1 where a fault is not found."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--work", type=Path, default=ROOT / "build/mutants", metavar="DIR")
    options.add_argument("--only", action="append", metavar="NAME", help="only this fault; may be repeated")
    options.add_argument("--workers", type=int, default=2)
    options.add_argument("--again", action="store_true", help="forget what is known")
    chosen = options.parse_args(arguments)
    mutants = read()
    if unknown := set(chosen.only or ()) - {one.name for one in mutants}:
        options.error(f"unknown: {', '.join(sorted(unknown))}. Faults: {', '.join(one.name for one in mutants)}")
    mutants = [one for one in mutants if not chosen.only or one.name in chosen.only]
    found = Campaign(mutants, ROOT, chosen.work.absolute(), chosen.workers, chosen.again).outcomes()
    for one in mutants:
        outcome = found[one.name]
        print(f"{one.name:32} {one.kind:10} {outcome['verdict']:9} {outcome['seconds']:6.1f} s  {outcome['said']}")
    count = sum(outcome["verdict"] == "found" for outcome in found.values())
    print(f"found {count} of {len(mutants)}, {sum(outcome['seconds'] for outcome in found.values()):.0f} s")
    return 0 if count == len(mutants) else 1


if __name__ == "__main__":
    sys.exit(main())
