"""Models that lack nearly everything, in the plane and in space: every analysis and every output works or refuses in words.

    python tests/campaigns/degenerate.py --work build/degenerate [--only beams]

A line of the output is a fault: what was done, and the error that no user should meet. Exit 1 if there is one.
"""

from __future__ import annotations

import argparse
import sys
import traceback
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import kinetruss as kt

ROD = {"section": kt.Rod(diameter=0.02), "material": "steel_s235"}
PART = kt.Part(length=0.7, section=kt.Tube(outer=0.02, inner=0.016), material="steel_s235")
MOTOR = kt.Motor(inertia=1e-5, resistance=1.0, torque_constant=0.1, emf_constant=0.1, max_voltage=20.0)
TRAIN = {"screw": kt.LeadScrew(lead=0.001, mean_diameter=0.02, friction=0.1), "gear": kt.Gear(ratio=5.0), "motor": MOTOR}


def models() -> Iterator[tuple[str, kt.Model]]:
    """The models by name."""
    for dim in (2, 3):
        for name, model in {**_trusses(dim), **_bars(dim)}.items():
            yield f"{name} {dim}", model
    yield "planar body 2", kt.Model(
        nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], gravity=(0, -9.81),
        bars={"a": kt.Bar(ends=("A", "B"), body=kt.PlanarBody(mass=1.0, center=(0.5, 0.1), inertia=0.1))},
    )  # fmt: skip
    corners = {"A": (0, 0, 0), "B": (1, 0, 0), "C": (0, 1, 0), "D": (0, 0, 1)}
    body = kt.Body(nodes=tuple(corners), mass=2.0, center=(0.2,) * 3, inertia=[[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    yield "body 3", kt.Model(nodes=corners, fixed=["A"], bodies={"k": body}, gravity=(0, 0, -9.81))


def _place(x: float, y: float, dim: int) -> tuple[float, ...]:
    return (x, y) if dim == 2 else (x, 0.0, y)


def _trusses(dim: int) -> dict[str, kt.Model]:
    """A truss of one free node: without drives, and without more and more of the rest."""
    nodes: dict[str, Any] = {"A": _place(0, 0, dim), "B": _place(1, 0, dim), "C": _place(0.3, 1, dim)}
    bars: dict[str, Any] = {"a": ("A", "C"), "b": ("B", "C")}
    if dim == 3:
        nodes["D"], bars["c"] = (0.4, 1.0, 0.0), ("D", "C")
    held = [name for name in nodes if name != "C"]
    down = _place(0, -9.81, dim)
    elastic = {name: kt.Bar(ends=ends, kind="elastic", stiffness=1e5, mass=1.0) for name, ends in bars.items()}
    massless = {name: kt.Bar(ends=ends, mass=0) for name, ends in bars.items()}
    heavy = {**nodes, "C": kt.Node(at=nodes["C"], mass=2.0)}
    return {
        "no drives": kt.Model(nodes=nodes, fixed=held, bars=bars, gravity=down, **ROD),
        "no loads": kt.Model(nodes=nodes, fixed=held, bars=bars, **ROD),
        "no sections": kt.Model(nodes=nodes, fixed=held, bars=bars, gravity=down),
        "no mass": kt.Model(nodes=heavy, fixed=held, bars=massless, gravity=down),
        "all fixed": kt.Model(nodes=nodes, fixed=list(nodes), bars=bars, gravity=down, **ROD),
        "elastic": kt.Model(nodes=nodes, fixed=held, bars=elastic, gravity=down),
    }


def _bars(dim: int) -> dict[str, kt.Model]:
    """One bar or beam, or none."""
    down, ends = _place(0, -9.81, dim), {"A": _place(0, 0, dim), "B": _place(1, 0, dim)}
    point, bar = {"A": kt.Node(at=_place(0, 0, dim), mass=1.0)}, {"a": ("A", "B")}
    slide = {"A": "xyz"[:dim], "B": "xyz"[1:dim]}
    active = kt.Active(ends=("A", "B"), base=PART, tube=PART, **TRAIN)
    found = {
        "no bars": kt.Model(nodes=point, gravity=down),
        "no bars, fixed": kt.Model(nodes=point, fixed=["A"], gravity=down),
        "one bar": kt.Model(nodes=ends, fixed=["A"], bars=bar, gravity=down, **ROD),
        "one bar, free": kt.Model(nodes=ends, bars=bar, **ROD),
        "one bar, fixed": kt.Model(nodes=ends, fixed=["A", "B"], bars=bar, gravity=down, **ROD),
        "one length": kt.Model(nodes=ends, fixed=slide, bars=bar, drives={"m": kt.LengthDrive("a")}, gravity=down, **ROD),
        "one active": kt.Model(nodes=ends, fixed=slide, active={"a": active}, gravity=down, **ROD),
        "only beams": kt.Model(nodes=ends, clamped=["A"], beams={"a": kt.Beam(ends=("A", "B"))}, gravity=down, **ROD),
    }
    if dim == 2:
        found["one angle"] = kt.Model(nodes=ends, fixed=["A"], bars=bar, drives={"m": kt.AngleDrive("a")}, **ROD)
    return found


class Walk:
    """What is done with a model; faults hold what ended in anything but a result or an error of the package."""

    def __init__(self, name: str, work: Path) -> None:
        self.name, self.work, self.faults = name, work, list[str]()

    def tried(self, what: str, function: Callable[[], Any]) -> Any:
        """The result of a function, or None."""
        with warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            try:
                return function()
            except kt.KinetrussError:
                return None
            except Exception as error:  # noqa: BLE001 (whatever it is, it is what is looked for)
                last = traceback.extract_tb(error.__traceback__)[-1]
                where = f"{Path(last.filename).name}:{last.lineno}"
                self.faults.append(f"{self.name}: {what}: {type(error).__name__}: {str(error)[:120]} ({where})")
                return None

    def model(self, model: kt.Model) -> None:
        """The verbs that need no run."""
        node, bar = list(model.nodes)[-1], next(iter(model.members), "a")
        verbs: dict[str, Callable[[], Any]] = {
            "check": lambda: kt.check(model),
            "mobility": lambda: str(kt.kinematics.mobility(model)),
            "scene": lambda: kt.viewer.pack(kt.viewer.scene(model)),
            "picture": lambda: kt.report.picture(model, self.work / "model.svg"),
            "forces_at_rest": lambda: kt.runs.forces_at_rest(model).to_dataframe(),
            "linearise": lambda: kt.dynamics.linearise(model).to_dataframe(),
            "reduced_equations": lambda: kt.dynamics.reduced_equations(model),
            "transfer_functions": lambda: kt.kinematics.transfer_functions(model),
            "linear": lambda: kt.statics.linear(model).to_dataframe(),
            "equilibrium": lambda: kt.statics.equilibrium(model).to_dataframe(),
            "buckling": lambda: kt.statics.buckling(model, "none"),
            "assembly_modes": lambda: kt.kinematics.assembly_modes(model),
            "task": lambda: kt.kinematics.inverse(model, kt.Positioning(node=node, moves={"x": 0.01}), samples=3),
            "workspace": lambda: kt.kinematics.workspace(model, node, ("x", [0.0, 0.1]), ("y", [0.0, 0.1])),
            "budget": lambda: kt.runs.budget(model, f"{node}.x", {bar: 1e-4}).to_dataframe(),
            "size": lambda: kt.design.table(kt.design.size(model, kt.Mission())),
            "write": lambda: kt.io.read(kt.io.write(model, self.work / "model.yaml")),
        }
        for suffix in ("dxf", "stl", "xml", "urdf", "vtu"):
            verbs[suffix] = lambda suffix=suffix: kt.exchange.write(model, self.work / f"m.{suffix}", overwrite=True)
        for what, function in verbs.items():
            self.tried(what, function)

    def runs(self, model: kt.Model) -> Iterator[tuple[str, Any]]:
        """A run of every kind, as far as the model can have it."""
        road = kt.ConstantRate(rates=dict.fromkeys(model.all_drives, 0.01), duration=1.0) if model.all_drives else None
        way = {"trajectory": road, "samples": 3}
        free = dict.fromkeys(model.all_drives, kt.Free())
        pose = {"trajectory": road, "samples": 2} if road else {"poses": {"here": {}}}
        elastic = {"at": [f"{list(model.nodes)[-1]}.x"]}
        kinds: dict[str, Callable[[], kt.Run]] = {
            "statics.at_poses": lambda: kt.Run(analysis="statics.at_poses", **pose),
            "mission": lambda: kt.Run(analysis="mission", motions=["statics.at_poses"]),
            "dynamics.inverse": lambda: kt.Run(**way),
            "kinematics.follow": lambda: kt.Run(analysis="kinematics.follow", **way),
            "dynamics.simulate": lambda: kt.Run(analysis="dynamics.simulate", t_end=0.01, samples=3, tasks=free),
            "statics.linear": lambda: kt.Run(analysis="statics.linear"),
            "statics.equilibrium": lambda: kt.Run(analysis="statics.equilibrium"),
            "statics.deflection": lambda: kt.Run(analysis="statics.deflection", **way),
            "flexible.frequencies": lambda: kt.Run(analysis="flexible.frequencies", **way),
            "flexible.corrected": lambda: kt.Run(analysis="flexible.corrected", elastic=elastic, **way),
        }
        known: dict[str, kt.Run] = {}
        for kind, made in kinds.items():
            if (run := self.tried(kind, made)) is None:
                continue
            known[kind] = run
            with_runs = {name: known[name] for name in {"statics.at_poses", kind} if name in known}
            done = self.tried(
                kind, lambda kind=kind, runs=with_runs: kt.run(model.with_(runs=runs), kind, self.work / kind, overwrite=True)
            )
            if done is not None:
                yield kind, done

    def outputs(self, kind: str, run: Any) -> None:
        """What is made of a run."""
        verbs: dict[str, Callable[[], Any]] = {
            "summary": lambda: (kt.report.summary(run).text, kt.report.summary(run).record, kt.report.lines(run)),
            "document": lambda: kt.report.document_page(run).html,
            "curves": lambda: kt.report.curves(run, "member_force"),
            "drive curves": lambda: kt.report.curves(run, "drive_force"),
            "compare": lambda: kt.report.compare([run, run]).text,
            "scene": lambda: kt.viewer.pack(kt.viewer.scene(run)),
            "picture": lambda: kt.report.picture(run, self.work / "run.svg"),
            "plot": lambda: kt.report.plot([run], "member_force", self.work / "plot.svg"),
            "figures": lambda: kt.report.figures(run, self.work / "figures", ("svg",)),
            "joints": lambda: kt.report.joints(run).text,
            "tables": lambda: [one.to_dataframe() for one in (run.motion, *run.forces.values(), *run.sections.values())],
            "more tables": lambda: [one.to_dataframe() for one in (*run.demand.values(), *run.statics.values())],
            "gauges": lambda: kt.runs.gauge_strains(run.model, kind),
        }
        for suffix in ("csv", "nc", "parquet"):
            verbs[suffix] = lambda suffix=suffix: kt.io.export(run.path, self.work / f"run.{suffix}")
        for suffix in ("pvd", "vtu", "dxf"):
            verbs[suffix] = lambda suffix=suffix: kt.exchange.write(run, self.work / f"r.{suffix}", overwrite=True)
        for what, function in verbs.items():
            self.tried(f"{kind}, {what}", function)


def walked(name: str, model: kt.Model, work: Path, shown: tuple[str, ...] = ()) -> list[str]:
    """The faults of all analyses of a model, and of all outputs of its runs; shown : analyses, by default all."""
    work.mkdir(parents=True, exist_ok=True)
    walk = Walk(name, work)
    walk.model(model)
    for kind, run in walk.runs(model):
        if kind in shown or not shown:
            walk.outputs(kind, run)
    return walk.faults


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, required=True, help="folder to work in")
    parser.add_argument("--only", default="", help="models whose name contains this")
    options = parser.parse_args()
    count = 0
    for name, model in models():
        if options.only in name:
            print(name, file=sys.stderr, flush=True)
            for fault in walked(name, model, options.work / name.replace(" ", "_")):
                count += 1
                print(fault, flush=True)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
