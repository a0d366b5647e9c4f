"""The Sarrus linkage: two chains of three parallel hinges each, at right angles, allow one straight motion."""

from __future__ import annotations

from typing import Any

import numpy as np

from kinetruss.library._builder import builder
from kinetruss.library._placing import bars_between, places, refuse
from kinetruss.model import CoordinateDrive, Cyclic, Model, PositiveLength, Run

__all__ = ["CHAINS", "SARRUS_BARS", "chain_bars", "sarrus", "sarrus_places"]

CHAINS = (
    (("B", "E"), ("M1", "M2"), ("G", "H"), ("Q1", "Q2")),
    (("B", "F"), ("N1", "N2"), ("G", "K"), ("Q3", "Q4")),
)
"""Hinge edges below, between and above, apexes of the two plates."""


def chain_bars(
    below: tuple[str, str], middle: tuple[str, str], above: tuple[str, str], apexes: tuple[str, str]
) -> list[tuple[str, str]]:
    """Sixteen: the hinge edge in the middle and the one above; of each plate two sides, a diagonal, four spokes."""
    pairs = []
    for low, high, apex in ((below, middle, apexes[0]), (middle, above, apexes[1])):
        pairs += [(low[0], high[0]), (low[1], high[1]), high, (low[0], high[1])]
        pairs += [(apex, node) for node in (*low, *high)]
    return pairs


SARRUS_BARS = tuple(pair for chain in CHAINS for pair in chain_bars(*chain))
"""32 bars of both chains; those of the triangle BEF below are not among them, of GHK above HK is not."""


def sarrus_places(reach: Any, edge: float, leg: float, apex: float) -> dict[str, Any]:
    """Nodes from B = 0, slide along y, hinge edges along x (its chain bends to -z) and along z (to -x); `reach` may be complex.

    edge : length of the hinge edges. leg : of the plates. apex : distance of the plates' apexes, m.
    """
    x, y, z = np.eye(3)
    depth = np.sqrt(leg**2 - reach**2 / 4)
    found = {"B": 0.0 * y, "E": edge * x, "F": edge * z, "G": reach * y, "H": reach * y + edge * x, "K": reach * y + edge * z}
    for across, away, (_, middle, _, apexes), side in ((x, -z, CHAINS[0], 1), (z, -x, CHAINS[1], -1)):
        elbow = reach / 2 * y + depth * away
        normal = (depth * y - reach / 2 * away) / leg
        first = elbow / 2 + edge / 2 * across + side * apex * normal
        found |= {middle[0]: elbow, middle[1]: elbow + edge * across}
        found |= {apexes[0]: first, apexes[1]: first + (reach - 2 * (first @ y)) * y}
    return found


@builder("mechanisms.sarrus")
def sarrus(
    *,
    height: PositiveLength = 0.3,
    plate: PositiveLength = 0.25,
    edge: PositiveLength = 0.15,
    apex: PositiveLength = 0.1,
    title: str = "Sarrus linkage",
) -> Model:
    """A platform that moves straight along y without turning, guided by hinges alone.

    Nodes B, E, F are fixed; the platform is the triangle G, H, K above them. Each of the two chains has two plates and three
    parallel hinges; the hinges of the second chain are at right angles to those of the first. By count, six hinges in space
    leave no freedom, (6 - 1 - 6) x 6 + 6 = 0; the linkage has one. A plate is a pyramid (apexes Q1 ... Q4), since its corners
    lie in one plane. Drive ``height`` is the y coordinate of G.

    Parameters
    ----------
    height : of the platform, m, less than two plates. plate : length of the plates, m. edge : of the hinges, m. apex : of the
        plates, m.

    Raises
    ------
    ModelError : faults of the parameters; a height beyond the plates.

    Source
    ------
    P. F. Sarrus, Note sur la transformation des mouvements rectilignes alternatifs en mouvements circulaires, Comptes
    rendus de l'Academie des Sciences 36 (1853) 1036.

    Examples
    --------
    >>> model = sarrus()
    >>> len(model.bars), len(model.nodes), sorted(model.fixed)
    (32, 14, ['B', 'E', 'F'])
    """
    if height >= 2 * plate:
        raise refuse("height", f"{height:g} m is beyond the plates.", f"Stay below {2 * plate:g} m.")
    return Model(
        title=title,
        nodes=places(sarrus_places(height, edge, plate, apex)),
        fixed=["B", "E", "F"],
        bars=bars_between(SARRUS_BARS),
        drives={"height": CoordinateDrive(node="G", axis="y")},
        runs={"lift": Run(trajectory=Cyclic(moves={"height": (height, 0.7 * height)}, period=1.0))},
    )
