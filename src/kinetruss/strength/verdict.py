"""The strength check: the highest utilisation by every rule over time, stations and load cases; what was not checked."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from kinetruss.display.ranks import place_of_largest
from kinetruss.errors import InputError
from kinetruss.mechanics import compile
from kinetruss.model import Model
from kinetruss.results import Arrays, Column, Forces, Status, Verdict, provenance, row_text, variable
from kinetruss.results.wide_tables import most_used
from kinetruss.strength.beam_verdict import beam_notes, beam_parts, chords_of
from kinetruss.strength.critical_loads import beyond_euler, missing, notes
from kinetruss.strength.parts import parts_of, twisted_parts
from kinetruss.strength.section_forces import add_to_notes, not_held, screws_not_held, sentences
from kinetruss.strength.utilisations import RULES, Options, axes_of_verdict, subjects, utilised

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.results import Columns, Row


def strength_histories(model: Model, forces: Forces) -> dict[str, NDArray[np.float64]]:
    """Stress (largest von Mises along the member, Pa), utilisation (the largest finite one of all rules: beyond Euler's load
    that of buckling), and compression over allowed.

    Each (times, members), by the rules of `strength.check`; NaN where a rule cannot be applied. A utilisation is NaN, not 0,
    if the checked rules have no demand and another rule was not checked: for instance for a member in tension without yield
    strength.
    """
    data = utilised(model, forces).columns
    return _by_member(model, data, data["value"].values, data["utilisation"].values)


def worst_of(model: Model, verdict: Verdict) -> dict[str, NDArray[np.float64]]:
    """The same for a whole run (members,), from its verdict."""
    data = verdict.arrays
    found = _by_member(model, data, data["value"].values[None], data["utilisation"].values[None])
    return {name: values[0] for name, values in found.items()}


def unchecked(model: Model) -> dict[str, str]:
    """Member -> the rules that were not checked and why, in words; fully checked members are left out.

    >>> import kinetruss as kt
    >>> bar = kt.Bar(ends=("A", "B"), section=kt.Tube(outer=0.02, inner=0.016), material=kt.Material(E=70e9, density=2700))
    >>> unchecked(kt.Model(nodes={"A": (0, 0), "B": (1, 0)}, fixed=["A"], bars={"a": bar}))
    {'a': 'yield: no yield strength'}
    """
    parts = parts_of(model)
    found: dict[str, list[str]] = {}
    for part, member, what in zip(parts.names, parts.members, missing(parts), strict=True):
        if what:
            found.setdefault(member, []).append(f"yield{'' if part == member else ' of ' + part}: no {what}")
    for name in beam_parts(model):
        material = model.material_of(model.beams.get(name) or model.links[name])
        if material is None or material.yield_strength is None:
            for chord in chords_of(model, name):
                found.setdefault(chord, []).append("yield: no yield strength")
    return {member: "; ".join(words) for member, words in found.items()}


def highest(rows: Iterable[Row]) -> float:
    """Highest utilisation of some entries; NaN if none was checked, or only rules without demand."""
    some = list(rows)
    found = most_used(row.utilisation for row in some)
    return math.nan if found == 0 and any(row.status == "not checked" for row in some) else found


def _by_member(
    model: Model, data: Any, value: NDArray[np.float64], used: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """Over (times, members), of values and utilisations over (times, parts, rules)."""
    rules, index = list(data["rule"].values), {name: k for k, name in enumerate(model.whole.members)}
    index |= {name: index[chords_of(model, name)[0]] for name in beam_parts(model)}
    of = np.array([index[str(name)] for name in data["member"].values], np.int64)
    stress, buckling = rules.index("yield"), rules.index("buckling")
    count = len(model.whole.members)
    largest = _largest(np.fmax.reduce(np.where(np.isinf(used), np.nan, used), axis=2), of, count)
    some = np.zeros(count, np.bool_)
    some[[index[name] for name in unchecked(model)]] = True
    largest[some & (largest == 0)] = np.nan
    found = {
        "stress": _largest(value[:, :, stress], of, count),
        "utilisation": largest,
        "buckling": _largest(used[:, :, buckling], of, count),
    }
    for name in model.links:  # all parts of a link show what its worst place has
        chords = [index[one] for one in chords_of(model, name)]
        for values in found.values():
            values[:, chords] = values[:, chords[:1]]
    return {name: values for name, values in found.items() if not np.isnan(values).all()}


def _largest(values: NDArray[np.float64], of: NDArray[np.int64], count: int) -> NDArray[np.float64]:
    """Largest over the parts of each member; NaN only where all are."""
    found = np.full((len(values), count), np.nan)
    for part, member in enumerate(of):
        found[:, member] = np.fmax(found[:, member], values[:, part])
    return found


# The strength check: the highest utilisation by every rule over time, stations and load cases.

WORST = np.dtype(
    [
        *((name, float) for name in ("value", "limit", "utilisation", "time_of", "station", "position")),
        *((name, float) for name in ("score", "factored", "euler")),
        ("johnson", bool),
        ("case", int),
        ("pose", object),
    ]
)
"""One check of a part by a rule at its worst instant. value to position : as of `check`. score : what was compared. factored,
euler : compression of that instant times its safety factor, and Euler's load, N. johnson : True where Johnson's load governs
buckling. case : number of the load case or pair, -1 for none. pose : its name, of poses at rest.
"""

NOTHING = np.array((*(np.nan,) * 6, -1.0, np.nan, np.nan, False, -1, ""), WORST)

_COLUMNS = {
    "value": ("", "demand, in the rule's unit"),
    "limit": ("", "allowed, in the rule's unit"),
    "utilisation": ("", "demand over capacity"),
    "margin": ("", "1/utilisation - 1"),
    "time_of": ("s", "time of the worst"),
    "station": ("", "governing section, fraction of the part's length from its end towards A"),
    "position": ("m", "governing section, distance from end A"),
    "load_case": ("", "governing load case"),
}

BEYOND = 1e100
"""Factor that puts beam-columns beyond Euler's load above all others."""


def check(
    model: Model,
    forces: Forces | Mapping[str, Forces] | Sequence[Forces],
    *,
    stations: int = 13,
    moment_factor: float = 1.0,
    active_section: Literal["weaker", "base", "tube"] = "weaker",
) -> Verdict:
    """The highest utilisation of every part by every rule over time, along the part, and over load cases.

    Parameters
    ----------
    forces : of one load case, of several (their own names count), or a mapping from names to forces. They may belong to
        different motions, or to segments of one motion.
    stations, moment_factor, active_section : see `Options`.

    Returns
    -------
    Verdict, over (part, rule): ``utilisation``, ``margin`` = 1/utilisation - 1, ``value``, ``limit``, ``time_of`` s,
    ``station``, ``position`` m from end A, ``load_case``, ``note``, of poses at rest
    their name ``pose``; coordinates ``member`` and ``unit``. ``.table()`` gives
    rows, worst first; parts without a section, a material or a yield strength are at its end with a note. Where compression
    times its safety factor reaches Euler's load, the ``beam-column`` has no finite value: its utilisation is infinite, `note`
    says why, and ``buckling``, finite and at least 1, comes before it. Braces of a
    body represent the body, so they have no rows.
    Elastic beams follow the bars, see `strength.beams`. ``message``, and ``data.attrs["not_held"]`` as a list,
    name actions that may bend bars but are not in their section forces; ``note`` repeats this for their entries.

    Raises
    ------
    InputError : no forces, forces of another model.

    Notes
    -----
    Rules and formulas: `utilisation`. Along a part the maximum is located between stations; in time, only the samples are
    evaluated. Safety factors are those of the model.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> worst = kt.strength.check(model, forces).table()[0]
    >>> worst.part, worst.rule, round(worst.utilisation, 3)
    ('strut', 'buckling', 0.061)
    """
    options = Options(stations=stations, moment_factor=moment_factor, active_section=active_section)
    compile(model)  # refuses anything but a model
    cases = _cases(forces)
    worst = np.full((len(axes_of_verdict(compile(model)).names["part"]), len(RULES)), NOTHING)
    lost = np.zeros(len(worst), np.bool_)
    for k, (_, one) in enumerate(cases):
        found = utilised(model, one, options).columns
        lost |= np.isnan(found["value"].values[:, :, 0]).any(axis=0)
        if len(found["time"].values):
            poses = one.arrays["pose"].values if "pose" in one.arrays else None
            latest = _worst(found, k, poses, model.safety.buckling)
            new = latest["score"] > worst["score"]
            worst[new] = latest[new]
    worst[lost, 0] = NOTHING  # a stress that is not known in one case has no largest value
    _, _, rod, _ = subjects(parts_of(model))
    untold = twisted_parts(model)
    untold[rod[rod >= 0]] &= np.isnan(worst["value"][: len(rod), 0][rod >= 0])
    under = [one.load_case for _, one in cases]
    data, missing = told(model, worst, _COLUMNS, [name for name, _ in cases], under, untold, active_section)
    bad = next((one for _, one in cases if not one.status.ok), None)
    return Verdict(
        data=Arrays(axes_of_verdict(compile(model)), None, data, {"kind": "verdict", "not_held": missing}).later,
        status=Status.COMPLETED if bad is None else bad.status,
        message=" ".join(["" if bad is None else bad.message, *missing]).strip(),
        provenance=provenance(
            model, load_cases=[name for name, _ in cases], moment_factor=moment_factor, active_section=active_section
        ),
    )


def told(
    model: Model,
    worst: NDArray[np.void],
    columns: Mapping[str, tuple[str, str]],
    labels: Sequence[str],
    under: Sequence[str],
    untold: NDArray[np.bool_],
    active_section: str = "weaker",
) -> tuple[dict[str, Column], list[str]]:
    """The variables of a verdict, and sentences on what it leaves out.

    worst (parts, rules) : of `WORST`. columns : name of a variable -> unit and words. labels : of the cases that the records
    number. under : load cases. untold (parts,) : parts under torsion whose shear stress is not known.
    """
    parts = parts_of(model)
    _, members, rod, whole = subjects(parts)
    bars, buckling, safety = len(rod), list(RULES).index("buckling"), model.safety.buckling
    pushed = worst["value"][:, buckling]
    said = notes(parts, rod, whole, pushed[:bars], worst["johnson"][:bars, buckling], active_section, untold)
    left = not_held(model, under)
    add_to_notes(left, members, worst["utilisation"], said)
    with np.errstate(divide="ignore"):
        margin = 1 / worst["utilisation"] - 1
    known = {
        "margin": margin,
        "pair": np.where(worst["case"] < 0, np.nan, worst["case"]),
        "load_case": np.array([*labels, ""], dtype=object)[worst["case"]].astype(str),  # the last of none
    }
    over = ("part", "rule")
    data = {
        key: variable(over, known[key] if key in known else np.ascontiguousarray(worst[key]), *words)
        for key, words in columns.items()
    }
    if (worst["pose"] != "").any():
        data["pose"] = variable(over, worst["pose"].astype(str), "", "name of the worst pose")
    every = np.concatenate([said, beam_notes(model, worst["value"][bars:, 0], pushed[bars:], worst["value"][bars:, -1])])
    for k in np.flatnonzero(np.isinf(worst["utilisation"][:, -1])).tolist():
        why = beyond_euler(float(worst["factored"][k, -1]), float(worst["euler"][k, -1]), safety)
        every[k, -1] = f"{why}; {every[k, -1]}" if every[k, -1] else why
    data["note"] = variable(over, every.astype(str), "", "formula used, or why it was not checked")
    return data, [*sentences(left), *screws_not_held(model, under)]


def table(verdict: Verdict, rows: int | None = None) -> str:
    """The rows of a verdict as plain text, worst first; `rows` limits how many.

    >>> import kinetruss as kt
    >>> model = kt.Model(
    ...     nodes={"A": (0, 0), "B": (0, 1), "C": (1, 0)}, fixed=["A", "B"], bars={"strut": ("A", "C"), "tie": ("B", "C")},
    ...     loads={"hook": kt.NodalForce(node="C", force=(0, -1000))}, section=kt.Rod(diameter=0.02), material="steel_s235",
    ... )
    >>> forces = kt.runs.forces_at_rest(model)
    >>> head, worst = kt.strength.table(kt.strength.check(model, forces), rows=1).splitlines()
    >>> worst.split()[:4]
    ['strut', 'buckling', '1', 'kN']
    """
    when = "pose" if "pose" in verdict.data else "time"
    columns = ("part", "rule", "value", "limit", "utilisation", "margin", when, "position", "load_case", "note")
    return row_text(verdict.table()[:rows], columns)


def _cases(forces: Forces | Mapping[str, Forces] | Iterable[Forces]) -> list[tuple[str, Forces]]:
    """Names and forces; anything else is refused."""
    if isinstance(forces, Forces):
        return [(forces.load_case, forces)]
    several: Any = forces if isinstance(forces, Iterable) else [forces]
    found = list(several.items() if isinstance(several, Mapping) else ((getattr(one, "load_case", ""), one) for one in several))
    if not all(isinstance(one, Forces) for _, one in found):
        raise InputError(f"A {type(forces).__name__} is not forces. Give the result of dynamics.inverse, or several of them.")
    if not found:
        raise InputError("There are no forces to check. Give the result of dynamics.inverse, or several of them.")
    return found


def _worst(data: Columns, case: int, poses: NDArray[Any] | None, safety: float) -> NDArray[np.void]:
    """The records (parts, rules) of one load case at their worst instants; poses : names of the samples."""
    every = _score(data)
    at = place_of_largest(every, axis=0)
    part, rule = np.ogrid[: at.shape[0], : at.shape[1]]
    found = np.full(at.shape, NOTHING)
    found["score"], found["case"] = every[at, part, rule], case
    for key in ("value", "limit", "utilisation", "position", "station"):
        found[key] = data[key].values[at, part, rule]
    found["factored"] = safety * data["value"].values[at, part, list(RULES).index("buckling")]
    found["euler"], found["johnson"] = data["euler"].values[at, part], data["johnson"].values[at, part]
    if poses is None:
        found["time_of"] = data["time"].values[at]
    else:  # numbers of poses are not times
        found["pose"] = poses[at]
    return found


def _score(data: Columns) -> NDArray[np.float64]:
    """The value to compare: utilisation, the demand if there is no limit, -1 if there is neither; of beam-columns without a
    finite value compression over Euler's load, above all finite ones.
    """
    value, used = data["value"].values, data["utilisation"].values
    found: NDArray[np.float64] = np.nan_to_num(np.where(np.isnan(used), value, used), nan=-1.0, posinf=np.inf)
    ratio = value[:, :, list(RULES).index("buckling")] / data["euler"].values
    found[:, :, -1] = np.where(np.isinf(found[:, :, -1]), BEYOND * ratio, found[:, :, -1])
    return found
