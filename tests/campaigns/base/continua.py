"""Random bodies, membranes and solids with the loads that act on them, held by bars."""

from __future__ import annotations

from typing import Any

import numpy as np
from webs import AXES, Dice, Draft, add_loads, scattered

import kinetruss as kt

RUBBER = kt.Material(E=1e6, density=1000.0, poisson=0.3)


def _times(draft: Draft, one: str, many: str, value: Any) -> dict[str, Any]:
    """A load as one value, or as a table in time."""
    if draft.chance(0.5):
        return {one: value}
    half = tuple(0.5 * v for v in value) if isinstance(value, tuple) else 0.5 * value
    return {"times": (0.0, 0.3, 0.7), many: (half, value, half)}


def _body(draft: Draft, nodes: tuple[str, ...], carriers: int) -> kt.Body:
    """A body on these nodes, of which the first ones carry it: its mass spread evenly, or with centre and inertia."""
    dice, dim = draft.dice, draft.dim
    fields: dict[str, Any] = {"nodes": nodes, "mass": draft.between(0.5, 4.0), "carriers": nodes[:carriers]}
    if draft.chance(0.25):
        fields["kind"] = "straining"
    if draft.chance(0.3) or (dim == 3 and carriers < 4):
        return kt.Body(**fields)
    centre = np.mean([draft.places[node] for node in nodes[:carriers]], axis=0) + 0.1 * draft.size * dice.normal(size=dim)
    if dim == 2:
        return kt.Body(**fields, center=tuple(centre), inertia=draft.size**2 * draft.between(0.05, 0.5))
    moments = draft.size**2 * fields["mass"] * dice.uniform(0.1, 0.19, 3)
    Q = np.linalg.qr(dice.normal(size=(3, 3)))[0]
    Q = Q * np.sign(np.linalg.det(Q))
    if draft.chance(0.5):
        frame = kt.Frame(origin=tuple(centre), axes=tuple(map(tuple, Q.tolist())))
        return kt.Body(**fields, center=(0.0, 0.0, 0.0), inertia=tuple(moments.tolist()), frame=frame)
    tensor = Q.T @ np.diag(moments) @ Q
    return kt.Body(**fields, center=tuple(centre), inertia=tuple(map(tuple, (0.5 * (tensor + tensor.T)).tolist())))


def _body_loads(draft: Draft, name: str) -> dict[str, Any]:
    """Forces, couples and pressures on a body; they keep their direction or turn with it."""
    body, dim = draft.of("bodies")[name], draft.dim
    carriers = body.carriers or body.nodes
    whole = len(carriers) == dim + 1 or dim == 2
    found: dict[str, Any] = {}
    at = np.mean([draft.places[node] for node in carriers], axis=0)
    rod = dim == 3 and len(carriers) == 2
    for k, follows in enumerate((False, True) if not rod else (False,)):
        place = {"at": tuple(at + 0.1 * draft.size * draft.dice.normal(size=dim))} if whole and k else {"at": tuple(at)}
        force = _times(draft, "force", "forces", draft.vector(30.0))
        found[f"{name}.force{k}"] = kt.model.BodyForce(body=name, follows=follows, **place, **force)
        if not rod:
            moment = draft.between(-20, 20) if dim == 2 else draft.vector(20.0)
            found[f"{name}.couple{k}"] = kt.model.BodyCouple(
                body=name, follows=follows, **_times(draft, "moment", "moments", moment)
            )
    if len(body.nodes) >= dim:
        face, depth = tuple(draft.pick(body.nodes, dim)), {"depth": draft.between(0.1, 2.0)} if dim == 2 else {}
        gas = _times(draft, "pressure", "pressures", draft.between(10.0, 90.0))
        found[f"{name}.gas"] = kt.model.Pressure(face=face, **gas, **depth)
    return found


def bodies(dice: Dice, dim: int, carriers: int) -> kt.Model:
    """Two or three bodies that share nodes or hang on springs, loaded in every way."""
    draft = scattered(dice, dim, dim + 7)
    names = list(draft.places)
    draft.fields["fixed"] = dict.fromkeys(names[:dim], AXES[:dim])
    loose = names[dim:]
    count = max(carriers, 2) + int(dice.integers(0, 2))
    first, second = tuple(loose[:count]), tuple(loose[count - 1 : count - 1 + carriers])
    draft.of("bodies")["one"] = _body(draft, first, carriers)
    draft.of("bodies")["two"] = _body(draft, second, carriers)
    for k, foot in enumerate(names[:dim]):
        tip = draft.pick(sorted({*first, *second}))[0]
        law = {"strain": "green"} if k else {"damping": 0.7}
        draft.of("bars")[f"s{k}"] = kt.Bar(ends=(foot, tip), kind="elastic", stiffness=draft.between(20, 400), mass=0.3, **law)
    for name in ("one", "two"):
        draft.of("loads").update(_body_loads(draft, name))
    if dim == 2:
        draft.of("bars")["link"] = kt.Bar(ends=(names[0], loose[-1]), mass=1.0)
        draft.of("loads")["wind"] = kt.model.BodyForce(body="link", at=(0.1, 0.05), force=draft.vector(9.0), follows=True)
        draft.of("loads")["turn"] = kt.model.BodyCouple(body="link", moment=draft.between(-5, 5))
    add_loads(draft)
    return draft.model()


def planar_bodies(dice: Dice) -> kt.Model:
    """Bodies in the plane, on two or three nodes."""
    return bodies(dice, 2, int(dice.integers(2, 4)))


def spatial_bodies(dice: Dice) -> kt.Model:
    """Bodies in space, on two, three or four nodes."""
    return bodies(dice, 3, int(dice.choice([2, 3, 4, 4, 4])))


def _orthotropic(draft: Draft, spatial: bool) -> kt.model.Orthotropic:
    more = {"E3": 0.5e6, "nu13": 0.2, "nu23": 0.15, "G13": 0.3e6, "G23": 0.2e6} if spatial else {}
    return kt.model.Orthotropic(E1=2e6, E2=draft.between(0.5e6, 1.5e6), nu12=0.2, G12=0.4e6, density=900.0, **more)


def skin(dice: Dice) -> kt.Model:
    """A membrane of any kind, in the plane or bent in space, with bars and a body load on it."""
    dim = int(dice.integers(2, 4))
    draft = Draft(dice, dim, float(10.0 ** dice.uniform(-0.5, 0.5)))
    six = draft.chance(0.6)
    grid = kt.library.meshes.rectangle(
        width=draft.size, height=0.6 * draft.size, columns=2, rows=1 if six else 2, six_nodes=six
    )
    points = grid.points * (1 + 0.05 * dice.normal(size=grid.points.shape))
    if dim == 3:
        points = np.column_stack([points, 0.2 * draft.size * dice.normal(size=len(points))])
    draft.places = dict(zip(grid.names, points, strict=True))
    fields: dict[str, Any] = {"strain": draft.pick(["constant", "linear"])[0]} if six else {}
    fields |= {"plane": draft.pick(["stress", "strain"])[0]} if dim == 2 else {}
    way = draft.vector(1.0)
    if draft.chance(0.4) and fields.get("plane") != "strain":
        fields |= {"orthotropic": _orthotropic(draft, False), "axis": way}
    fields["thickness"] = draft.between(0.005, 0.02)
    draft.of("membranes")["skin"] = grid.membrane(**fields)
    _hung(draft, grid)
    return draft.model()


def block(dice: Dice) -> kt.Model:
    """A solid, isotropic or not, with bars on it."""
    draft = Draft(dice, 3, float(10.0 ** dice.uniform(-0.5, 0.5)))
    grid = kt.library.meshes.box(size=tuple(draft.size * dice.uniform(0.4, 1.0, 3)), cells=(2, 1, 1))
    points = grid.points + 0.03 * draft.size * dice.normal(size=grid.points.shape)
    draft.places = dict(zip(grid.names, points, strict=True))
    if draft.chance(0.5):
        turned = np.linalg.qr(dice.normal(size=(3, 3)))[0]
        axes = (tuple(turned[0].tolist()), tuple(turned[1].tolist()))
        draft.of("solids")["block"] = grid.solid(orthotropic=_orthotropic(draft, True), axes=axes)
    else:
        draft.of("solids")["block"] = grid.solid()
    _hung(draft, grid)
    return draft.model()


def _hung(draft: Draft, grid: Any) -> None:
    """Supports, a spring, a rod in the mesh and loads for a mesh."""
    left, names = list(grid.at(x=0.0)), list(draft.places)
    draft.fields["fixed"] = dict.fromkeys(left, AXES[: draft.dim])
    draft.fields |= {"gravity": draft.vector(5.0), "material": RUBBER}
    tip, other = draft.pick(sorted(set(names) - set(left)), 2)
    draft.places["wall"] = draft.places[tip] + 0.8 * draft.size * np.ones(draft.dim)
    draft.fields["fixed"]["wall"] = AXES[: draft.dim]
    draft.of("bars")["stay"] = kt.Bar(ends=("wall", tip), kind="cable", stiffness=800.0, pretension=20.0, mass=0.2)
    draft.of("bars")["rod"] = kt.Bar(ends=("wall", other), mass=0.4)
    draft.of("masses")[tip] = draft.between(0.1, 1.0)
    face = tuple(draft.pick(sorted(set(names) - set(left)), draft.dim))
    draft.of("loads")["gas"] = kt.model.Pressure(face=face, pressure=draft.between(5.0, 50.0))
    add_loads(draft)
