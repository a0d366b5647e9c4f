"""What an import gives: the model, what it does not have, what its loops are; packages of extras."""

from __future__ import annotations

import importlib
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from kinetruss.display import counted
from kinetruss.errors import InputError
from kinetruss.exchange.robots import LeftOut
from kinetruss.model import Model

if TYPE_CHECKING:
    from kinetruss.kinematics import Mobility


def needed(package: str, extra: str) -> Any:
    """A package; InputError with the command that installs it if it is missing."""
    try:
        return importlib.import_module(package)
    except ImportError:
        raise InputError(f"This format needs the package {package}. Install it: pip install 'kinetruss[{extra}]'") from None


# What an import gives: the model, what it does not have, and what its loops are.

MOST = 40
"""Largest number of reasons why something is left out that are printed."""
PLACES = 4
"""Largest number of places that are printed for each."""
ROUND = 1e-12
"""Offset of a drive, rad or m, that is round-off."""


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
        tables: dict[str, Mapping[str, Any]] = {"node": model.nodes, "bar": model.bars, "body": model.bodies}
        tables |= {"membrane": model.membranes, "solid": model.solids, "drive": model.all_drives}
        tables |= {"spring": model.springs, "coupling": model.couplings}
        several = {"body": "bodies"}
        lines = [
            f"{self.source}: "
            + ", ".join(
                counted(len(table), word, several.get(word, "")) for word, table in tables.items() if table or word == "bar"
            ),
            *self._loops(found.self_stress),
            f"{counted(found.degrees_of_freedom, 'degree')} of freedom, {found.undriven} with the drives held; "
            f"{counted(found.self_stress, 'state')} of self-stress",
        ]
        if found.undriven and found.undriven == self._floating():
            lines.append(f"  these {found.undriven} move the whole, which nothing holds: it floats")
        else:
            lines += [f"  with the drives held, {text}" for text in found.mechanism_texts(5)]
        if model.membranes or model.solids:
            lines.append("  counted by rigid bars alone; membranes and solids hold their nodes elastically")
        lines += [f"drive {name} = joint value {offset:+.9g}" for name, offset in self.offsets.items() if abs(offset) > ROUND]
        lines += [f"note: {text}" for text in self.notes]
        if self.left_out:
            kinds = Counter(one.what for one in self.left_out).most_common()
            lines.append(f"left out ({len(self.left_out)}): " + ", ".join(f"{n} {what}" for what, n in kinds))
            lines += self._lost()
        return lines

    def _floating(self) -> int:
        """Freedoms of the whole as one rigid body: those of a model that nothing holds."""
        return 0 if self.model.fixed else 3 if self.model.dim == 2 else 6

    def _lost(self) -> list[str]:
        """What was left out, one line for each kind and reason, with the places."""
        places: dict[tuple[str, str], list[str]] = {}
        for one in self.left_out:
            places.setdefault((one.what, one.why), []).append(one.where)
        lines = []
        for (what, why), where in list(places.items())[:MOST]:
            more = f" and {len(where) - PLACES} more (--json lists all)" if len(where) > PLACES else ""
            lines.append(f"  {what}: {why}: {', '.join(where[:PLACES])}{more}")
        return lines + [f"  and {len(places) - MOST} more (--json lists all)"] * (len(places) > MOST)

    def _loops(self, self_stress: int) -> list[str]:
        if self.freedoms is None:
            return []
        loops = counted(len(self.closures), "loop") if self.closures else "no loops"
        lines = [f"{loops}; joints and closures leave {counted(self.freedoms, 'freedom')} (by rank)"]
        for name, count in self.closures.items():
            if count:
                text = f"{counted(count, 'condition')} of it {'is' if count == 1 else 'are'} redundant"
                lines.append(f"  closure {name}: {text}: the rest of the robot implies {'it' if count == 1 else 'them'}")
        if any(self.closures.values()) and self_stress:
            lines.append("  so forces within these loops are not unique; drive forces are")
        if self.gap:
            lines.append(f"  the loops of the file close only to {self.gap:.2g} (m, rad); places are taken in the middle")
        return lines
