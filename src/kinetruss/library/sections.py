"""Sections of the thesis' members. `SECTIONS` holds them by the names used as library parameters."""

from __future__ import annotations

from kinetruss.late import listed
from kinetruss.model import Tube

__all__ = ["SECTIONS", "TUBE_LACY_PLANAR", "TUBE_LACY_SPATIAL", "TUBE_LACY_SPATIAL_THICK"]

__dir__ = listed(__name__)

INCH = 0.0254

TUBE_LACY_SPATIAL = Tube(outer=0.75 * INCH, inner=0.63 * INCH)
"""All tubes of the double-octahedral bay, 19.05 x 16.002 mm: strains, slews and chain of Lacy (1991), chapter 5."""

TUBE_LACY_SPATIAL_THICK = Tube(outer=0.75 * INCH, inner=0.62 * INCH)
"""The same with the inner diameter used for tables 5.2 to 5.4 and the buckling load of 3055 N."""

TUBE_LACY_PLANAR = Tube(outer=0.0254, inner=0.022225)
"""Follower and tube of the triangular truss, 1 in x 7/8 in. Table 3.1 prints the inner diameter as .02222 m."""

SECTIONS: dict[str, Tube] = {
    "tube_lacy_planar": TUBE_LACY_PLANAR,
    "tube_lacy_spatial": TUBE_LACY_SPATIAL,
    "tube_lacy_spatial_thick": TUBE_LACY_SPATIAL_THICK,
}
