"""The report of an optimum: what was asked, the design that was found, and what is proven of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure as Canvas
from matplotlib.ticker import MaxNLocator

from kinetruss.design.optimum.certificate import FIRST_ORDER, REACHED
from kinetruss.design.optimum.evaluations import FEASIBLE
from kinetruss.design.optimum_result import SHARE, ActiveLimit, wider
from kinetruss.display import Markup, Table, counted, element, number, quantity, scale
from kinetruss.display.tables import bar, drawn as drawn_column, mixed, words
from kinetruss.report.document.frame import framed
from kinetruss.report.document.inputs import total_mass
from kinetruss.report.document.run_pictures import lines_of
from kinetruss.report.document.title_block import front_of
from kinetruss.report.entries import Figure, Section
from kinetruss.report.page import Page
from kinetruss.report.pictures.drawing import drawn
from kinetruss.report.pictures.specs import ACCENT, ALARM, INK, RC, WIDTHS
from kinetruss.report.pictures.stands import drawing, shown_at
from kinetruss.report.run_data import plain
from kinetruss.viewer.scenes import snapshots

if TYPE_CHECKING:
    from pathlib import Path

    from kinetruss.design import KeptOptimum
    from kinetruss.model import Model, TitleBlock
    from kinetruss.report.document.title_block import Front
    from kinetruss.report.entries import Entry

STATES = {
    "searching": "The search is not finished, so there is no optimum yet. The same command goes on where it stands: "
    "kinetruss optimise FILE -o {folder}",
    "infeasible": "There is no optimum: the limits cannot be kept together.",
    "failed": "The search failed, so there is no optimum.",
}
"""State of a search without a result -> its first line."""
UNCERTAIN = "This is no optimum. "
TALLEST = 5.0
"""Largest height of the structure, inches."""


def optimum_page(
    found: KeptOptimum, date: str = "", block: TitleBlock | None = None, paper: str = "a4", *, logo: str | Path | None = None
) -> Page:
    """The report of an optimum. A search that was interrupted, or has not ended, is said to be so.

    Parameters
    ----------
    found : from `load_optimum`. The others : as of `document_page`.

    Raises
    ------
    InputError : unknown paper; a logo that cannot be used.

    Examples
    --------
    >>> import tempfile
    >>> import kinetruss as kt
    >>> rod = kt.Model(nodes={"A": (0, 0), "B": (2, 0)}, fixed={"A": "xy", "B": "y"}, bars={"b": ("A", "B")},
    ...                section=kt.Rod(diameter=0.02), material="steel_s235",
    ...                loads={"pull": kt.NodalForce(node="B", force=(7e3, 0))})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = kt.design.optimise(
    ...         rod, {"diameter": {"of": "section.diameter", "between": ("4 mm", "40 mm")}}, "mass",
    ...         {"stress": {"of": "axial_stress", "at_most": "100 MPa"}}, arguments={"weight": False}, out=folder + "/lightest",
    ...     )
    ...     page = kt.report.optimum_page(kt.design.load_optimum(folder + "/lightest"))
    >>> page.record["result"][0]
    'mass: 4.932 kg at the start, 1.099 kg at the optimum.'
    """
    front = front_of(block, found.given.report, date, paper=paper, logo=logo)
    return Page(found=found, as_record=_record, as_html=partial(_html, front=front))


def _record(found: KeptOptimum) -> dict[str, Any]:
    names = ("state", "question", "message", "result", "history")
    own: dict[str, Any] = plain({name: getattr(found, name) for name in names})
    model = None if found.model is None else found.model.model_dump_json()
    return {
        "schema": "kinetruss.optimum_report/1",
        **own,
        "found": own["result"],
        "result": list(optimum_lines(found)),
        "model": model,
    }


def optimum_lines(found: KeptOptimum) -> tuple[str, ...]:
    """What a search says, in a few lines: values of the objective, and what is proven."""
    one = found.result
    if one is None:
        first = STATES[found.state].format(folder=found.path.name)
        return (first, found.message or f"{counted(len(found.history), 'analysis', 'analyses')} so far.")
    before, now = quantity(one["before"], one["unit"]), quantity(one["objective"], one["unit"])
    return (f"{one['least']}: {before} at the start, {now} {_at(one)}.", one["sentence"])


def _at(one: Mapping[str, Any]) -> str:
    return "at the optimum" if one["certified"] else "in the best design so far" if one["state"] else "where the search ended"


def _html(found: KeptOptimum, front: Front) -> str:
    asked, record = found.question, _record(found)
    title = asked["title"] or asked["model"] or "Optimum"
    parts = [
        Section("result", "Result", "", list(_result(found))),
        Section("question", "Question", "What is made small, what may change, and what must be kept", list(_question(found))),
        Section("design", "Design", "The variables at the start and now", list(_design(found))),
        Section("certificate", "Certificate", "What is proven, and what each limit costs", list(_certificate(found))),
        Section("limits", "Limits", "How far each limit is used", list(_limits(found))),
        Section("history", "History", "The search, analysis by analysis", list(_history(found))),
        Section("structure", "Structure", "The model as it was given, and with the values found", list(_structure(found))),
    ]
    quiet = " · ".join(one for one in (asked["model"], f"least {asked['least']}", front.block.date) if one)
    return framed(title, front, record["result"], parts, kicker="Report of an optimum", quiet=quiet, record=record,
                  foot=f"{title}, optimum")  # fmt: skip


def _result(found: KeptOptimum) -> Iterator[Entry]:
    one = found.result
    if one is None or not one["certified"]:
        state = found.state if one is None else one["state"]
        said = {"searching": "It is being computed, or was stopped.", "interrupted": "The search was interrupted."}
        words_ = said.get(state, "See what is said above.")
        yield element("div", element("strong", UNCERTAIN), words_, class_="alarm", role="alert")
    if one is not None:
        yield element("div", list(_tiles(one)), class_="tiles")
        yield from (element("p", note) for note in one["notes"])


def _tiles(one: Mapping[str, Any]) -> Iterator[Markup]:
    share = 1 - one["objective"] / one["before"] if one["before"] else 0.0
    changed = f"{quantity(abs(share), '%')} {'less' if share >= 0 else 'more'} than at the start"
    yield _tile(one["least"], quantity(one["objective"], one["unit"]), changed)
    priced = [active for active in one["active"] if active["price"] > 0]
    yield _tile("Limits and bounds that cost something", str(len(priced)), f"of {len(one['active'])} that are reached")
    held = one["certificate"]["first_order"]
    residual = number(one["certificate"]["residual"], 2)
    yield _tile("Residual of the conditions", residual, f"up to {FIRST_ORDER:g} they hold", not held)
    yield _tile("Analyses", str(one["analyses"]), f"{one['seconds']:.0f} s")


def _tile(name: str, value: str, said: str, alarming: bool = False) -> Markup:
    inside = (element("span", name), element("b", value), element("small", said))
    return element("div", inside, class_="tile over" if alarming else "tile")


def _question(found: KeptOptimum) -> Iterator[Entry]:
    asked = found.question
    yield f"Make {asked['least']} as small as the limits allow, by {counted(len(asked['variables']), 'variable')}."
    rows = [
        (one["name"], ", ".join(one["of"]), f"{len(one['choose'])} values" if one["choose"] else "range",
         quantity(one["lower"], one["unit"]), quantity(one["upper"], one["unit"]))
        for one in asked["variables"]
    ]  # fmt: skip
    yield Table(("variable", "of the model", "from", "least", "largest"), rows, "Variables")
    limits = [
        (one["name"], one["of"], *(_bound(one, side) for side in ("at_least", "at_most")), ", ".join(one["load_cases"]) or "-",
         _analysis(one))
        for one in asked["limits"]
    ]  # fmt: skip
    note = "A limit holds for every value: each member, node, axis and instant, in each of its load cases."
    yield Table(("limit", "of", "at least", "at most", "load cases", "analysis"), limits, "Limits", note)


def _bound(one: Mapping[str, Any], side: str) -> str:
    return "-" if one[side] is None else quantity(one[side], one["unit"])


def _analysis(one: Mapping[str, Any]) -> str:
    return " ".join([one["analysis"], *(f"{name}={value}" for name, value in one["arguments"].items())])


def _design(found: KeptOptimum) -> Iterator[Entry]:
    one = found.result
    if one is None:
        return
    reached = {(active["name"], active["side"]) for active in one["active"] if active["bound"]}
    rows = [
        {**asked, "value": one["values"][asked["name"]],
         "reached": next((words_ for side, words_ in (("least", "least value"), ("most", "largest value"))
                          if (asked["name"], side) in reached), "")}
        for asked in found.question["variables"]
    ]  # fmt: skip
    columns = [
        words("variable", "name"), *(mixed(head, of, group="value") for head, of in
        (("least", "lower"), ("start", "start"), ("now", "value"), ("largest", "upper"))),
        drawn_column(lambda row: bar((row["value"] - row["lower"]) / (row["upper"] - row["lower"] or 1.0)), "in its range"),
        words("reaches", "reached"),
    ]  # fmt: skip
    yield Table(columns, rows, "The variables")
    if found.model is not None:
        before, after = (quantity(total_mass(model), "kg") for model in (found.given, found.model))
        yield f"Mass of everything in the model: {before} as it was given, {after} with these values."


def _certificate(found: KeptOptimum) -> Iterator[Entry]:
    one = found.result
    if one is None:
        return
    proof, least = one["certificate"], one["least"]
    yield element("p", one["sentence"], class_="outcome")
    yield (
        f"At a least value the gradient of {least} is balanced by those of the limits that are reached, each with a multiplier "
        "that is not negative (Karush 1939; Kuhn and Tucker 1951). The multipliers are found apart from the solver, by "
        f"non-negative least squares. What is left of the balance is {number(proof['residual'], 2)} of the gradient, in "
        f"variables from 0 to 1; up to {FIRST_ORDER:g} counts as balanced. The largest excess of a limit is "
        f"{number(max(proof['excess'] or 0.0, 0.0), 2)} of it; up to {FEASIBLE:g} counts as kept. Second order is not checked."
    )
    reached = [ActiveLimit(**active) for active in one["active"]]
    if not one["certified"] or one["relaxed"] is not None:  # multipliers of what is not balanced are no prices
        names = "; ".join(f"{active.name} at {active.side} {quantity(active.limit, active.unit)}" for active in reached)
        yield f"Reached: {names or 'nothing'}. There are no prices, as nothing is certified of them."
        return
    heads = ("reached", "", "limit", "multiplier", "if moved by", f"{least} saved")
    note = (
        f"Reached: less than {REACHED:g} of the limit is left. The multiplier is by how much {least} falls if the limit is "
        "moved by one unit; that holds for small moves."
    )
    yield Table(heads, [_cost(active, one["unit"]) for active in reached], "Limits and bounds that are reached", note)


def _cost(active: ActiveLimit, unit: str) -> tuple[str, ...]:
    of = active.unit if active.unit.isalpha() else f"({active.unit})"
    saved = active.price * SHARE * abs(active.limit)
    return (
        active.name,
        f"{'bound' if active.bound else 'limit'}, at {active.side}",
        quantity(active.limit, active.unit),
        f"{number(active.price)} {f'{unit or 1}/{of}' if active.unit else unit}".strip(),
        f"{100 * SHARE:g} % {wider(active)}" if saved > 0 else "-",
        quantity(saved, unit) if saved > 0 else "nothing",
    )


def _limits(found: KeptOptimum) -> Iterator[Entry]:
    one = found.result
    if one is None:
        return
    rows = sorted(one["limits"], key=lambda row: float("-inf") if row["left"] is None else row["left"])
    columns = [
        words("limit", "name"), words("worst value", lambda row: row["subject"].removeprefix(row["name"]).strip() or "-"),
        mixed("start", "before", group="value"), mixed("now", "value", group="value"),
        words("", lambda row: f"at {row['side']}"), mixed("limit", "limit", group="value"),
        words("left", lambda row: "-" if row["left"] is None else _left(row["left"])),
        drawn_column(lambda row: bar(1 - (row["left"] if row["left"] is not None else -1.0)), "used"),
    ]  # fmt: skip
    exceeded = sum(row["left"] is None or row["left"] < -FEASIBLE for row in rows)
    note = f"{exceeded} of {len(rows)} are exceeded." if exceeded else "All are kept."
    yield Table(columns, rows, "The limits at this design, the most used first", note)


def _left(share: float) -> str:
    return "0 %" if abs(share) < FEASIBLE else quantity(share, "%")


def _history(found: KeptOptimum) -> Iterator[Entry]:
    if len(found.history) < 2:
        return
    unit = found.question["unit"]
    steps, objective, worst = (np.array(part, float) for part in zip(*found.history, strict=True))
    factor, shown = scale(float(np.abs(objective).max()), unit)
    kept = ~(worst > FEASIBLE)  # NaN: nothing is limited
    with mpl.rc_context(RC):
        canvas = Canvas(figsize=(6.6, 4.2), layout="constrained")
        FigureCanvasAgg(canvas)
        above, below = canvas.subplots(2, 1, sharex=True)
        above.plot(steps, factor * objective, color=ACCENT, linewidth=1.0)
        above.plot(steps[kept], factor * objective[kept], "o", color=ACCENT, markersize=4, label="keeps the limits asked")
        above.plot(steps[~kept], factor * objective[~kept], "x", color=ALARM, markersize=5, label="exceeds a limit")
        above.set_ylabel(f"{found.question['least']}, {shown}" if shown else found.question["least"])
        above.legend(loc="best")
        below.plot(steps, 100 * np.fmax(np.nan_to_num(worst), 0.0), color=ACCENT, marker=".", linewidth=1.0)
        below.set_yscale("symlog", linthresh=1.0)
        below.axhline(0.0, color=INK, linewidth=0.6)
        below.set_ylabel("largest excess, %")
        below.set_xlabel("analysis")
        below.xaxis.set_major_locator(MaxNLocator(integer=True))
        caption = (
            f"{found.question['least']} and the largest excess of a limit, of its size, over the analyses; the scale of the "
            "excess is linear up to 1 %, then logarithmic. The solver looks beyond limits on its way, and asks only those that "
            "matter there; at its end all are asked."
        )
        yield Figure(panels=[lines_of(canvas, "history", caption)], caption=caption)


def _structure(found: KeptOptimum) -> Iterator[Entry]:
    pair = [found.given] if found.model is None else [found.given, found.model]
    moved = found.model is not None and any(
        node.at != found.model.nodes[name].at for name, node in found.given.nodes.items()
    )  # fmt: skip
    if moved:
        panels = [_drawn(one, name) for one, name in zip(pair, ("given", "now"), strict=True)]
        yield Figure(panels=panels, caption="The structure as it was given, and with the values found below.")
    else:
        same = "" if found.model is None else " No node moves: it looks the same with the values found."
        yield Figure(panels=[_drawn(found.given, "given")], caption=f"The structure as it was given.{same}")


def _drawn(model: Model, name: str) -> Markup:
    scene = snapshots(model)
    figure = drawing(scene, shown_at(scene, [""], "iso"), width=WIDTHS["column"], tallest=TALLEST)
    # a slender structure stays as narrow as it is
    return Markup(lines_of(drawn(figure), name, f"The structure, {name}").replace('style="', 'style="min-width:0;', 1))
