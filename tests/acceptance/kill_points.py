"""Writers of run folders, killed before each of their operations on files, one after another.

    python tests/acceptance/kill_points.py [--only NAME] [--every 1]

After each kill: what can be read is right, `resume` or `run` or `run` with overwrite leads to the whole result, and nothing
temporary is left. Exit 1 on the first difference.
"""

from __future__ import annotations

import argparse
import os
import signal
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

import kinetruss as kt

WRITES = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC
CHANGES = ("os.rename", "os.remove", "os.mkdir", "os.rmdir", "os.truncate")


def writers() -> Iterator[tuple[str, kt.Model, dict[str, object]]]:
    """Names of writers, their models, and the arguments of `run`."""
    four = kt.read(kt.library.example_files()["four_bar"][0])
    name = next(iter(four.runs))
    short = four.with_(runs={name: four.runs[name].with_(samples=9)})
    yield "inverse", short, {"block": 4}
    ball = kt.Model(
        nodes={"O": (0, 0), "A": kt.Node(at=(1, 0), mass=1.0)},
        fixed=["O"],
        bars={"rod": kt.Bar(ends=("O", "A"), mass=0.0)},
        gravity=(0, -10),
    )
    fall = kt.Run(analysis="dynamics.simulate", t_end=1.0, samples=9)
    yield "simulate", ball.with_(runs={"fall": fall}), {"block": 4}
    yield (
        "mission",
        short.with_(runs=short.runs | {"all": kt.Run(analysis="mission", motions=(name,), samples=9)}),
        {"name": "all"},
    )
    yield "variants", short, {"settings": {"gravity": ["[0, -9.81]"]}}
    yield "two variants", short, {"settings": {"gravity": ["[0, -9.81]", "[0, -1.6]"]}}


def killed(work: Callable[[], object], folder: Path, point: int) -> bool:
    """Do work in a child that is killed before its operation number `point` in a folder; False if it ends before."""
    child = os.fork()
    if child:
        status = os.waitpid(child, 0)[1]
        if not os.WIFSIGNALED(status) and os.WEXITSTATUS(status):
            raise SystemExit(f"the writer failed before operation {point}")
        return os.WIFSIGNALED(status)
    count, inside, sync = 0, str(folder), os.fsync

    def meet(event: str, given: tuple[object, ...]) -> None:
        nonlocal count
        if event == "open" and isinstance(given[2], int) and not given[2] & WRITES:
            return
        if event not in ("open", "fsync", *CHANGES) or not (event == "fsync" or inside in str(given[0]) or given[-1] != -1):
            return
        count += 1
        if count == point:
            os.kill(os.getpid(), signal.SIGKILL)

    def synced(handle: int) -> None:
        meet("fsync", ())
        sync(handle)

    os.fsync = synced
    sys.addaudithook(meet)
    code = 1
    try:
        work()
        code = 0
    finally:
        os._exit(code)


def content(found: object) -> dict[str, np.ndarray]:
    """Arrays of a result by name."""
    groups = {"motion": getattr(found, "motion", None), "envelope": getattr(found, "envelope", None)}
    groups |= {f"forces {case}": one for case, one in (getattr(found, "forces", None) or {}).items()}
    arrays = {}
    for group, record in groups.items():
        for name, values in getattr(record, "data", {}).items():
            arrays[f"{group}.{name}"] = values.values
    return arrays


def differing(whole: dict[str, np.ndarray], found: dict[str, np.ndarray], *, part: bool = False) -> list[str]:
    """Names of arrays that differ; `part`: of the samples that are there."""
    bad = [] if part else sorted(set(whole) ^ set(found))
    for name in set(whole) & set(found):
        a, b = whole[name], found[name]
        a = a[: len(b)] if part and a.ndim else a
        close = np.allclose(a, b, rtol=1e-9, atol=1e-9, equal_nan=True) if a.dtype.kind == "f" and a.shape == b.shape else True
        if a.shape != b.shape or not close:
            bad.append(name)
    return bad


def start(model: kt.Model, out: Path, given: dict[str, object], *, overwrite: bool = False) -> object:
    """Do the run of a writer."""
    if "settings" in given:
        return kt.runs.run_variants(model, given["settings"], out=out, overwrite=overwrite)
    return kt.run(model, given.get("name"), out, block=given.get("block"), overwrite=overwrite)


def lead_on(model: kt.Model, out: Path, given: dict[str, object]) -> str:
    """Come to the whole run by the first way that is not refused."""
    refusals = []
    ways = {
        "resume": lambda: kt.runs.resume(out),
        "run": lambda: start(model, out, given),
        "overwrite": lambda: start(model, out, given, overwrite=True),
    }
    for name, way in ways.items():
        try:
            way()
        except kt.KinetrussError as error:
            refusals.append(f"{name}: {error}")
            continue
        return name
    return f"no way leads on: {'; '.join(refusals)}"


def trouble(model: kt.Model, given: dict[str, object], point: int, *, again: bool) -> tuple[bool, str, str]:
    """Kill at one operation, `again` while a run is overwritten: was it killed, the way on, what is wrong."""
    with tempfile.TemporaryDirectory() as folder:
        out, whole = Path(folder) / "out", given["whole"]
        folders = sorted(path.parent.relative_to(whole) for path in whole.rglob("kinetruss.json"))
        right = {one: content(kt.runs.load(whole / one)) for one in folders}
        if again:
            start(model, out, given)
        if not killed(lambda: start(model, out, given, overwrite=again), out, point):
            return False, "", ""
        for one in folders:
            try:
                half = kt.runs.load(out / one)
            except kt.KinetrussError:
                continue
            if bad := differing(right[one], content(half), part=getattr(half, "state", "finished") != "finished"):
                return True, "", f"half read: {bad}"
        way = lead_on(model, out, given)
        if way.startswith("no way"):
            return True, way, way
        for one in folders:
            if bad := differing(right[one], content(kt.runs.load(out / one))):
                return True, way, f"after {way}: {bad}"
        left = [str(path.relative_to(out)) for path in out.rglob("*.part*")]
        return True, way, f"left over: {left}" if left and way == "overwrite" else ""


def main() -> int:
    """The campaign."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", default="")
    parser.add_argument("--every", type=int, default=1)
    given = parser.parse_args()
    bad = 0
    for name, model, arguments in writers():
        if given.only not in name:
            continue
        whole = Path(tempfile.mkdtemp()) / "whole"
        start(model, whole, arguments)
        arguments |= {"whole": whole}
        for again in (False, True):
            ways: dict[str, int] = {}
            point, more = 1, True
            while more:
                more, way, wrong = trouble(model, arguments, point, again=again)
                if more:
                    ways[way] = ways.get(way, 0) + 1
                if wrong:
                    bad += 1
                    print(f"{name}{' again' if again else ''}, operation {point}: {wrong}", flush=True)
                point += given.every
            print(f"{name}{' again' if again else ''}: {sum(ways.values())} kills, {ways}", flush=True)
    return bool(bad)


if __name__ == "__main__":
    sys.exit(main())
