"""Checks that a reviewer can repeat, the methods that a run used, and the data to repeat it."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.display import Markup, Table, element, quantity
from kinetruss.errors import KinetrussError
from kinetruss.model import Bar

if TYPE_CHECKING:
    from kinetruss.model import Model
    from kinetruss.report.entries import Entry
    from kinetruss.runs import RunResult


LARGEST = 300
"""Number of nodes up to which a report lists mechanisms and states of self-stress."""


def mobility_record(model: Model) -> dict[str, Any] | None:
    """Degrees of freedom, mechanisms and states of self-stress of the model in its own pose; None for larger models.

    ``elastic``: True if elastic bars, beams, membranes or solids hold it besides; ``elastic_as_rigid``: the same with elastic
    bars as rigid ones.
    """
    if len(model.whole.nodes) > LARGEST:
        return None
    elastic = [name for name, bar in model.bars.items() if bar.kind == "elastic"]
    stiff = None
    if elastic and not model.bending:
        bars = {name: Bar(ends=bar.ends, mass=0.0) if name in elastic else bar for name, bar in model.bars.items()}
        try:
            stiff = _mobility(model.with_(bars=bars))
        except (KinetrussError, ValueError):  # another record needs the bar to be elastic
            stiff = None
    return _mobility(model) | {
        "elastic": bool(elastic or model.bending or model.membranes or model.solids),
        "elastic_as_rigid": stiff,
    }


def _mobility(model: Model) -> dict[str, Any]:
    from kinetruss.kinematics import mobility

    found = mobility(model)
    names = (
        "bars",
        "coordinates",
        "fixed",
        "rank",
        "degrees_of_freedom",
        "drives",
        "undriven",
        "self_stress",
        "maxwell",
        "smallest_singular_value",
    )
    texts = {"mechanisms": found.mechanism_texts(), "self_stress_states": found.self_stress_texts()}
    return {name: getattr(found, name) for name in names} | texts


# The methods that a run used, and their publications.

GIVEN = (
    "Motion",
    "Node positions satisfy the lengths and angles that bars and drives prescribe. They are found by Newton's method from "
    "sample to sample; steps are halved where necessary, so that the configuration stays connected to that of the start. "
    "Velocities and accelerations follow from the same matrix. Nothing is differentiated numerically in time.",
    "Lacy (1991), chapters 2 to 6; Calladine (1978); Pellegrino and Calladine (1986)",
)
MEASURED = (
    "Motion",
    "Positions, velocities and accelerations of the nodes are those of the given record.",
    "",
)
FORWARD = (
    "Forward dynamics",
    "M a + Jᵀ N = f together with the constraints on accelerations, in the coordinates of the nodes. Methods with error "
    "control (power series, Runge-Kutta of order 8) project positions and velocities onto the constraints after every step; "
    "implicit methods satisfy them at the end of each step. Between steps the motion is that of the polynomial of the step.",
    "Jorba and Zou, Experimental Mathematics 14 (2005) 99 (power series); Hairer, Nørsett and Wanner, Solving Ordinary "
    "Differential Equations I (DOP853)",
)
LINEAR = (
    "Linear statics",
    "f N − G u = 0 and Gᵀ N = F together, with f = L/(E A), compatibility matrix G and displacements u. This is equivalent to "
    "the stiffness method, but forces follow from equilibrium and not from differences of displacements. Displacements are "
    "small; drives are locked.",
    "",
)
EQUILIBRIUM = (
    "Equilibrium",
    "Positions at which all nodes are in balance, with large displacements; stability by the stiffness at the solution.",
    "",
)
INVERSE = (
    "Forces",
    "Jᵀ N = f − M a at every sample. A uniform bar has the consistent mass matrix: the forces on its joints are those of "
    "Newton and Euler for a rigid rod. The member force is the mean of the tension over its length. An active member is two "
    'rods, base and tube, that slide along one line. "At rest" means the same poses without velocity and acceleration.',
    "Lacy (1991), chapters 2, 4 and 6",
)
STRENGTH = (
    "Strength",
    "Section forces follow in closed form from the accelerations of the ends. Yield: the largest von Mises stress "
    "along the part and over its section. Buckling: Euler's load, or Johnson's parabola for stocky members, with the length "
    "of that instant. Beam-column: linear interaction of compression and bending; the compression amplifies the bending. "
    "Utilisation is demand over capacity, safety factors included; margin is 1/utilisation − 1. Limits of validity: straight "
    "prismatic parts and small strains; local buckling of thin walls, strength of joints and fatigue are not included.",
    "Lacy (1991), eq. 2.20 to 2.35; Shigley, Mechanical Engineering Design; Timoshenko and Gere, Mechanics of "
    "Materials; AISC, Allowable Stress Design (1989), eq. H1-1",
)
DRIVES = (
    "Drives",
    "The thrust is the compression of the active member at the nut. The sign of its power decides whether the screw raises or "
    "lowers its load, against the friction of its thread. The torque of the motor includes the inertia of motor and gear. The "
    "current is this torque over the torque constant; the voltage is that of the winding plus the back-emf.",
    "Lacy (1991), eq. 2.36 to 2.40 and 4.78; Shigley, Mechanical Engineering Design (power screws)",
)
CHECKS = (
    "Checks",
    "Energy balance: the power of drives, loads and moving supports, minus the rate of kinetic and potential energy, minus the "
    "power that dampers dissipate. Forces and motion enter independently, so that an error in either shows. Singularity: an "
    "estimate of the smallest singular value of the gradients of all lengths and angles, each of unit length. Lengths of bars "
    "are computed again from the positions of the nodes.",
    "",
)


SOLVED = {"statics.linear": LINEAR, "statics.equilibrium": EQUILIBRIUM}


def methods(run: RunResult) -> Iterator[tuple[str, str, str]]:
    """Name, what was done, and published sources (or none) of each method that the run used."""
    definition = run.definition
    if run.simulation is not None or definition.analysis == "dynamics.simulate":
        yield FORWARD
    elif definition.analysis in SOLVED:
        yield SOLVED[definition.analysis]
    else:
        yield GIVEN if definition.motion is None else MEASURED
    if run.forces and definition.analysis not in SOLVED:
        yield INVERSE
    if run.verdict is not None and run.verdict.table():
        yield STRENGTH
    if run.demand:
        yield DRIVES
    yield CHECKS


# Data to repeat a run: the model, its hash, versions, commands.

PRINTED = 400
"""Number of lines up to which a model file is printed; a longer one is shown only in the page."""
NARROW, FEW = 58, 20
"""Characters of a line in half of a sheet; number of lines from twice which on two columns are worth while."""
SHOWN = 300_000
"""Number of characters up to which a model file is shown; a larger one can only be saved."""


def recompute(run: RunResult, record: dict[str, Any]) -> list[Entry]:
    """Versions and hash, commands, and the model file."""
    given = {key: value for key, value in record["provenance"].items() if key not in ("title", "model", "run")}
    rows: list[tuple[str, Any]] = [("run folder", record["out"])] if record["out"] else []
    rows += [("versions", ", ".join(f"{key} {value}" for key, value in given.items()))]
    rows += [("model.json, SHA-256", element("code", record["model_sha256"]))]
    rows += [(f"{name}, SHA-256", text) for name, text in _motion(run)]
    rows += [("computing took", quantity(run.wall_time, "s"))]
    saved = element("a", "Save model.json", href=_address(record["model"]), download="model.json", class_="screen save")
    steps = f"kinetruss check model.json\nkinetruss run model.json {run.name} -o again\nkinetruss info again"
    parts: list[Entry] = [
        Table(("", ""), rows, "Provenance"),
        element(
            "p",
            "The file report.html holds the model, byte by byte; save it as model.json. ",
            saved,
            " Then, with the versions above:",
            class_="where",
        ),
        element("pre", element("code", steps), class_="short"),
    ]
    return [*parts, *_listing(run.model)]


def _motion(run: RunResult) -> list[tuple[str, Any]]:
    """The present hash of the motion's file."""
    given = run.definition.motion
    if given is None:
        return []
    path = Path(given)
    if not path.is_file():
        return [(path.name, "not where it was; its motion is in the run folder")]
    return [(path.name, element("code", hashlib.sha256(path.read_bytes()).hexdigest()))]


def _listing(model: Model) -> list[Markup]:
    """The model as YAML text."""
    from kinetruss.io.emitting import plain_model, to_yaml

    text = to_yaml(plain_model(model))
    if len(text) > SHOWN:
        return [element("p", "The model is too long to be shown here; save it to read it.", class_="note")]
    long = text.count("\n") > PRINTED
    note = element("p", "The model file is printed in the page only: it is long.", class_="paper note") if long else None
    words = element("h3", "The model file (SI units; default values are omitted)")
    return [
        words,
        *([note] if note else []),
        element(
            "pre",
            element("code", text),
            class_=" ".join(["model", *(["screen"] if long else []), *(["wide"] if _is_narrow(text) else [])]),
            tabindex="0",
            role="region",
            aria_label="the model",
        ),
    ]


def _is_narrow(text: str) -> bool:
    """True if nearly all lines fit into half of the sheet: then it is printed in two columns."""
    lines = text.splitlines()
    return sum(len(line) <= NARROW for line in lines) >= 0.9 * len(lines) and len(lines) > 2 * FEW


def _address(text: str) -> str:
    return f"data:application/json;base64,{base64.b64encode(text.encode()).decode('ascii')}"
