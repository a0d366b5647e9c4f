"""Strain and stress in the elements of membranes and solids, and on their faces."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import numpy as np
import xarray as xr

from kinetruss.arrays import Shape, array_of
from kinetruss.elements.continua_arrays import TRIANGLES
from kinetruss.errors import InputError
from kinetruss.mechanics import Patch, System, compile, element_points, gradients, law_matrix
from kinetruss.model import Material, Model, nearest
from kinetruss.results import Result, variable

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from kinetruss.elements.continua_arrays import Skin
    from kinetruss.mechanics import Continua


_PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))


def elements(model: Model, result: Result | ArrayLike, part: str) -> xr.Dataset:
    """Strain and stress in the elements of one membrane or solid.

    Parameters
    ----------
    result : anything with positions or displacements (a motion, a simulation, an equilibrium, `statics.linear`), or positions
        (n_nodes, dim) or (times, n_nodes, dim), m. part : name of the membrane or solid.

    Returns
    -------
    Dataset over (time,) element, and point where an element has several: the four triangles of a six-node triangle, or its six
    points of integration where its strain is linear. Along material axes (11, 22, 12, or 11, 22, 33, 23, 13, 12): ``strain``,
    Green's, and ``stress``, second Piola-Kirchhoff, Pa. ``true_stress``, Cauchy's, Pa, along x, y, z; ``principal`` true
    stresses, greatest first, and ``von_mises``, Pa, of these. ``volume``, m^3, and ``energy``, J, of the element.

    Raises
    ------
    InputError : no such part, positions of another model, a result without positions.

    Notes
    -----
    E = (F^T F - 1)/2, S = C E, sigma = F S F^T/det F. Of membranes under plane stress, F takes the change of thickness from E33
    of the same law (an orthotropic one without nu13 and nu23 keeps its thickness). For small strains all measures agree.

    >>> import kinetruss as kt
    >>> plate = kt.library.meshes.rectangle(width=2.0, height=1.0, columns=2, rows=1)
    >>> model = kt.Model(nodes=plate.nodes, material=kt.Material(E=100e9, density=0.0),
    ...                  membranes={"plate": plate.membrane(thickness=0.01)})
    >>> found = kt.strength.elements(model, plate.points * (1 + 1e-6), "plate")
    >>> round(float(found.von_mises.max()) / 1e3)   # kPa: E e/(1 - nu)
    143
    """
    if part not in {**model.membranes, **model.solids}:
        known = [*model.membranes, *model.solids]
        raise InputError(f"No membrane or solid called {part!r}. {nearest(part, known)}".rstrip())
    system = compile(model)
    x, timed = positions_of(system, result)
    patch = next(one for one in cast("Continua", system.continua).patches if one.name == part)
    record: Any = {**model.membranes, **model.solids}[part]
    count = len(record.elements)
    points = element_points(patch, patch.nodes, system.x0)
    gradient, volume, _ = gradients(points)
    found = [_sample(model, record, patch, gradient, one) for one in x]
    values = {name: np.stack([one[name] for one in found]) for name in found[0]}
    values["energy"] = values["energy"] * volume * patch.thickness
    values["volume"] = np.broadcast_to(volume * patch.thickness, values["energy"].shape)
    per = -1 if len(patch.nodes) == count else len(patch.nodes) // count
    return _dataset(values, timed, result, count, max(per, 1) * volume.shape[1], points.shape[2], system.dim)


def positions_of(system: System, result: Any) -> tuple[NDArray[np.float64], bool]:
    """Positions (times, n, 3), and whether there is a time axis."""
    if isinstance(result, Result):
        motion = getattr(result, "motion", None)
        data = result.whole if motion is None else motion.whole
        if "position" in data:
            given = data["position"].values
        elif "displacement" in data and "size" not in data:
            given = data["displacement"].values + system.x0[:, : system.dim]
        else:
            raise InputError(f"{type(result).__name__} has no positions. Give a motion, an equilibrium, or positions.")
    else:
        given = result
    shape: Shape = {"n_nodes": system.nodes, "dim": system.dim}
    given = array_of(given, "positions", shape, {"times": None, **shape}, unit="m")
    timed = given.ndim == 3
    full = np.zeros((*(given.shape[:-1] if timed else (1, given.shape[0])), 3))
    full[..., : system.dim] = given if timed else given[None]
    return full, timed


def _sample(
    model: Model, record: Any, patch: Patch, gradient: NDArray[np.float64], x: NDArray[np.float64]
) -> dict[str, NDArray[np.float64]]:
    """Measures (k, g, ...) at positions x (n, 3)."""
    # deformation gradient F = sum of x_v dN_v, Green strain E = (F^T F - 1)/2
    F = np.einsum("kvi,kgvs->kgis", x[patch.nodes] - x[patch.nodes[:, :1]], gradient)
    dim = gradient.shape[3]
    green = 0.5 * (np.einsum("kgis,kgit->kgst", F, F) - np.eye(dim))
    pairs = [(0, 0), (1, 1), (0, 1)] if dim == 2 else list(_PAIRS)
    factor = np.array([1.0 if a == b else 2.0 for a, b in pairs])
    strain = np.stack([green[..., a, b] for a, b in pairs], axis=-1)
    # second Piola-Kirchhoff stress S = C E, shears of E doubled
    stress = (strain * factor) @ patch.C
    S = np.zeros((*F.shape[:2], 3, 3))
    for value, (a, b) in zip(np.moveaxis(stress, -1, 0), pairs, strict=True):
        S[..., a, b] = S[..., b, a] = value
    if dim == 2:
        # a membrane: third column of F is its normal times the stretch of its thickness
        across, S[..., 2, 2] = _across(model, record, strain * factor, stress)
        normal = np.cross(F[..., 0], F[..., 1])
        area = np.linalg.norm(normal, axis=-1, keepdims=True)
        F = np.concatenate([F, (normal / area * across[..., None])[..., None]], axis=-1)
    # Cauchy stress F S F^T/det F
    true = F @ S @ F.swapaxes(-1, -2) / np.linalg.det(F)[..., None, None]
    trace = np.trace(true, axis1=-2, axis2=-1)
    apart = true - trace[..., None, None] / 3 * np.eye(3)
    return {
        "strain": strain,
        "stress": stress,
        "true_stress": np.stack([true[..., a, b] for a, b in _PAIRS], axis=-1),
        "principal": np.linalg.eigvalsh(true)[..., ::-1],
        "von_mises": np.sqrt(1.5 * np.sum(apart**2, axis=(-2, -1))),
        "energy": 0.5 * np.sum(strain * factor * stress, axis=-1),
    }


def _across(
    model: Model, record: Any, strain: NDArray[np.float64], stress: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Stretch of the thickness, and stress across it (plane strain), Pa."""
    material: Any = record.orthotropic or model.material_of(record)
    none = np.zeros(strain.shape[:-1])
    if record.plane == "strain":
        C = law_matrix(material, "solid")
        return none + 1.0, C[2, 0] * strain[..., 0] + C[2, 1] * strain[..., 1]
    if isinstance(material, Material):
        thinner = -material.poisson / material.E * (stress[..., 0] + stress[..., 1])
    elif material.nu13 is not None and material.nu23 is not None:
        thinner = -material.nu13 / material.E1 * stress[..., 0] - material.nu23 / material.E2 * stress[..., 1]
    else:
        thinner = none
    return np.sqrt(np.maximum(1 + 2 * thinner, 1e-12)), none


def _dataset(
    values: dict[str, NDArray[np.float64]], timed: bool, result: Any, count: int, points: int, inside: int, dim: int
) -> xr.Dataset:
    """Named axes; without those that have one entry only."""
    own = ["11", "22", "12"] if inside == 2 else ["11", "22", "33", "23", "13", "12"]
    words = {
        "strain": ("component", "", "Green's strain, material axes"),
        "stress": ("component", "Pa", "second Piola-Kirchhoff stress, material axes"),
        "true_stress": ("true_component", "Pa", "Cauchy's stress, x, y, z"),
        "principal": ("rank", "Pa", "principal true stresses"),
        "von_mises": ("", "Pa", "von Mises' stress"),
        "energy": ("", "J", "strain energy"),
        "volume": ("", "m^3", "volume without strain"),
    }
    axes = [*(["time"] if timed else []), "element", *(["point"] if points > 1 else [])]
    data = {}
    for name, (last, unit, text) in words.items():
        array = values[name].reshape(len(values[name]), count, points, *values[name].shape[3:])
        array = array[:, :, 0] if points == 1 else array
        data[name] = variable((*axes, *([last] if last else [])), array if timed else array[0], unit, text)
    coords: dict[str, Any] = {"element": np.arange(count), "component": own, "rank": [1, 2, 3]}
    coords["true_component"] = ["xx", "yy", "zz", "yz", "xz", "xy"]
    if timed and isinstance(result, Result):
        source = getattr(result, "motion", None) or result
        coords["time"] = source.whole["time"].values
    return xr.Dataset(data, coords=coords, attrs={"kind": "elements", "axes": dim})


# Stress in the elements of the faces of membranes and solids, for pictures.

MOST = 600_000
"""Largest number of elements times samples for which stress is computed."""


def skin_stress(model: Model, skin: Skin, position: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Von Mises stress (times, f), Pa, of the element of each face; None if it would take long.

    position : (times, n_nodes, dim), m. Of elements with linear strain: the largest at their points of integration.
    """
    records: dict[str, Any] = {**model.membranes, **model.solids}
    if not len(skin.nodes) or len(position) * sum(len(one.elements) for one in records.values()) > MOST:
        return None
    found = np.zeros((len(position), len(skin.nodes)))
    for k, name in enumerate(skin.names):
        values = elements(model, position, name)["von_mises"].values
        here = skin.part == k
        if values.ndim == 3 and values.shape[2] == len(TRIANGLES[6]):
            found[:, here] = values[:, skin.element[here], skin.corner[here]]
        else:
            found[:, here] = values.reshape(*values.shape[:2], -1).max(axis=2)[:, skin.element[here]]
    return found
