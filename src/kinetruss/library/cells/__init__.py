"""Trusses from cells: ready cells and one's own, stacked, mirrored, branched, closed into rings."""

from kinetruss.late import listed
from kinetruss.library.cells.assemblies import assemble, branch, ring, stack
from kinetruss.library.cells.chains import cell, chain, stacked
from kinetruss.library.cells.fittings import Actuator
from kinetruss.library.cells.flat import panel, triangle
from kinetruss.library.cells.mirroring import mirror
from kinetruss.library.cells.octahedra import Rods, double_octahedron, quadruple_octahedron
from kinetruss.library.cells.records import Cell, Face
from kinetruss.library.cells.solid import cube, decahedron, octahedron, prism, tetrahedron

__all__ = [
    "Actuator",
    "Cell",
    "Face",
    "Rods",
    "assemble",
    "branch",
    "cell",
    "chain",
    "cube",
    "decahedron",
    "double_octahedron",
    "mirror",
    "octahedron",
    "panel",
    "prism",
    "quadruple_octahedron",
    "ring",
    "stack",
    "stacked",
    "tetrahedron",
    "triangle",
]

__dir__ = listed(__name__)
