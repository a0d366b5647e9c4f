"""The YAML file beside a URDF: pairs of frames that close loops, motors, types of joints.

``closed_loop: [[frame, frame], ...]``, ``type: [6d, 3d, ...]`` (6d: whole frames; 3d: their origins), ``name_mot: [joint,
...]``, ``joint_name: [joint, ...]`` with ``joint_type: [SPHERICAL, FIXED, CARDAN or UJOINT_XY,
...]``. The layout is that of the robots of example-parallel-robots (V. Batto, L. De Matteis, LAAS-CNRS).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

from kinetruss.display import counted
from kinetruss.errors import Fault, ModelError, shown
from kinetruss.exchange.readers.texts import tree_of
from kinetruss.exchange.robots import LeftOut
from kinetruss.io.formats import Tree
from kinetruss.model import nearest

__all__ = ["Closures", "read_closures"]

TYPES: Mapping[str, Literal["ball", "weld"]] = {"3d": "ball", "6d": "weld"}
JOINTS = ("SPHERICAL", "FIXED", "CARDAN", "UJOINT_XY", "UJOINT_XZ", "UJOINT_YX", "UJOINT_YZ", "UJOINT_ZX", "UJOINT_ZY")
KEYS = ("closed_loop", "type", "name_mot", "joint_name", "joint_type")


class Closures:
    """The contents of the file; names are checked when those of the URDF are known."""

    def __init__(self, path: Path, tree: Tree) -> None:
        self.path = str(path)
        table = tree.table or {}
        self._table = table
        self.left_out = [
            LeftOut(key, f"{path}:{one.place[0]}", "is not known here") for key, one in table.items() if key not in KEYS
        ]
        if not any(key in table for key in KEYS):
            raise self._fault(tree, "names no closures and no motors.", f"Give some of: {', '.join(KEYS)}.")

    def _fault(self, tree: Tree, message: str, mend: str) -> ModelError:
        return ModelError([Fault((), message, mend, *tree.place, file=self.path)])

    def _list(self, key: str) -> list[Tree]:
        tree = self._table.get(key)
        if tree is None or (tree.value is None and tree.items is None and tree.table is None):
            return []
        if tree.items is None:
            raise self._fault(tree, f"{key} is no list.", f"Write {key}: [...].")
        return tree.items

    def _word(self, tree: Tree, what: str) -> str:
        if not isinstance(tree.value, str):
            raise self._fault(tree, f"is no {what}.", "Write a name.")
        return tree.value

    def _known(self, tree: Tree, known: Sequence[str] | Mapping[str, Any], what: str) -> str:
        name = self._word(tree, f"name of a {what}")
        if name not in known:
            raise self._fault(tree, f"no {what} called {shown(name)} in the URDF.", nearest(name, known))
        return name

    def drives(self, joints: Sequence[str]) -> list[str]:
        """The joints with motors: a list of names, or one text that their names contain."""
        tree = self._table.get("name_mot")
        if tree is not None and isinstance(tree.value, str):
            found = [name for name in joints if tree.value in name]
            if not found:
                raise self._fault(tree, f"no joint has {shown(tree.value)} in its name.", nearest(tree.value, joints))
            return found
        return [self._known(one, joints, "joint") for one in self._list("name_mot")]

    def kinds(self, joints: Sequence[str]) -> dict[str, str]:
        """Joint -> SPHERICAL, FIXED, CARDAN, or UJOINT_XY: turning about its x, then about its y; of all pairs of axes."""
        names, kinds = self._list("joint_name"), self._list("joint_type")
        self._same("joint_name", names, "joint_type", kinds)
        found = {}
        for name, kind in zip(names, kinds, strict=True):
            word = self._word(kind, "type of a joint").upper()
            if word not in JOINTS:
                raise self._fault(kind, f"joint_type {shown(word)} is not known.", nearest(word, JOINTS))
            found[self._known(name, joints, "joint")] = word
        return found

    def pairs(self, frames: Mapping[str, str]) -> Iterator[tuple[str, Literal["ball", "weld"], str, str, str]]:
        """Name, kind, both links and the place of each closure. frames : name of a link or joint -> link."""
        loops, types = self._list("closed_loop"), self._list("type")
        if types:
            self._same("closed_loop", loops, "type", types)
        for index, loop in enumerate(loops):
            if loop.items is None or len(loop.items) != 2:
                raise self._fault(loop, "a closure names two frames.", "Write [frame, frame].")
            kind: Literal["ball", "weld"] = "weld"
            if types:
                word = self._word(types[index], "type of a closure").lower()
                if word not in TYPES:
                    raise self._fault(types[index], f"type {shown(word)} is not known.", nearest(word, TYPES))
                kind = TYPES[word]
            one, two = (self._known(frame, frames, "link or joint") for frame in loop.items)
            if frames[one] == frames[two]:
                raise self._fault(loop, f"closes {one!r} with itself.", "Name frames of two links.")
            yield f"{one}_{two}", kind, frames[one], frames[two], f"{self.path}:{loop.place[0]}"

    def _same(self, one: str, first: Sequence[Tree], two: str, second: Sequence[Tree]) -> None:
        if len(first) != len(second):
            tree = self._table.get(two) or self._table[one]
            raise self._fault(
                tree, f"{one} has {counted(len(first), 'entry', 'entries')}, {two} {len(second)}.", "Give as many of both."
            )


def read_closures(path: Path, max_size: int) -> Closures:
    """The file; ModelError with line and column if it is not such a file."""
    tree = tree_of(path, max_size)
    if tree.table is None:
        mend = "Write for example closed_loop: [[frame_1A, frame_1B]]."
        raise ModelError([Fault((), "is not a table of names.", mend, *tree.place, file=str(path))])
    return Closures(path, tree)
