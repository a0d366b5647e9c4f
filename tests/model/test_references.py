"""Every field that names another entry: a misspelt name gives a fault at its place, with the nearest name."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, get_args

import pytest

import kinetruss as kt
from kinetruss.model.data import ModelData
from kinetruss.model.record import Record
from kinetruss.model.references import Ref, names_in

ROD = {"kind": "rod", "diameter": "20 mm"}
STEEL = {"E": "210 GPa", "density": 7850, "poisson": 0.3}
TRAIN = {"gear": "spur", "motor": "small", "amplifier": "servo"}
STOCK = {
    "sections": {"round": ROD},
    "materials": {"steel": STEEL},
    "screws": {"fine": {"lead": "5 mm/rev", "mean_diameter": "17 mm", "friction": 0.1}},
    "gears": {"spur": {"ratio": 4}},
    "motors": {"small": {"torque_constant": 0.05, "emf_constant": 0.05, "resistance": 1.2, "inertia": 2e-5}},
    "amplifiers": {"servo": {"current_gain": 0.8, "max_current": 6}},
}
MOVES = {"motor": [0.0, 0.5], "jack": [1.5, 1.6]}
HINGE = {"kind": "hinge", "axis": ["Bee"], "start": "Ant", "end": "Cat"}
TERMS = [
    [{"kind": "angle", "bar": "crank"}, 1],
    [{"kind": "offset", "line": ["Ant", "Bee"], "point": "Cat"}, 2],
    [{"kind": "cosine", "node": "turn"}, 1],
    [{"kind": "distance", "nodes": ["Ant", "Cat"]}, 1],
    [{"kind": "coordinate", "node": "Cat", "axis": "x"}, 1],
    [HINGE, 1],
    [{"kind": "length", "bar": "rocker"}, 1],
]
TABLE = {"times": [0, 1, 2, 3], "values": {"motor": [0, 0.1, 0.2, 0.3]}}
PART = {"length": 0.5, "mass": 1, "section": "round", "material": "steel"}

PLANE = STOCK | {
    "nodes": {"Ant": [0, 0], "Bee": [0, 1], "Cat": [1, 1], "Dog": [1, 0], "turn": {"at": [0, 0], "scalar": True}},
    "fixed": {"Ant": "xy", "Dog": "xy"},
    "bars": {
        "crank": ["Ant", "Bee"],
        "coupler": {"ends": ["Bee", "Cat"], "section": "round", "material": "steel"},
        "rocker": ["Cat", "Dog"],
    },
    "active": {"jack": {"ends": ["Ant", "Cat"], "base": PART, "tube": PART, "screw": "fine", **TRAIN}},
    "section": "round",
    "material": "steel",
    "cylinders": {
        "ram": {"member": "crank", "bore": 0.04, "rod": 0.02, "pressure_A": 1e6},
        "free": {"nodes": ["Ant", "Cat"], "bore": 0.04, "rod": 0.02, "pressure_A": 1e6},
    },
    "bodies": {"plate": {"nodes": ["Cat", "Dog"], "carriers": ["Cat", "Dog"], "mass": 1}},
    "joints": {
        "foot": {
            "kind": "pin", "bodies": ["plate", "ground"], "nodes": ["Dog"], "bars": ["rocker"], "couplings": ["pair"],
            "hinges": [{"axis": ["Dog"], "start": "Cat", "end": "Ant"}], "slide": ["Ant", "Bee"],
        },
    },
    "bearings": {"elbow": {"member": "coupler", "node": "Bee", "radius": 0.01, "friction": 0.1, "against": "crank"}},
    "drives": {
        "motor": {"kind": "angle", "bar": "crank", **TRAIN},
        "stretch": {"kind": "length", "bar": "coupler"},
        "push": {"kind": "coordinate", "node": "Bee", "axis": "x"},
        "fold": HINGE | TRAIN,
    },
    "couplings": {"pair": {"terms": TERMS}},
    "springs": {"coil": {"coordinate": HINGE, "stiffness": 5}, "sum": {"terms": TERMS[:2], "stiffness": 5}},
    "loads": {"hook": {"node": "Cat", "force": [0, -1]}, "wind": {"face": ["Bee", "Cat"], "pressure": 3},
              "snow": {"member": "coupler", "force": [0, -2]}, "wear": {"member": "rocker", "moment": 1}},
    "load_cases": {"lift": {"loads": {"hook": 1.5}}},
    "conditions": {
        "cold": {
            "payloads": {"Cat": 1}, "forces": {"Cat": [0, 1]}, "temperatures": {"crank": 1}, "locked": ["motor"],
            "released": ["stretch"], "failed": ["coupler"],
        },
    },
    "support_motion": {"Dog": {"times": [0, 1], "displacements": [[0, 0], [0, 0.1]]}},
    "velocities": {"Bee": [1, 0]},
    "trajectories": {
        "quintic": {"kind": "quintic", "moves": MOVES, "duration": 1},
        "trapezoid": {"kind": "trapezoid", "moves": MOVES, "duration": 1},
        "cyclic": {"kind": "cyclic", "moves": MOVES, "period": 1},
        "step": {"kind": "step_response", "moves": MOVES, "duration": 1},
        "rate": {"kind": "constant_rate", "rates": {"motor": 1}, "duration": 1},
        "sine": {"kind": "sine", "amplitudes": {"motor": 1}, "period": 1, "duration": 1},
        "spline": {"kind": "spline", **TABLE},
        "measured": {"kind": "measured", **TABLE},
    },
    "runs": {
        "turn": {"trajectory": "quintic", "load_cases": ["lift"], "condition": "cold"},
        "fly": {
            "analysis": "dynamics.simulate", "t_end": 1, "tasks": {"motor": {"kind": "free"}},
            "events": {"long": {"length": "jack", "value": 2}, "strong": {"force": "crank", "value": 2}},
        },
        "given": {
            "analysis": "dynamics.simulate", "t_end": 1, "trajectory": "quintic",
            "feedback": {"drives": ["jack"], "stiffness": {"jack": 1}, "damping": {"jack": 1}, "limits": {"jack": 1}},
        },
        "cheap": {
            "analysis": "dynamics.simulate", "t_end": 1, "trajectory": "quintic",
            "feedback": {"drives": ["jack"], **{f"{what}_cost": {"jack": 1} for what in ("error", "rate", "force")}},
        },
        "stand": {"analysis": "statics.at_poses", "poses": {"up": {"motor": 0.1}}},
        "all": {"analysis": "mission", "motions": ["turn2", "sine"], "conditions": ["cold"]},
        "turn2": {"trajectory": "rate"},
        "bend": {
            "analysis": "flexible.corrected", "trajectory": "rate",
            "elastic": {"stiffness": {"crank": 1e6}, "rigid": ["coupler"], "drives": ["motor"], "at": ["Cat.x"]},
        },
    },
    "gauges": {"strain": {"member": "rocker"}},
    "gauge_zero": {"at": {"motor": 0.1}, "load_case": "lift"},
    "quantities": {"rise": {"value": "Cat.y", "limits": [None, 9], "load_cases": ["lift"]}},
    "deflections": {"bow": {"members": ["rocker"], "limit": 9, "measured_from": "start", "load_cases": ["lift"]}},
}  # fmt: skip

WEIGHTS = {"weights": {"jack": 2}, "hold": ["left"], "rate": {"jack": 1}, "acceleration": {"jack": 1}, "force": {"jack": 9}}
TOP = ["Eel", "Fox", "Gnu"]


def task(kind: str, **fields: Any) -> dict[str, Any]:
    return {"targets": {"kind": kind, **WEIGHTS, **fields}}


SPACE = STOCK | {
    "nodes": {
        "Ant": [0, 0, 0], "Bee": [1, 0, 0], "Cat": [0, 1, 0], "Dog": [0, 0, 1], "Eel": [2, 0, 1], "Fox": [2, 2, 1],
        "Gnu": [0, 2, 1.5], "Hen": [3, 3, 0], "Ibis": [1, 2, 1.5],
    },
    "fixed": {"Ant": "xyz", "Bee": "xyz", "Cat": "xyz", "Hen": "xyz", "Ibis": "xyz"},
    "supports": {"Gnu": {"x": "held", "along": "Cat", "across": "Ibis"}},
    "bars": {
        "left": {"ends": ["Ant", "Eel"], "kind": "driven", "orientation": "Bee"},
        "right": {"ends": ["Bee", "Fox"], "kind": "driven"},
        "post": ["Cat", "Gnu"],
        "brace": ["Dog", "Gnu"],
        "stem": ["Dog", "Hen"],
    },
    "active": {"jack": {"ends": ["Cat", "Fox"], "base": PART, "tube": PART, "orientation": "Dog"}},
    "material": "steel",
    "section": "round",
    "hubs": {
        "Dog": {
            "arms": {"brace": [0.05, 0, 0.02]}, "clamped": ["stem"], "hinges": {"brace": "x"}, "section": "round",
            "material": "steel",
        },
    },
    "beams": {"mast": {"ends": ["Hen", "Bee"], "orientation": "Ant", "section": "round", "material": "steel"}},
    "links": {"boom": {"nodes": ["Ant", "Dog", "Gnu"], "orientation": "Bee", "section": "round", "material": "steel"}},
    "clamped": {"Hen": "ground"},
    "membranes": {"skin": {"nodes": TOP, "elements": [[0, 1, 2]], "thickness": 0.001, "material": "steel"}},
    "solids": {"block": {"nodes": ["Ant", "Bee", "Cat", "Dog"], "elements": [[0, 1, 2, 3]], "material": "steel"}},
    "poses": {"bay": {"base": 1, "longeron": 1, "drives": ["left", "right", "jack"]}},
    "runs": {
        "gimbal": task("gimbal", platform=TOP, base=["Ant", "Bee", "Cat"]),
        "place": task("positioning", nodes=TOP),
        "point": task("positioning", node="Eel"),
        "mirror": task("reflecting", platform=TOP, source=[0, 0, 9], target=[9, 0, 9]),
        "dock": task("docking", platform=TOP),
        "aim": task("pointing", platform=TOP),
        "line": task("pointing", line=["Eel", "Fox"]),
        "any": task("coordinates", moves={"Eel.x": 2.1}),
        "both": task("combined", tasks=[{"kind": "positioning", "node": "Eel", "moves": {"x": 2.1}}]),
    },
}  # fmt: skip

FRAME = {
    "nodes": {"Ant": [0, 0], "Bee": [1, 0], "Cat": [2, 0], "turn": {"at": [0, 0], "scalar": True}},
    "fixed": {"Ant": "xy"},
    "clamped": {"Bee": "plate"},
    "bodies": {"plate": {"nodes": ["Bee", "Cat"], "mass": 1}},
    "material": STEEL,
    "section": ROD,
    "beams": {
        "arm": {"ends": ["Bee", "Cat"], "section": "round", "material": "steel"},
        "bar": {"ends": ["Ant", "Bee"], "kind": "rigid", "release": ["Ant", "Bee"], "rotation": "turn"},
    },
    "sections": {"round": ROD},
    "materials": {"steel": STEEL},
}
LOADED = FRAME | {
    "loads": {
        "shove": {"member": "arm", "force": [0, -1], "at": 0.1}, "wring": {"member": "arm", "moment": 1, "at": "50 %"},
        "snow": {"member": "arm", "force": [0, -2], "per": "projection"},
    },
    "load_cases": {
        "still": {"loads": {"shove": 1}, "category": "permanent"}, "gust": {"loads": {"wring": 1}, "category": "wind"},
        "gale": {"loads": {"wring": -1}, "category": "wind"}, "dead": {"loads": {"snow": 1}, "category": "D"},
        "calm": {"loads": {"snow": 2}, "category": "W"}, "blow": {"loads": {"snow": 3}, "category": "W"},
    },
    "combinations": {
        "some": {"cases": {"still": 1.2, "blow": -1}},
        "europe": {"kind": "en1990", "cases": ["still", "gust", "gale"], "exclusive": [["gust", "gale"]]},
        "america": {"kind": "asce7-16", "cases": ["dead", "calm", "blow"], "exclusive": [["calm", "blow"]]},
    },
    "runs": {"stand": {"analysis": "statics.linear", "load_cases": ["europe", "some", "still"]}},
}  # fmt: skip
MODELS = {"plane": PLANE, "space": SPACE, "frame": FRAME, "loaded": LOADED}


def misspelt(here: Any, path: tuple[Any, ...], name: str) -> Any:
    """The data with another name at a place: as the key there, or as the value."""
    if not path:
        return f"{name}_"
    key, *rest = path
    if isinstance(here, list) and not isinstance(key, int):  # a bar that is given by its ends alone
        return misspelt(here, tuple(rest), name)
    if key == name and not rest:
        return {f"{key}_" if one == key else one: value for one, value in here.items()}
    below = misspelt(here[key], tuple(rest), name)
    return [below if k == key else one for k, one in enumerate(here)] if isinstance(here, list) else {**here, key: below}


def given(data: Any, path: tuple[Any, ...]) -> bool:
    """Whether a place is in the data; inner parts are not."""
    return len(path) < 2 or path[1] in data.get(path[0], ())


def cases() -> Iterator[Any]:
    for title, data in MODELS.items():
        model = kt.Model(**data)
        for ref, name, path in names_in(model):
            if given(data, path) and name not in model.whole.inner.nodes:
                yield pytest.param(data, ref, name, path, id=f"{title} {'.'.join(map(str, path))} {ref.word}")


@pytest.mark.parametrize(("data", "ref", "name", "path"), [*cases()])
def test_a_misspelt_name_has_a_fault_at_its_place(data, ref, name, path):
    place = (*path[:-1], f"{name}_") if path[-1] == name else path
    with pytest.raises(kt.errors.ModelError) as caught:
        kt.Model(**misspelt(data, path, name))
    (fault,) = [one for one in caught.value.faults if one.path == place and " called " in one.message]
    assert fault.message == f"no {ref.word} called '{name}_'."
    assert fault.mend.startswith("Did you mean ") and repr(name) in fault.mend


def filled(value: Any) -> Iterator[tuple[str, str]]:
    """Record and field of all names of entries in a value."""
    if isinstance(value, Record):
        yield from ((type(value).__name__, str(place[0])) for _, _, place in names_in(value))
        value = {field: getattr(value, field) for field in type(value).model_fields}
    below = value.values() if isinstance(value, dict) else value if isinstance(value, tuple) else ()
    for one in below:
        yield from filled(one)


def possible(hint: Any) -> Iterator[type[Record]]:
    """All records that a type can hold."""
    if isinstance(hint, type) and issubclass(hint, Record):
        yield hint
        for field in hint.model_fields.values():
            yield from possible(field.annotation)
    for part in get_args(hint):
        yield from possible(part)


def refers(hint: Any) -> bool:
    """Whether a value of this type can be or hold the name of an entry."""
    return any(isinstance(mark, Ref) for mark in getattr(hint, "__metadata__", ())) or any(map(refers, get_args(hint)))


def test_every_field_that_names_entries_is_tried():
    tried = {one for data in MODELS.values() for one in filled(kt.Model(**data))}
    fields = {(one, name): field for one in {*possible(ModelData)} for name, field in one.model_fields.items()}
    asked = {
        (one.__name__, name)
        for (one, name), field in fields.items()
        if refers(field.annotation) or any(isinstance(mark, Ref) for mark in field.metadata)
    }
    assert asked - {(name.replace("Model", "ModelData"), field) for name, field in tried} == set()


def test_the_angle_of_a_beam_is_that_of_its_chord():
    beam = {"nodes": {"A": (0, 0), "B": (1, 0)}, "fixed": ["A"], "gravity": (0, -9.81)}
    beam["beams"] = {"arm": kt.Beam(ends=("A", "B"), kind="rigid", mass=3.0)}
    with pytest.raises(kt.ModelError, match=r"'arm' is a beam: name the line between its ends, 'arm\.chord'"):
        kt.Model(**beam, drives={"turn": kt.AngleDrive("arm")})
    model = kt.Model(**beam, drives={"turn": kt.AngleDrive("arm.chord")})
    motion = kt.kinematics.follow(model, kt.Quintic(moves={"turn": (0, 1)}, duration=1.0), samples=3)
    assert kt.dynamics.inverse(model, motion).drive_force[0].item() == pytest.approx(3.0 * 9.81 / 2)
