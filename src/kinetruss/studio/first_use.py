"""What drawings compute that runs of most models do not: every kind of part that a tool draws, once, so that it is compiled."""

from __future__ import annotations

import json
from typing import Any

from kinetruss.studio.messages import Session

STEEL = {"section": {"kind": "rectangle", "width": "20 mm", "height": "40 mm"}, "material": "steel_s235"}


def used(dim: int) -> tuple[Session, Session]:
    """Drawings in a plane or in space (dim) that have been edited and played: a mechanism, and a beam on springs.

    >>> [one.drawing.found.forces is not None for one in used(2)]
    [True, True]
    """
    mechanism, frame = (Session(draw=True, dim=dim) for _ in range(2))
    _ask(mechanism, do="change", words="a mechanism", changes=list(_mechanism(dim).items()))
    _ask(mechanism, do="sweep", drives=["motor"])
    _ask(frame, do="change", words="a beam", changes=list(_frame(dim).items()))
    return mechanism, frame


def _ask(session: Session, **message: Any) -> None:
    if "changes" in message:
        message["changes"] = [[[table], value] for table, value in message["changes"]]
    answer = session.answer(json.dumps(message))
    while isinstance(answer, dict) and answer["kind"] == "computing":
        answer = session.answer(json.dumps({"do": "motion", "number": answer["number"]}))


def _mechanism(dim: int) -> dict[str, Any]:
    """A driven four-bar with a pair of gear wheels, a block on an arm, springs, a rope and a driven length."""
    flat = {
        "A": (0, 0), "B": (0, 0.2), "C": (0.5, 0.4), "D": (0.6, 0), "R": (-0.3, 0), "S": (-0.3, 0.1), "O": (0, -0.3),
        "T": (0, 0.6), "H": (0.3, -0.2), "K": (0.9, 0),
    }  # fmt: skip
    axis, across = ({}, [{}]) if dim == 2 else ({"axis": "z"}, [{"axis": "z"}, {"along": "z"}])

    def angle(bar: str) -> dict[str, str]:
        return {"kind": "angle", "bar": bar, **axis}

    blocks = [{"kind": "offset", "line": ["O", "T"], "point": "B", **way} for way in across]
    held = dict.fromkeys("ADROH", "xyz"[:dim]) | {"K": "yz"[: dim - 1]}
    return {
        "nodes": {name: [*place, *[0] * (dim - 2)] for name, place in flat.items()},
        "fixed": held | ({} if dim == 2 else dict.fromkeys("CST", "z")),
        "bars": {
            "crank": ["A", "B"], "coupler": ["B", "C"], "rocker": ["C", "D"], "wheel": ["R", "S"], "arm": ["O", "T"],
            "spring": {"ends": ["H", "C"], "kind": "elastic", "stiffness": "1 kN/m"},
            "rope": {"ends": ["H", "B"], "kind": "cable", "stiffness": "100 kN/m"},
            "jack": {"ends": ["D", "K"], "kind": "driven"},
        },
        "couplings": {
            "gear": {"terms": [[angle("crank"), -1], [angle("wheel"), -1]]},
            **{f"block{k}": {"terms": [[one, 1]], "value": 0} for k, one in enumerate(blocks)},
        },
        "springs": {"hinge": {"coordinate": angle("rocker"), "stiffness": "10 N m/rad"}},
        "drives": {"motor": angle("crank")},
        "loads": {"F": {"node": "C", "force": [0, -100, *[0] * (dim - 2)]}},
    }  # fmt: skip


def _frame(dim: int) -> dict[str, Any]:
    """A clamped beam and a link, on a spring foot, with a load along the beam; nothing but what yields holds them."""
    none = [0] * (dim - 2)
    foot = {"x": "held", "y": "10 kN/m", **({} if dim == 2 else {"z": "held"})}
    return {
        "nodes": {"A": [0, 0, *none], "B": [0.5, 0, *none], "C": [0.9, 0.1, *none], "D": [0.9, -0.3, *none]},
        "clamped": ["A"], "supports": {"D": foot},
        "beams": {"beam": {"ends": ["A", "B"], **STEEL}}, "links": {"link": {"nodes": ["B", "C", "D"], "weld": ["B"], **STEEL}},
        "loads": {"F": {"node": "C", "force": [0, -100, *none]}, "q": {"member": "beam", "force": [0, -100, *none]}},
    }  # fmt: skip
