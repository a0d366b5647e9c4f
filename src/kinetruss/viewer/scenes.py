"""Makes a scene from a model, a motion, forces or a run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss import __version__
from kinetruss.display import limits_of
from kinetruss.elements.continua_arrays import skin_of
from kinetruss.errors import AnalysisError, InputError
from kinetruss.kinematics.own_motion import check_motion
from kinetruss.mechanics import compile
from kinetruss.model import Model, nearest
from kinetruss.model.links import piece_at
from kinetruss.results import Forces, Motion, Result, Simulation, Status
from kinetruss.results.records import check_samples
from kinetruss.results.wide_tables import NOT_CHECKED
from kinetruss.runs import RunResult
from kinetruss.runs.mission_results import check_histories
from kinetruss.strength import check
from kinetruss.strength.element_stresses import skin_stress
from kinetruss.viewer.moving import (
    CHANNELS,
    FORMAT,
    UNITS,
    VERSION,
    Mode,
    Scene,
    actions_at_rest,
    channels_of,
    load_times,
    loads_of,
    mechanisms,
    moving,
    scalars_placed,
    sections_of_beams,
    shown_over,
    stress_of_faces,
    vibrations,
)
from kinetruss.viewer.topology import FRAME, shown_kinds, topology

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.strength.findings import Finding


AT_REST = "Not checked: an equilibrium has no verdict. A run has one, or the forces of statics.at_poses"


@dataclass(frozen=True, kw_only=True)
class _Subject:
    """The data of a scene, from any source."""

    model: Model
    kind: str
    name: str = ""
    motion: Motion | None = None
    forces: Sequence[Forces] = ()
    run: RunResult | None = None
    linear: Result | None = None
    rest: Result | None = None


def scene(
    what: Model | Result | RunResult,
    *,
    model: Model | None = None,
    case: str | None = None,
    frames: int = 600,
    modes: Sequence[Mode] = (),
    instants: Sequence[float] = (),
) -> Scene:
    """The scene of a model, a motion, forces, a simulation, an equilibrium, a linearisation or a run.

    Parameters
    ----------
    model : required except for a model or a run, which have their own.
    case : the only load case of a run to show; by default all, selectable in the page.
    frames : largest number of samples, equally spaced, in addition to the worst of each member. All states shown are computed
    samples, never interpolated.
    instants : times, s, whose nearest samples are kept in any case.
    modes : shapes to animate; the mechanisms of a model and the modes of a linearisation are included without it.

    Raises
    ------
    InputError : a result without its model, an unknown load case, a run without a good sample.

    Notes
    -----
    Up to 600,000 numbers are kept as float32, of as many load cases as fit. In a larger scene each curve is rounded to
    1/65534 (positions, member forces) or 1/4094 of its range, only one load case is kept, the page computes joint forces from
    accelerations, and stress, utilisation and buckling are the worst of the run; ``rounded`` in the header is then true.

    Examples
    --------
    >>> import kinetruss as kt
    >>> scene = kt.viewer.scene(kt.library.vgt.triangular())
    >>> scene.header["kind"], scene.header["dim"], scene.header["nodes"]
    ('model', 2, ['O1', 'O2', 'B'])
    """
    subject = _subject(what, model, case)
    header, arrays = topology(subject.model)
    header |= {
        "format": FORMAT, "version": VERSION, "kinetruss": __version__, "kind": subject.kind, "name": subject.name,
        "title": subject.model.title, "dim": subject.model.dim, "status": Status.COMPLETED.value, "message": "",
        "gravity": list(subject.model.gravity or (0.0,) * subject.model.dim), "rounded": False, "loads": [], "channels": [],
        "shows": [], "samples": {"all": 1, "shown": 1}, "cases": [], "not_checked": {}, "not_unique": [],
    }  # fmt: skip
    shown = list(modes)
    finding = _finding(subject)
    header["verdict"] = finding.record | ({"text": AT_REST} if subject.rest is not None else {})
    header["verdict"]["more"] += finding.doubts
    if finding.governing is not None and (governing := header["verdict"]["governing"])["member"] in subject.model.links:
        governing["member"] = piece_at(subject.model, governing["member"], finding.governing.position)
    header["not_checked"] = _not_checked(finding)
    if subject.motion is None:
        more, histories = _standing(subject)
        if subject.linear is not None:
            shown = vibrations(subject.linear) + shown
        elif subject.rest is None:
            shown = mechanisms(subject.model) + shown
    else:
        if finding.governing is not None and np.isfinite(finding.governing.time):
            instants = (*instants, finding.governing.time)
        more, histories = moving(subject.model, subject.motion, subject.forces, subject.run, frames, instants)
    header |= more
    fixed = ("time", *header.get("over_run", ()))
    header["histories"] = [name for name in histories if name.split(":")[-1] in UNITS and name not in fixed]
    header["units"] = {name: UNITS[name] for name in histories if name in UNITS}
    header["modes"] = [{"name": one.name, "frequency": one.frequency, "array": f"mode_{k}"} for k, one in enumerate(shown)]
    shapes = {f"mode_{k}": np.asarray(one.shape, float) for k, one in enumerate(shown)}
    return Scene(header=header, arrays=arrays | histories | shapes)


def snapshots(
    what: Model | Result | RunResult,
    *,
    model: Model | None = None,
    case: str | None = None,
    samples: Sequence[int] = (0,),
    colour: str | None = None,
) -> Scene:
    """The scene of a few samples, for drawings on paper; of a run only what they need is computed.

    Parameters
    ----------
    samples : of the motion, in any order; they are the samples of the scene. case : load case, by default the first.
    colour : the channel that members have, ``force``, ``stress`` or ``utilisation``.

    Returns
    -------
    A scene whose header has, of the whole motion, ``times``, ``largest_load`` (N), the diagonal of the room that the
    structure needs, ``extent`` (m), and in its channel ``limits`` of the colour scale, ``largest`` and ``gaps``, true if
    values are not known.

    Raises
    ------
    InputError : as of `scene`; a colour where there are no such values.
    """
    subject = _subject(what, model, case)
    model = subject.model
    header, arrays = topology(model)
    if subject.motion is None:
        more, found = _standing(subject)
    else:
        check_samples(subject.motion)
        data = subject.motion.whole
        found = {name: data[name].values for name in ("time", "position")}
        found["position"] = scalars_placed(model, found["position"])
        when, loading = found["time"], None
        if subject.forces:
            when, loading = load_times(subject.forces[0], when), subject.forces[0].load_case
        loading = loading if loading in model.cases else None
        loads, found["load_force"] = loads_of(model, when, loading, data["position"].values)
        more = {"loads": loads}
        if subject.forces:  # a load case may have its own
            more["gravity"] = [float(g) for g in subject.forces[0].data.attrs["gravity"]]
    if (colour is not None or case is not None) and not subject.forces and subject.rest is None:
        raise InputError("There are no forces to colour by. Give a run, forces or an equilibrium.")
    if case is not None and all(one.load_case != case for one in subject.forces):
        raise InputError(f"No load case called {case!r}. {nearest(case, [one.load_case for one in subject.forces])}")
    force = np.linalg.norm(found["load_force"], axis=2)
    header |= {"dim": model.dim, "title": model.title, "gravity": list(model.gravity or (0.0,) * model.dim)}
    header |= more | {
        "times": found["time"].tolist(),
        "largest_load": float(force.max(initial=0.0)),
        "extent": float(np.linalg.norm(np.ptp(found["position"].reshape(-1, model.dim), axis=0))),
        "not_unique": sorted({str(name) for one in subject.forces for name in one.data.attrs.get("not_unique", [])}),
        "channels": [],
    }
    kept = {name: found[name][list(samples)] for name in ("time", "position", "load_force")}
    if colour is not None:
        channel, coloured = _coloured(subject, found, colour)
        header["channels"] = [channel]
        kept |= {name: values[list(samples)] for name, values in coloured.items()}
    return Scene(header=header, arrays=arrays | kept)


def _coloured(subject: _Subject, found: dict[str, Any], colour: str) -> tuple[dict[str, Any], dict[str, NDArray[np.float64]]]:
    """The header fields of a channel and its arrays over all samples."""
    from kinetruss.strength.beam_verdict import middle_forces
    from kinetruss.strength.verdict import strength_histories

    model, known = subject.model, ("force", "stress", "utilisation")
    if colour not in known:
        raise InputError(f"No colour called {colour!r}. {nearest(colour, known)}")
    channel = CHANNELS[colour]
    if subject.rest is not None:
        if colour != "force":
            raise InputError(f"There is no {colour} of a state at rest. Colour it by force.")
        values = {"member_force": found["member_force"]}
    elif colour == "force":
        values = {"member_force": middle_forces(model, subject.forces[0])}
    else:
        # of the stress of faces all that there is
        faces = {"skin_stress": skin_stress(model, skin_of(model.whole), found["position"])} if colour == "stress" else {}
        values = {name: one for name, one in faces.items() if one is not None}
        members = strength_histories(model, subject.forces[0]).get(colour)
        if members is None and not values:
            raise InputError(f"There is no {colour}: it needs a section and a material. Add them to the model.")
        unknown = np.full((len(found["time"]), len(model.whole.members)), np.nan)
        values[channel["array"]] = unknown if members is None else members
    drawn = [kind != FRAME for kind in shown_kinds(model.whole)]
    own = values[channel["array"]][:, drawn]
    all_values = np.concatenate([own.ravel(), values.get("skin_stress", np.zeros(0)).ravel()])
    more = {
        "limits": list(limits_of(channel["scale"], all_values)),
        "largest": float(np.nanmax(own, initial=0.0)),
        "gaps": bool(np.isnan(own).any()),
    }
    return {"id": colour, **channel, **more}, values


def _subject(what: Any, model: Model | None, case: str | None) -> _Subject:
    if isinstance(what, Model):
        return _Subject(model=what, kind="model")
    if isinstance(what, RunResult):
        check_histories(what)
        if case is not None and case not in what.forces:
            raise InputError(f"No load case called {case!r}. {nearest(case, what.forces)}")
        forces = list(what.forces.values()) if case is None else [what.forces[case]]
        return _Subject(model=what.model, kind="run", name=what.name, motion=what.motion, forces=forces, run=what)
    if isinstance(what, Simulation):
        what = what.forces
    linear = isinstance(what, Result) and {"mode_shape", "frequency"} <= set(what.data)
    rest = isinstance(what, Result) and {"position", "member_force"} <= set(what.data) and what.data["position"].ndim == 2
    if not linear and not rest and not isinstance(what, (Motion, Forces)):
        raise InputError(f"A {type(what).__name__} cannot be drawn. Give a model, a motion, forces, an equilibrium or a run.")
    if model is None:
        raise InputError(f"A {type(what).__name__} alone has no bars. Give its model too: model=...")
    if linear:
        return _Subject(model=model, kind="vibration modes", linear=what)
    if rest:
        return _Subject(model=model, kind="equilibrium", rest=what)
    check_motion(compile(model), what.motion if isinstance(what, Forces) else what, members=True)
    if isinstance(what, Forces):
        return _Subject(model=model, kind="forces", motion=what.motion, forces=[what])
    return _Subject(model=model, kind="motion", motion=what)


def _finding(subject: _Subject) -> Finding:
    """What governs, of the load cases shown: from the run, or checked here."""
    from kinetruss.strength.findings import demands, find

    run = subject.run
    if run is not None and (run.verdict is not None or not run.forces) and len(subject.forces) in (0, len(run.forces)):
        return run.finding
    if not subject.forces:
        return find(None)
    verdict = check(subject.model, subject.forces)
    if run is None:
        return find(verdict, timed=subject.motion is not None and subject.motion.whole.sizes["time"] > 1)
    names = {one.load_case for one in subject.forces}
    demand = demands({name: one for name, one in run.demand.items() if name in names})
    measured = run.finding.quantities
    return find(verdict, demand, partial=run.partial, doubts=run.doubts, timed=run.timed, quantities=measured)


def _not_checked(finding: Finding) -> dict[str, str]:
    """Member -> its rules that were not checked and why, in words."""
    found: dict[str, list[str]] = {}
    for row in finding.members:
        if row.status == "not checked":
            of = "" if row.part == row.member else f" of {row.part}"
            found.setdefault(row.member, []).append(f"{row.rule}{of}: {row.note.removeprefix(NOT_CHECKED)}")
    return {member: "; ".join(words) for member, words in found.items()}


def _standing(subject: _Subject) -> tuple[dict[str, Any], dict[str, NDArray[Any]]]:
    """A model in its own pose, or the state of a linearisation: one frame with its loads at the start."""
    from kinetruss.kinematics import assemble
    from kinetruss.strength.beam_verdict import middle_forces

    model = subject.model
    more: dict[str, Any] = {}
    known = subject.linear or subject.rest
    try:
        position = assemble(model) if known is None else known.whole["position"].values
    except (AnalysisError, InputError) as error:
        position = np.array([node.at for node in model.whole.nodes.values()], float)
        more = {"message": f"Shown as drawn, not assembled: {error}"}
    if subject.linear is not None and subject.linear.message:
        more = {"message": subject.linear.message}
    when, case = np.zeros(1), None
    if subject.rest is not None:
        when, case = load_times(subject.rest, when), subject.rest.provenance.get("load_case")
        own = model.cases[case].gravity if case in model.cases else None
        more |= {} if own is None else {"gravity": [float(g) for g in own]}
    loads, force = loads_of(model, when, case if case in model.cases else None, position[None])
    found = {"time": np.zeros(1), "position": scalars_placed(model, position[None]), "load_force": force}
    if subject.rest is not None:
        still = np.zeros_like(found["position"])
        found |= {"member_force": middle_forces(model, subject.rest)[None], "velocity": still, "acceleration": still}
        found |= sections_of_beams(model, subject.rest, at_rest=True)
        more["shows"] = shown_over(model, found, rounded=False)
        found |= stress_of_faces(model, found["position"])
        more["actions"], acting = actions_at_rest(model, subject.rest)
        found |= acting
        more["channels"] = [one for one in channels_of(found, bool(model.whole.members)) if one["id"] != "speed"]
    return more | {"loads": loads}, found
