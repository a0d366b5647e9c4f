"""Where the parts of a scene are, for renderers other than the page: lines of members, faces, bodies, motors, supports."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from kinetruss.viewer.support_marks import frame_of
from kinetruss.viewer.topology import FRAME

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.viewer.moving import Scene

    Array = NDArray[np.float64]


class Places:
    """The parts of a scene with nodes at x (n, dim), m; by default where they are at its sample number `sample`."""

    def __init__(self, scene: Scene, sample: int = 0, x: Array | None = None) -> None:
        self.scene = scene
        self.x = scene.arrays["position"][sample] if x is None else x

    @cached_property
    def members(self) -> list[int]:
        """Members that are shown: all but the bars of frames of beams."""
        return [k for k, kind in enumerate(self.scene.header["kinds"]) if kind != FRAME]

    @cached_property
    def nodes(self) -> list[int]:
        """Nodes that are shown: all but those of frames of beams."""
        directors = set(self.scene.header["directors"])
        return [k for k in range(len(self.scene.header["nodes"])) if k not in directors]

    @cached_property
    def joined(self) -> list[int]:
        """Nodes that are shown but those that only a membrane or a solid has."""
        arrays, header = self.scene.arrays, self.scene.header
        joints = {*arrays["ends"][self.members].ravel().tolist(), *(node for face in header["solids"] for node in face)}
        mesh = set(arrays["skin"].ravel().tolist()) - joints if "skin" in arrays else set()
        return [k for k in self.nodes if k not in mesh]

    @cached_property
    def kinds(self) -> list[str]:
        """The kind of each member that is shown; ``driven`` of bars that a drive moves."""
        # a hinge drive is reported with a member that it turns
        moved = {drive["member"] for drive in self.scene.header["drives"] if "member" in drive and "axis" not in drive}
        kinds = self.scene.header["kinds"]
        return ["driven" if k in moved and kinds[k] != "active" else kinds[k] for k in self.members]

    @cached_property
    def lines(self) -> list[Array]:
        """Points (g, dim) of each member that is shown, from end to end: elastic beams along their axes."""
        arrays, bent = self.scene.arrays, {}
        if "beam_member" in arrays:
            along = np.einsum("kgv,kvc->kgc", arrays["beam_along"], self.x[arrays["beam_nodes"]])
            bent = dict(zip(arrays["beam_member"].tolist(), along, strict=True))
        return [bent[k] if k in bent else self.x[arrays["ends"][k]] for k in self.members]

    @cached_property
    def bodies(self) -> Array:
        """Corners (k, 3, dim): of planar bodies the ends of their bar and the centre of mass, of others their hull."""
        found = []
        for body in self.scene.header["bodies"]:
            p, q = self.x[self.scene.arrays["ends"][body["member"]]]
            along, across = body["center"]
            u = (q - p) / np.linalg.norm(q - p)
            found.append([p, q, p + along * u + across * np.array([-u[1], u[0]])])
        found += list(self.x[np.array(self.scene.header["solids"], int).reshape(-1, 3)])
        return np.array(found, float).reshape(-1, 3, self.x.shape[1])

    @cached_property
    def faces(self) -> Array:
        """Corners (f, 3, dim) of the faces of membranes and solids."""
        skin = self.scene.arrays.get("skin")
        return self.x[skin] if skin is not None else np.zeros((0, 3, self.x.shape[1]))

    @cached_property
    def motors(self) -> Array:
        """Places (h, dim) of drives that turn: midpoints of axes of hinges, first ends of bars whose angle is driven."""
        found = []
        for drive in self.scene.header["drives"]:
            if drive["kind"] == "hinge":
                found.append(self.x[drive["axis"]].mean(axis=0))
            elif drive["kind"] == "angle":
                found.append(self.x[self.scene.arrays["ends"][drive["member"], 0]])
        return np.array(found, float).reshape(-1, self.x.shape[1])

    @cached_property
    def supports(self) -> list[tuple[str, Array, Array]]:
        """Kind, place (dim,) and axes x, y (2, dim) of each symbol of a support."""
        dim = self.x.shape[1]
        marks = self.scene.header["support_marks"]
        return [(one["kind"], self.x[one["node"]], frame_of(one["kind"], np.array(one["along"]))[:, :dim]) for one in marks]
