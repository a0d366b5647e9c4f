"""From a model, a motion, forces or a run to a scene."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import __version__
from kinetruss.errors import AnalysisError, InputError
from kinetruss.model import Model, nearest
from kinetruss.results import Forces, Motion, Result, Simulation, Status
from kinetruss.runs import RunResult
from kinetruss.viewer._channels import CHANNELS, strength_histories, worst_of
from kinetruss.viewer._modes import mechanisms, vibrations
from kinetruss.viewer._record import FORMAT, VERSION, Mode, Scene
from kinetruss.viewer._topology import topology

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["scene"]

EXACT = 600_000
"""Numbers over time up to which a scene keeps all of them as float32; beyond it curves are rounded."""

UNITS = {
    "time": "s", "position": "m", "velocity": "m/s", "acceleration": "m/s^2", "member_force": "N", "joint_force": "N",
    "reaction": "N", "drive_force": "N or N m", "drive_position": "m or rad", "load_force": "N", "stress": "Pa",
    "utilisation": "", "buckling": "", "energy": "J",
}  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class _Subject:
    """What is shown, whatever it came from."""

    model: Model
    kind: str
    name: str = ""
    motion: Motion | None = None
    forces: Forces | None = None
    run: RunResult | None = None
    linear: Result | None = None


def scene(
    what: Model | Result | RunResult,
    *,
    model: Model | None = None,
    case: str | None = None,
    frames: int = 600,
    modes: Sequence[Mode] = (),
) -> Scene:
    """Everything a viewer shows of a model, a motion, forces, a simulation, a linearisation or a run.

    Parameters
    ----------
    model : of what is neither a model nor a run; those have theirs.
    case : load case of a run; by default its first.
    frames : samples kept at most, equally spaced, and those where a member is worst besides. What is shown is always a
        sample that was computed, never a state between two.
    modes : shapes to be shown swinging; the mechanisms of a model and the modes of a linearisation come by themselves.

    Raises
    ------
    InputError : a result without its model, a load case that is not there, a run without a good sample.

    Notes
    -----
    Up to `EXACT` numbers are kept as float32. In a larger scene each curve is rounded to 1/65534 (positions, member forces)
    or 1/4094 of its range, joint forces are left to be formed from accelerations, and stress, utilisation and buckling are
    the worst of the run; ``rounded`` in the header says so.
    """
    subject = _subject(what, model, case)
    header, arrays = topology(subject.model)
    header |= {
        "format": FORMAT, "version": VERSION, "kinetruss": __version__, "kind": subject.kind, "name": subject.name,
        "title": subject.model.title, "dim": subject.model.dim, "status": Status.COMPLETED.value, "message": "",
        "gravity": list(subject.model.gravity or (0.0,) * subject.model.dim), "rounded": False, "loads": [], "channels": [],
        "samples": {"all": 1, "shown": 1}, "buckling_safety": subject.model.safety.buckling,
    }  # fmt: skip
    shown = list(modes)
    if subject.motion is None:
        more, histories = _standing(subject)
        own = mechanisms(subject.model) if subject.linear is None else vibrations(subject.linear)
        shown = own + shown
    else:
        more, histories = _moving(subject, subject.motion, frames)
    header |= more
    fixed = ("time", *header.get("over_run", ()))
    header["histories"] = [name for name in histories if name in UNITS and name not in fixed]
    header["units"] = {name: UNITS[name] for name in histories if name in UNITS}
    header["modes"] = [{"name": one.name, "frequency": one.frequency, "array": f"mode_{k}"} for k, one in enumerate(shown)]
    shapes = {f"mode_{k}": np.asarray(one.shape, float) for k, one in enumerate(shown)}
    return Scene(header=header, arrays=arrays | histories | shapes)


def _subject(what: Any, model: Model | None, case: str | None) -> _Subject:
    if isinstance(what, Model):
        return _Subject(model=what, kind="model")
    if isinstance(what, RunResult):
        if not what.good:
            raise InputError(f"{what.path or what.name} has no good sample to show.")
        if case is not None and case not in what.forces:
            raise InputError(f"No load case called {case!r}. {nearest(case, what.forces)}")
        chosen = case or next(iter(what.forces), None)
        forces = None if chosen is None else what.forces[chosen]
        return _Subject(model=what.model, kind="run", name=what.name, motion=what.motion, forces=forces, run=what)
    if isinstance(what, Simulation):
        what = what.forces
    linear = isinstance(what, Result) and "mode_shape" in what.data
    if not linear and not isinstance(what, (Motion, Forces)):
        raise InputError(f"A {type(what).__name__} cannot be shown. Give a model, a motion, forces or a run.")
    if model is None:
        raise InputError(f"A {type(what).__name__} alone has no bars. Give its model too: model=...")
    if linear:
        return _Subject(model=model, kind="vibration modes", linear=what)
    if isinstance(what, Forces):
        return _Subject(model=model, kind="forces", motion=what.motion, forces=what)
    return _Subject(model=model, kind="motion", motion=what)


def _standing(subject: _Subject) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """A model as it stands, or the state of a linearisation: one frame with its loads at the start."""
    from kinetruss.kinematics import assemble

    model = subject.model
    more: dict[str, Any] = {}
    try:
        position = assemble(model) if subject.linear is None else subject.linear.data["position"].values
    except (AnalysisError, InputError) as error:
        position = np.array([node.at for node in model.nodes.values()], float)
        more = {"message": f"Shown as drawn, not assembled: {error}"}
    loads, force = _loads(model, np.zeros(1), None)
    return more | {"loads": loads}, {"time": np.zeros(1), "position": position[None], "load_force": force}


def _moving(subject: _Subject, motion: Motion, most: int) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    model, forces, run = subject.model, subject.forces, subject.run
    count = int(motion.data.sizes["time"])
    keep = _kept(count, most, motion.data["time"].values, run)
    if len(keep) < count:
        motion = motion.with_(data=motion.data.isel(time=keep))
        forces = None if forces is None else forces.with_(data=forces.data.isel(time=keep), motion=motion)
    time = motion.data["time"].values
    found = {"time": time} | {name: motion.data[name].values for name in ("position", "velocity", "acceleration")}
    numbers = 3 * found["position"].size + (0 if forces is None else len(time) * len(model.members) * (4 + 2 * model.dim))
    rounded = numbers > EXACT
    more: dict[str, Any] = {
        "rounded": rounded, "samples": {"all": count, "shown": len(time)}, "status": motion.status.value,
        "message": motion.message, "channels": [{"id": "speed", **CHANNELS["speed"], "over_run": False}],
    }  # fmt: skip
    if forces is not None:
        told, arrays = _forces(subject, forces, rounded)
        channels = [{"id": name, **CHANNELS[name], "over_run": name in told["over_run"]} for name in CHANNELS
                    if name == "speed" or CHANNELS[name]["array"] in arrays]  # fmt: skip
        more |= told | {"channels": channels}
        found |= arrays
    elif "drive_position" in motion.data:
        found["drive_position"] = motion.data["drive_position"].values
    return more, found


def _forces(subject: _Subject, forces: Forces, rounded: bool) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    model, run, data = subject.model, subject.run, forces.data
    case = forces.load_case if forces.load_case in model.load_cases else None
    loads, load_force = _loads(model, data["time"].values, case)
    found = {name: data[name].values for name in ("member_force", "reaction", "drive_force", "energy") if name in data}
    found["load_force"] = load_force
    if "drive_position" in forces.motion.data:
        found["drive_position"] = forces.motion.data["drive_position"].values
    over_run: list[str] = []
    if not rounded:
        found["joint_force"] = data["joint_force"].values
        found |= strength_histories(model, forces)
    elif run is not None and run.verdict is not None:
        worst = worst_of(model, run.verdict)
        found |= worst
        over_run = list(worst)
    told = {
        "load_case": forces.load_case, "loads": loads, "gravity": [float(g) for g in data.attrs["gravity"]],
        "supported": [str(name) for name in data["support"].values], "over_run": over_run,
        "not_unique": [str(name) for name in data.attrs.get("not_unique", [])],
    }  # fmt: skip
    return told, found


def _loads(model: Model, time: NDArray[Any], case: str | None) -> tuple[list[dict[str, Any]], NDArray[np.float64]]:
    """Nodal forces of a load case: where, and (times, loads, dim) N."""
    from kinetruss.dynamics._cases import case_loads
    from kinetruss.system import compile

    loads = case_loads(compile(model), time, case)
    where = [{"name": name, "node": int(node)} for name, node in zip(loads.loads, loads.node, strict=True)]
    return where, loads.force[:, :, : model.dim]


def _kept(count: int, most: int, time: NDArray[Any], run: RunResult | None) -> NDArray[np.int64]:
    """Indices of the samples to show."""
    if most < 2:
        raise InputError(f"frames={most}: give at least 2.")
    if count <= most:
        return np.arange(count)
    chosen = np.linspace(0, count - 1, most).round().astype(np.int64)
    if run is not None and run.verdict is not None:
        worst = run.verdict.data["time_of"].values
        worst = np.unique(worst[np.isfinite(worst)])
        chosen = np.append(chosen, np.abs(time[:, None] - worst[: most // 4]).argmin(axis=0))
    return np.unique(chosen)
