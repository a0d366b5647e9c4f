"""What an import gives: the model, what it does not have, and what its loops are."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from kinetruss.exchange.robots import LeftOut
from kinetruss.model import Model

if TYPE_CHECKING:
    from kinetruss.kinematics import Mobility

__all__ = ["Imported"]

MOST = 40
"""Largest number of things left out that are printed one by one."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Imported:
    """A model from a file of another program.

    model : the model. source : the file. left_out : everything of the file that the model does not have: what, where, why.
    closures : of a robot, closure -> number of its conditions that the joints and the closures before it imply (0: it is
        independent). gap : largest distance, m or rad, by which its loops did not close; places are in the middle.
    offsets : drive -> its value minus that of the joint in the file, rad or m; 0 for hinges.
    freedoms : of a robot, those of its joints and closures by rank; None for others. notes : what was assumed.
    """

    model: Model
    source: str
    left_out: Sequence[LeftOut] = ()
    closures: Mapping[str, int] = field(default_factory=dict)
    gap: float = 0.0
    offsets: Mapping[str, float] = field(default_factory=dict)
    freedoms: int | None = None
    notes: Sequence[str] = ()

    @property
    def mobility(self) -> Mobility:
        """Freedoms, mechanisms and states of self-stress of the model, by rank (`kinematics.mobility`)."""
        from kinetruss.kinematics import mobility

        return mobility(self.model)

    def lines(self) -> list[str]:
        """The import in words: contents, loops, freedoms, drives, and all that was left out."""
        model, found = self.model, self.mobility
        tables: dict[str, Mapping[str, Any]] = {
            "nodes": model.nodes,
            "bars": model.bars,
            "bodies": model.bodies,
            "membranes": model.membranes,
        }
        tables |= {"solids": model.solids, "drives": model.all_drives}
        lines = [
            f"{self.source}: " + ", ".join(f"{len(table)} {word}" for word, table in tables.items() if table or word == "bars"),
            *self._loops(),
            f"{found.degrees_of_freedom} degrees of freedom before drives, {found.undriven} after; "
            f"{found.self_stress} states of self-stress",
        ]
        lines += [f"  with the drives held, {text}" for text in found.mechanism_texts(5)]
        if model.membranes or model.solids:
            lines.append("  counted by rigid bars alone; membranes and solids hold their nodes elastically")
        lines += [f"drive {name} = joint value {offset:+.9g}" for name, offset in self.offsets.items() if offset]
        lines += [f"note: {text}" for text in self.notes]
        if self.left_out:
            kinds = Counter(one.what for one in self.left_out).most_common()
            lines.append(f"left out ({len(self.left_out)}): " + ", ".join(f"{n} {what}" for what, n in kinds))
            lines += [f"  {one}" for one in self.left_out[:MOST]]
            lines += [f"  and {len(self.left_out) - MOST} more (--json lists all)"] * (len(self.left_out) > MOST)
        return lines

    def _loops(self) -> list[str]:
        if self.freedoms is None:
            return []
        spare = {name: count for name, count in self.closures.items() if count}
        text = f"{len(self.closures)} loops; {self.freedoms} freedoms of joints and closures by rank"
        lines = [text if self.closures else f"no loops; {self.freedoms} freedoms of joints"]
        lines += [f"  closure {name}: {count} of its conditions are redundant" for name, count in spare.items()]
        if self.gap:
            lines.append(f"  the loops of the file close only to {self.gap:.2g} (m, rad); places are taken in the middle")
        return lines
