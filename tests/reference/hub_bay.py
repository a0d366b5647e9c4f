"""The double-octahedral bay with a hub at every node, moved by equal strokes: by three-fold symmetry, without the package.

Each lower leaf is rigid and turns about its two joints on the ground; each hub of the top clamps one batten.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import brentq, root
from scipy.spatial.transform import Rotation


class ThreeFold:
    """The bay with hubs under equal strokes, by symmetry: a leaf that turns about its two joints on the ground, and a corner.

    A turn of 120 degrees takes N1 to N2, N4 to N6, N7 to N9. Unknown: the angle of the leaf at N4, and the pose of hub N7.
    """

    def __init__(self, places: dict[str, Any], offset: float) -> None:
        self.x = x = {name: np.array(at) for name, at in places.items()}
        third = 2 * np.pi / 3
        turns = [Rotation.from_rotvec((0, 0, sign * third)) for sign in (1, -1)]
        self.C = next(turn for turn in turns if np.allclose(turn.apply(x["N1"]), x["N2"]))
        self.offset = offset
        self.p, q = self.tip("N1", "N4"), self.tip("N3", "N4")
        self.hinge = (q - self.p) / np.linalg.norm(q - self.p)
        self.edge = x["N8"] - x["N7"]
        self.start = self.misfits(np.zeros(6), 0.0)

    def tip(self, node: str, other: str) -> Any:
        """The joint at a node of the member to another node, at the start."""
        d = self.x[other] - self.x[node]
        return self.x[node] + self.offset * d / np.linalg.norm(d)

    def leaf(self, other: str, angle: float) -> Any:
        return self.p + Rotation.from_rotvec(angle * self.hinge).apply(self.tip("N4", other) - self.p)

    def length(self, angle: float) -> float:
        """Of M7, from N4 to N5, which is N4 turned twice."""
        return float(np.linalg.norm(self.leaf("N5", angle) - (self.C * self.C).apply(self.leaf("N6", angle))))

    def corner(self, pose: Any, place: Any) -> Any:
        return self.x["N7"] + pose[:3] + Rotation.from_rotvec(pose[3:]).apply(place - self.x["N7"])

    def misfits(self, pose: Any, angle: float) -> Any:
        """The batten clamped at N8 meets hub N7; lengths of M14 and M15; the cosine of M15 with its edge. Less those at 0."""
        batten = self.corner(pose, self.tip("N9", "N7"))
        m15 = self.leaf("N7", angle) - self.corner(pose, self.tip("N7", "N4"))
        m14 = self.C.apply(self.leaf("N8", angle)) - self.corner(pose, self.tip("N7", "N6"))
        meets = (self.C * self.C).apply(batten) - self.corner(pose, self.tip("N7", "N8"))
        along = Rotation.from_rotvec(pose[3:]).apply(self.edge) @ m15
        return np.array([*meets, m15 @ m15, m14 @ m14, along])

    def solved(self, angle: float) -> Any:
        found = root(lambda pose: self.misfits(pose, angle) - self.start, np.zeros(6), tol=1e-14)
        assert np.abs(found.fun).max() < 1e-11
        return found.x

    def height(self, angle: float) -> float:
        return float(self.x["N7"][2] + self.solved(angle)[2])

    def moved(self, stroke: float) -> tuple[Any, float]:
        """Place of N7 after equal strokes, m, and its rise with the lengths, dz/dl, there."""
        start, h = self.length(0.0), 1e-3
        angle = brentq(lambda a: self.length(a) - start - stroke, -0.5, 0.5, xtol=1e-15)
        dz, dl = (
            8 * (one(angle + h) - one(angle - h)) - (one(angle + 2 * h) - one(angle - 2 * h))
            for one in (self.height, self.length)
        )
        return self.x["N7"] + self.solved(angle)[:3], dz / dl
