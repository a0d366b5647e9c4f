"""A model compiled to flat arrays."""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from kinetruss.elements.beams import BeamElements
from kinetruss.elements.caching import OF_RECORDS
from kinetruss.elements.continua_arrays import Continua
from kinetruss.elements.numbers import sums_at
from kinetruss.errors import InputError, shown
from kinetruss.kernels.structure.structure import ANGLE
from kinetruss.mechanics.gathered import arrays_at, gathered
from kinetruss.model import Inner, Model, WholeModel

if TYPE_CHECKING:
    from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True, eq=False)
class System:
    """Arrays of a model. All vectors have three components; planar models keep z = 0. Coordinates are flat: 3 node + axis.

    model : the whole, with inner parts behind those of the user, in `nodes` and `members` too; given : the user's.
    x0 (n, 3) positions, m; p, q (m,) end nodes; kind (m,); length0 (m,) prescribed or present length, m;
    two_rods (m,) active members; rods (m, 6): mass, length, rotary inertia of a uniform bar (then zeros), or of base and
    tube, each the uniform rod with the same moments as that with its masses; own_rods (m, 6): likewise, without the masses, and
    clamped (c, 3) these: 2 member for one on its base, 2 member + 1 on its tube; fraction from the end towards A; kg;
    law (m,) NONE, ENGINEERING, GREEN or CABLE (kernels.structure.structure), with spring (m,) k, N/m, else 0, natural (m,) l0,
    m, and damping (m,) c, N s/m; friction (m, 2) of the bearings at its ends, N m s; compliance (m,) 1/(E A), or 1/(k l0), 1/N,
    NaN unknown, and yielding (m,) m/N, which adds to compliance times length; area (m,) of bars, m^2, NaN of other members;
    is_body (m,) bars that stand for a planar body (their rods are zero), body (m, 4): mass, e, f, central inertia;
    pair_p, pair_q (k,) nodes, pair_mass (k,), pair_skew (k,) kg: mass of bodies, m times the unit matrix between two nodes
    (p == q: at one), plus the skew part of a planar body about z; thin (n,) nodes of bodies whose own mass is singular;
    lump (n,) kg; own_gravity (n, 3) NaN where a mass has none of its own; gravity (3,) m/s^2;
    velocity0 (n, 3) velocities given for the start of a simulation, m/s.
    row_* : prescribed lengths, angles and sums; row_member (of a sum any), row_kind, row_drive (-1 none), row_value,
    row_measure (-1 none).
    Measures (kernels.structure.terms), of drives first, then of couplings, then of elements: measures (k,) names, measure_ptr
    (k + 1,) their terms, term_kind (t,), term_at (t, 4), term_data (t, 7); measure_scale (k,) that gives gradients the size of
    those of lengths,
    measure_period (k,) after which values are the same (0: never), measure_start (k,); drive_measure (drives,) or -1.
    Elements on coordinates (kinetruss.elements): force_elements (s,) names, force_element_measure (s,). element_numbers as
    "spring stiffness" of all of a kind, NaN what is not given; load_numbers as "load NAME force", "case NAME gravity" and "body
    NAME center".
    prescribed (3 n,) mask; coordinate_drive (k, 2): flat coordinate, drive. supports: nodes with a fixed axis.
    continua : membranes, solids and elastic beams, or None. loaded : all beams on which loads along them act, where rows hold
    some (beam_shapes.rigid_links), which are none of `continua` then.
    """

    given: Model
    model: WholeModel
    dim: int
    nodes: tuple[str, ...]
    members: tuple[str, ...]
    drives: tuple[str, ...]
    supports: tuple[str, ...]
    x0: NDArray[np.float64]
    p: NDArray[np.int32]
    q: NDArray[np.int32]
    kind: NDArray[np.int8]
    length0: NDArray[np.float64]
    two_rods: NDArray[np.bool_]
    rods: NDArray[np.float64]
    own_rods: NDArray[np.float64]
    clamped: NDArray[np.float64]
    law: NDArray[np.int8]
    spring: NDArray[np.float64]
    natural: NDArray[np.float64]
    damping: NDArray[np.float64]
    friction: NDArray[np.float64]
    compliance: NDArray[np.float64]
    area: NDArray[np.float64]
    yielding: NDArray[np.float64]
    body: NDArray[np.float64]
    is_body: NDArray[np.bool_]
    pair_p: NDArray[np.int32]
    pair_q: NDArray[np.int32]
    pair_mass: NDArray[np.float64]
    pair_skew: NDArray[np.float64]
    thin: NDArray[np.bool_]
    lump: NDArray[np.float64]
    own_gravity: NDArray[np.float64]
    gravity: NDArray[np.float64]
    velocity0: NDArray[np.float64]
    row_member: NDArray[np.int32]
    row_kind: NDArray[np.int8]
    row_drive: NDArray[np.int32]
    row_value: NDArray[np.float64]
    row_measure: NDArray[np.int64]
    measures: tuple[str, ...]
    measure_ptr: NDArray[np.int64]
    term_kind: NDArray[np.int64]
    term_at: NDArray[np.int64]
    term_data: NDArray[np.float64]
    measure_scale: NDArray[np.float64]
    measure_period: NDArray[np.float64]
    measure_start: NDArray[np.float64]
    drive_measure: NDArray[np.int64]
    force_elements: tuple[str, ...]
    force_element_measure: NDArray[np.int64]
    element_numbers: dict[str, NDArray[np.float64]]
    load_numbers: dict[str, NDArray[np.float64]]
    prescribed: NDArray[np.bool_]
    coordinate_drive: NDArray[np.int32]
    drive_start: NDArray[np.float64]
    continua: Continua | None = None
    loaded: BeamElements | None = None

    @cached_property
    def memory(self) -> dict[Any, Any]:
        """What `kept` keeps."""
        return {}

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items() if name != "memory"}

    @property
    def free(self) -> NDArray[np.int64]:
        """Flat indices of the free coordinates."""
        return np.flatnonzero(~self.prescribed)

    @property
    def bodies(self) -> NDArray[np.int64]:
        """Indices of the members that stand for a planar body."""
        return np.flatnonzero(self.is_body)

    @cached_property
    def node_mass(self) -> NDArray[np.float64]:
        """Lumped masses plus the mass of bodies at single nodes, (n,) kg."""
        own = self.pair_p == self.pair_q
        return self.lump + sums_at(self.pair_p[own], self.pair_mass[..., own], self.lump.shape[-1])

    @cached_property
    def force_element_spans(self) -> dict[str, slice]:
        """Where the elements of each kind stand in `force_elements`."""
        kinds = [kind for kind, _ in self.model.force_elements.values()]
        return {kind: slice(kinds.index(kind), kinds.index(kind) + kinds.count(kind)) for kind in dict.fromkeys(kinds)}

    @property
    def term_form(self) -> NDArray[np.int64]:
        """Addresses of the code of the terms (t, 3), compiled when first asked for; of this process, so kept in `memory`."""
        if "term_form" not in self.memory:
            from kinetruss.kernels.coordinates.straight_line import addresses_of

            self.memory["term_form"] = addresses_of(self.term_kind)
        return cast("NDArray[np.int64]", self.memory["term_form"])

    @cached_property
    def sums(self) -> NDArray[np.int64]:
        """Indices of the rows that hold a sum of terms."""
        return np.flatnonzero(self.row_measure >= 0)

    def numbers(self, kind: str, *names: str) -> NDArray[Any]:
        """Numbers (k, w) of the elements of a kind, by the fields of their records; NaN those that are not given."""
        none = np.zeros((*self.x0.shape[:-2], 0), self.x0.dtype)
        return np.stack([self.element_numbers.get(f"{kind} {name}", none) for name in names], axis=-1)

    def with_rows(self, rows: Any, **changes: Any) -> System:
        """The system with these of its rows (indices or a mask), in their order."""
        names = ("row_member", "row_kind", "row_drive", "row_value", "row_measure")
        return replace(self, **({name: getattr(self, name)[rows] for name in names} | changes))

    @property
    def inner(self) -> Inner:
        """The inner parts of the model."""
        return self.model.inner

    def row_name(self, r: Any) -> str:
        """The name of what row r prescribes: a member, ``angle of`` one, a drive or a coupling."""
        return f"angle of {self._held[r]}" if self._turns(r) else self._held[r]

    def part_of(self, r: Any) -> str:
        """The same, of an inner part its owner."""
        part = self.inner.part_of(self._held[r])
        return f"angle of {part}" if self._turns(r) and part == self._held[r] else part

    def parts_of(self, rows: Any) -> list[str]:
        """The user's parts to which some rows belong, each once."""
        return list(dict.fromkeys(map(self.inner.part_of, map(self._held.__getitem__, rows))))

    @cached_property
    def _held(self) -> list[str]:
        """The member, drive or coupling of every row."""
        rows = zip(self.row_member.tolist(), self.row_measure.tolist(), strict=True)
        return [self.members[i] if m < 0 else self.measures[m] for i, m in rows]

    def _turns(self, r: Any) -> bool:
        return bool(self.row_measure[r] < 0 and self.row_kind[r] == ANGLE)

    @cached_property
    def row_names(self) -> tuple[str, ...]:
        """`row_name` of all rows."""
        plain = (self.row_measure < 0) & (self.row_kind != ANGLE)
        if plain.all():
            return tuple(self._held)
        return tuple(self.row_name(r) for r in range(len(plain)))

    def node_index(self, name: str) -> int:
        """Index of a node by name."""
        return self._places[name]

    @cached_property
    def _places(self) -> dict[str, int]:
        return {name: i for i, name in enumerate(self.nodes)}


def compile(model: Model) -> System:
    """Compile a model to arrays; the same model gives the same System.

    Raises
    ------
    InputError : something else than a model.
    """
    if not isinstance(model, Model):
        raise InputError(f"A model is expected first, not {_called(model)}. {_GIVE_A_MODEL}")
    key = ByIdentity(model)
    return _instead[key] if key in _instead else _compiled(key)


_GIVE_A_MODEL = 'Give a kt.Model, or kt.read("model.yaml").'


def _called(other: object) -> str:
    return shown(other) if isinstance(other, (str, Path)) else f"a {type(other).__name__}"


class ByIdentity:
    """A model or another record as a key of caches: equal to itself only, so that nothing is compared field by field."""

    def __init__(self, model: Any) -> None:
        self.model = model

    def __hash__(self) -> int:
        return id(self.model)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ByIdentity) and self.model is other.model


_instead: dict[ByIdentity, System] = {}
"""Systems of models of which only the arrays have other numbers."""


def standing_for(system: System) -> Model:
    """A copy of the model of a system with other numbers (`numbers.system_at`), which compiles to that system.

    Its records have the numbers of before: only for what reads the arrays alone. The last few are kept.
    """
    model = copy(system.given)
    compiles_to(replace(system, given=model), compile(system.given))
    return model


def compiles_to(found: System, other: System) -> None:
    """Let the model of a system compile to it. other : that of a model with the same records, but for places of nodes."""
    _instead[ByIdentity(found.given)] = _sealed(found)
    found.memory.update({find: other.memory[find] for find in OF_RECORDS if find in other.memory})
    for oldest in list(_instead)[:-8]:
        _instead.pop(oldest, None)


@lru_cache(maxsize=32)
def _compiled(key: ByIdentity) -> System:
    given, model = key.model, key.model.whole
    return _sealed(
        System(
            given=given,
            model=model,
            dim=model.dim,
            nodes=tuple(model.nodes),
            members=tuple(model.members),
            drives=tuple(model.all_drives),
            **arrays_at(*gathered(model)),
        )
    )


def _sealed(system: System) -> System:
    """The system, whose arrays cannot be written to any more."""
    for value in vars(system).values():
        if isinstance(value, np.ndarray):
            value.setflags(write=False)
    return system
