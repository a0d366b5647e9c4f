"""Random structures of bars of every kind, drives, couplings and loads: webs in the plane and in space."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

import kinetruss as kt

STEEL = kt.library.materials.STEEL_S235
AXES = "xyz"
Dice = np.random.Generator


@dataclass
class Draft:
    """A model that grows: places of nodes (n, dim) and the fields of the model by name. rows : conditions it may still take."""

    dice: Dice
    dim: int
    size: float
    places: dict[str, np.ndarray] = field(default_factory=dict)
    fields: dict[str, Any] = field(default_factory=dict)
    rows: int = 0

    def of(self, name: str) -> dict[str, Any]:
        """A table of the model."""
        found: dict[str, Any] = self.fields.setdefault(name, {})
        return found

    def chance(self, share: float) -> bool:
        """True in this share of all cases."""
        return bool(self.dice.random() < share)

    def between(self, low: float, high: float) -> float:
        """A number between two."""
        return float(self.dice.uniform(low, high))

    def pick(self, options: Any, count: int = 1) -> list[Any]:
        """Some of the options, each at most once, in random order."""
        options = list(options)
        return [options[k] for k in self.dice.permutation(len(options))[:count]]

    def vector(self, size: float) -> tuple[float, ...]:
        """A random vector."""
        return tuple(map(float, size * self.dice.normal(size=self.dim)))

    def length(self, one: str, two: str) -> float:
        """Distance of two nodes, m."""
        return float(np.linalg.norm(self.places[two] - self.places[one]))

    def model(self) -> kt.Model:
        """The model as far as it has grown."""
        masses, own = self.of("masses"), self.of("own")
        nodes = {
            name: kt.Node(at=tuple(map(float, at)), mass=masses.get(name, 0.0), gravity=own.get(name))
            for name, at in self.places.items()
        }
        rest = {name: value for name, value in self.fields.items() if name not in ("masses", "own", "scalars") and value}
        return kt.Model(nodes=nodes | self.of("scalars"), **rest)


def scattered(dice: Dice, dim: int, count: int) -> Draft:
    """Nodes apart from each other, the first ones held, others in some axes; lumps, some with a gravity of their own."""
    draft = Draft(dice, dim, float(10.0 ** dice.uniform(-1, 1)))
    while len(draft.places) < count:
        at = dice.uniform(-1, 1, dim) * (1.0, 1.0, 0.8)[:dim]
        if all(np.linalg.norm(at - other) > 0.3 for other in draft.places.values()):
            draft.places[f"N{len(draft.places)}"] = at
        elif draft.chance(0.02):
            draft.places = {name: 1.2 * place for name, place in draft.places.items()}
    draft.places = {name: draft.size * at for name, at in draft.places.items()}
    names = list(draft.places)
    draft.fields["fixed"] = dict.fromkeys(names[:dim], AXES[:dim])
    for name in names[dim:]:
        if draft.chance(0.15):
            draft.fields["fixed"][name] = "".join(sorted(draft.pick(AXES[:dim])))
    for name in names[dim:]:
        draft.of("masses")[name] = draft.between(0.2, 2.0)
    for name in draft.pick(names[dim:], 1) if draft.chance(0.4) else []:
        draft.of("own")[name] = draft.vector(5.0)
    if draft.chance(0.85):
        draft.fields["gravity"] = draft.vector(6.0)
    draft.fields |= {"section": kt.Tube(outer=0.02, inner=0.015), "material": STEEL}
    held = sum(map(len, draft.fields["fixed"].values()))
    draft.rows = dim * count - held
    return draft


def add_bars(draft: Draft, per_node: float = 2.0) -> None:
    """Bars between near nodes; rigid and driven ones only while conditions are left to take."""
    names, made = list(draft.places), set[frozenset[str]]()
    held = [name for name in names if len(draft.fields["fixed"].get(name, "")) == draft.dim]
    wanted = int(per_node * len(names))
    for _ in range(10 * wanted):
        if len(made) >= wanted:
            break
        one = draft.pick(names)[0]
        near = sorted((draft.length(one, two), two) for two in names if two != one)[:5]
        two = draft.pick(near)[0][1]
        if frozenset((one, two)) in made or (one in held and two in held):
            continue
        made.add(frozenset((one, two)))
        _add_bar(draft, f"b{len(made)}", one, two)


def _add_bar(draft: Draft, name: str, one: str, two: str) -> None:
    kinds = ["elastic", "elastic", "cable", "cable", "free"]
    if draft.rows > 1:
        kinds += ["rigid", "rigid", "rigid", "driven", "active"]
    kind = draft.pick(kinds)[0]
    draft.rows -= kind in ("rigid", "driven", "active")
    if kind == "active":
        draft.of("active")[name] = active(draft, one, two)
    else:
        draft.of("bars")[name] = kt.Bar(ends=(one, two), kind=kind, **weight(draft), **law(draft, kind, one, two))


def weight(draft: Draft) -> dict[str, Any]:
    """Mass by number, by section and material, or none; some with rotary inertia."""
    way = draft.dice.integers(4)
    if way == 0:
        return {"mass": draft.between(0.1, 2.0)}
    if way == 1:
        section = draft.pick([kt.Rod(diameter=0.03), kt.Rectangle(width=0.02, height=0.05), kt.Tube(outer=0.05, inner=0.04)])[0]
        round_ = draft.dim == 2 or not isinstance(section, kt.Rectangle)
        return {"section": section, "material": STEEL, "rotary_inertia": round_ and draft.chance(0.5)}
    if way == 2:
        return {"mass": draft.between(0.1, 2.0), "section": kt.Rod(diameter=0.1), "rotary_inertia": True}
    return {"mass": 0.0}


def law(draft: Draft, kind: str, one: str, two: str) -> dict[str, Any]:
    """What a bar of this kind pulls with, or the length it is held at."""
    length = draft.length(one, two)
    if kind in ("rigid", "driven"):
        return {"length": length * draft.between(0.98, 1.02)} if draft.chance(0.3) else {}
    found: dict[str, Any] = {"damping": draft.between(0.1, 5.0)} if draft.chance(0.5) else {}
    if kind == "free":
        return found
    stiff = draft.between(50.0, 5000.0)
    if kind == "elastic" and draft.chance(0.5):
        found["strain"] = "green"
    if draft.chance(0.75):
        found["stiffness"] = stiff
        if draft.chance(0.7):
            found["natural_length"] = length * draft.between(0.8, 1.25)
        else:
            found["pretension"] = draft.between(0.02, 0.2) * stiff * length
    elif draft.chance(0.5):
        found["pretension"] = draft.between(100.0, 2000.0)
    return found


def active(draft: Draft, one: str, two: str, **more: Any) -> kt.Active:
    """An active member of two rods."""
    length = draft.length(one, two)
    rods = {
        name: kt.Part(length=length * draft.between(0.5, 0.8), rotary_inertia=draft.chance(0.5), section=kt.Rod(diameter=0.04),
                      material=STEEL, mass=draft.between(0.2, 2.0) if draft.chance(0.6) else None)
        for name in ("base", "tube")
    }  # fmt: skip
    start = {"length": length * draft.between(0.98, 1.02)} if draft.chance(0.3) else {}
    return kt.Active(ends=(one, two), **rods, **start, **more)


def add_planar_bodies(draft: Draft) -> None:
    """Some rigid bars of the plane become whole bodies."""
    for name, bar in draft.of("bars").items():
        if bar.kind == "rigid" and draft.chance(0.35):
            l = draft.length(*bar.ends)
            centre = (l * draft.between(-0.2, 1.2), l * draft.between(-0.5, 0.5))
            body = kt.PlanarBody(mass=draft.between(0.5, 3), center=centre, inertia=l * l * draft.between(0.01, 1.0))
            draft.of("bars")[name] = kt.Bar(ends=bar.ends, body=body, length=bar.length)


def add_drives(draft: Draft) -> None:
    """Drives of lengths, angles, hinges and coordinates, as far as conditions are left."""
    bars = list(draft.of("bars"))
    for kind in draft.pick(["length", "angle", "hinge", "coordinate"], 3):
        if draft.rows < 3:
            return
        if kind == "length" and (rigid := [name for name in bars if draft.of("bars")[name].kind == "rigid"]):
            name = draft.pick(rigid)[0]
            if draft.of("bars")[name].body is None:
                draft.of("drives")["stretch"] = kt.LengthDrive(name)
        elif kind == "coordinate":
            node, axis = free_coordinate(draft)
            draft.of("drives")["slide"] = kt.CoordinateDrive(node=node, axis=axis)
            draft.rows -= 1
        elif kind in ("angle", "hinge"):
            draft.of("drives")[kind] = angle(draft) if kind == "angle" else hinge(draft)
            draft.rows -= 1


def free_coordinate(draft: Draft) -> tuple[str, Any]:
    """A node and an axis that no support holds."""
    fixed = draft.fields["fixed"]
    return draft.pick((name, axis) for name in draft.places for axis in AXES[: draft.dim] if axis not in fixed.get(name, ""))[0]


def angle(draft: Draft) -> kt.AngleDrive:
    """The angle of a bar, in space about any axis."""
    bar = draft.pick([*draft.of("bars"), *draft.of("active")])[0]
    if draft.dim == 2:
        return kt.AngleDrive(bar)
    reference = {"reference": draft.vector(1.0)} if draft.chance(0.5) else {}
    return kt.AngleDrive(bar, axis=draft.pick(["x", "y", "z", draft.vector(1.0)])[0], **reference)


def hinge(draft: Draft) -> kt.HingeDrive:
    """The angle between two half-planes, or between two directions of the plane."""
    *line, start, end = draft.pick(draft.places, draft.dim + 1)
    return kt.HingeDrive(axis=tuple(line), start=start, end=end)


def add_couplings(draft: Draft) -> None:
    """Sums of one to three coordinates of all kinds; some at a value."""
    if draft.chance(0.2):
        at = (draft.between(-1.0, 1.0), *[0.0] * (draft.dim - 1))
        draft.of("scalars")["counter"] = kt.Node(at=at, scalar=True, mass=draft.between(0.1, 1.0))
    for k in range(int(draft.dice.integers(1, 4))):
        if draft.rows < 3:
            return
        kinds = draft.pick(["length", "angle", "hinge", "coordinate", *(["offset"] if draft.dim == 2 else [])], 2 + k)
        terms = [(_measured(draft, kind), float(draft.pick([1, -1, 2, -3, 0.5])[0])) for kind in kinds]
        if k == 1 and draft.chance(0.5):
            about: dict[str, Any] = {} if draft.dim == 2 else {"axis": "z"}
            terms = [(kt.AngleDrive(bar, **about), 1.0) for bar in draft.pick(draft.of("bars"), 2)]
        value = {"value": draft.between(-1.0, 1.0)} if draft.chance(0.3) else {}
        draft.of("couplings")[f"sum{k}"] = kt.Coupling(terms=tuple(terms[: 1 + int(draft.dice.integers(3))]), **value)
        draft.rows -= 1


def _measured(draft: Draft, kind: str) -> Any:
    if kind == "length":
        return kt.LengthDrive(draft.pick([*draft.of("bars"), *draft.of("active")])[0])
    if kind == "coordinate":
        node, axis = ("counter", "x") if "counter" in draft.of("scalars") else free_coordinate(draft)
        return kt.CoordinateDrive(node=node, axis=axis)
    if kind == "offset":
        one, two, point = draft.pick(draft.places, 3)
        return kt.model.OffsetCoordinate(line=(one, two), point=point)
    return angle(draft) if kind == "angle" else hinge(draft)


def add_loads(draft: Draft) -> None:
    """Constant forces and tables, a load case with factors, a support that moves."""
    loose = [name for name in draft.places if len(draft.fields["fixed"].get(name, "")) < draft.dim]
    draft.of("loads")["push"] = kt.NodalForce(node=draft.pick(loose)[0], force=draft.vector(50.0))
    rows = tuple(draft.vector(40.0) for _ in range(3))
    draft.of("loads")["gust"] = kt.NodalForce(node=draft.pick(loose)[0], times=(0.0, draft.between(0.2, 0.5), 0.8), forces=rows)
    if draft.chance(0.5):
        case = {name: draft.between(-2.0, 2.0) for name in draft.pick(draft.of("loads"), 1 + int(draft.dice.integers(2)))}
        gravity = draft.vector(4.0) if draft.chance(0.5) else None
        draft.of("load_cases")["case"] = kt.LoadCase(loads=case if draft.chance(0.8) else None, gravity=gravity)
    if draft.chance(0.3):
        times = tuple(np.linspace(0.0, 1.0, 8).tolist())
        way = np.array(draft.vector(0.02 * draft.size))
        moved = tuple(tuple((np.sin(4 * t) * way).tolist()) for t in times)
        node = draft.pick(name for name, axes in draft.fields["fixed"].items() if len(axes) == draft.dim)[0]
        draft.of("support_motion")[node] = kt.History(times=times, displacements=moved)


def web(dice: Dice, dim: int, count: int | None = None) -> Draft:
    """A web of 5 to 11 nodes (or as many as asked) with all that bars, drives and loads can be."""
    count = count or int(dice.integers(dim + 3, 12))
    draft = scattered(dice, dim, count)
    kept = int(dice.integers(1, 8))  # conditions for drives and couplings
    draft.rows -= kept
    add_bars(draft)
    draft.rows += kept
    if dim == 2:
        add_planar_bodies(draft)
    add_drives(draft)
    add_couplings(draft)
    add_loads(draft)
    return draft


def planar_web(dice: Dice) -> kt.Model:
    """A web in the plane."""
    return web(dice, 2).model()


def spatial_web(dice: Dice) -> kt.Model:
    """A web in space."""
    return web(dice, 3).model()


def large_web(dice: Dice) -> kt.Model:
    """A web of many nodes, of which most are held by springs only."""
    return web(dice, int(dice.integers(2, 4)), int(dice.integers(25, 45))).model()


def braced(dice: Dice) -> kt.Model:
    """More rigid bars than freedoms in one part: redundant conditions, with and without sections."""
    dim = int(dice.integers(2, 4))
    draft = scattered(dice, dim, dim + 3)
    draft.fields["fixed"] = dict.fromkeys(list(draft.places)[:dim], AXES[:dim])
    names, sized = list(draft.places), draft.chance(0.5)
    for k, one in enumerate(names[dim:-1], start=dim):
        for two in names[:k]:
            mass = {} if sized else {"mass": draft.between(0.1, 1.0)}
            draft.of("bars")[f"{one}{two}"] = kt.Bar(ends=(one, two), **mass)
    last = names[-1]
    draft.of("bars")["swing"] = kt.Bar(ends=(names[-2], last), mass=0.4)
    draft.of("bars")["spring"] = kt.Bar(ends=(names[0], last), kind="elastic", stiffness=90.0, damping=0.5)
    if not sized:
        draft.fields |= {"section": None, "material": None}
    add_loads(draft)
    return draft.model()


def carried(dice: Dice) -> kt.Model:
    """A braced quadrilateral, its bars of different sections, on a crank and a link: driven, and one bar more than it needs."""
    at = {"O": (0, 0), "A": (0.5, 0.4), "B": (1.3, 0.3), "C": (1.4, 1.1), "D": (0.4, 1.2), "G": (2.0, -0.6)}
    nodes = {name: tuple(float(x + 0.05 * dice.normal()) for x in place) for name, place in at.items()}
    bars = {one + two: kt.Bar(ends=(one, two), section=kt.Rod(diameter=float(dice.uniform(0.01, 0.05))), material=STEEL)
            for one, two in ("OA", "AB", "BC", "CD", "DA", "AC", "BD", "BG")}  # fmt: skip
    push = kt.NodalForce(node="C", force=tuple(map(float, 50 * dice.normal(size=2))))
    return kt.Model(nodes=nodes, fixed=("O", "G"), bars=bars, drives={"motor": kt.AngleDrive("OA")}, gravity=(0, -9.81),
                    loads={"push": push})  # fmt: skip
