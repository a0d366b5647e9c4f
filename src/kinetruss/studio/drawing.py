"""The drawing: the plain data of a model with its history, and what a text must have to be drawn."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from kinetruss.errors import Fault, InputError, ModelError, UnitError
from kinetruss.io.writing import changed_text, data_of, head_of, text_of
from kinetruss.studio.drawing_edits import MEMBERS, Data, moved, place_of
from kinetruss.studio.judging import Judged, judged
from kinetruss.units import parse


def faulty_shape(data: Data) -> list[Fault]:
    """Faults of nodes and members that make it impossible to draw them."""
    found = []
    nodes, counts = data.get("nodes") or {}, set()
    if not isinstance(nodes, dict):
        return [Fault(("nodes",), "is not a table of names.", "Write for example nodes: {A: [0, 0]}.")]
    for name, entry in nodes.items():
        at = entry.get("at") if isinstance(entry, dict) else entry
        if not isinstance(at, list) or not _is_place(at):
            found.append(Fault(("nodes", name), "has no place.", "Write two or three lengths, e.g. [0.1, 50 mm]."))
        else:
            counts.add(len(at))
    if len(counts) > 1:
        found.append(Fault(("nodes",), "have two and three coordinates.", "Give all of them as many."))
    for table in MEMBERS:
        entries = data.get(table) or {}
        if not isinstance(entries, dict):
            found.append(Fault((table,), "is not a table of names.", f"Write for example {table}: {{b: [A, B]}}."))
            continue
        for name, entry in entries.items():
            ends = entry.get("ends") if isinstance(entry, dict) else entry
            if not (isinstance(ends, list) and len(ends) == 2 and all(isinstance(end, str) for end in ends)):
                found.append(Fault((table, name), "has no two ends.", "Write for example [A, B]."))
    fixed = data.get("fixed") or {}
    names = list(fixed.values()) if isinstance(fixed, dict) else fixed
    if not isinstance(names, list) or not all(isinstance(one, str) for one in names):
        found.append(Fault(("fixed",), "is neither a list of nodes nor a table of axes.", "Write for example fixed: {A: xy}."))
    return found


def _is_place(at: list[Any]) -> bool:
    if len(at) not in (2, 3):
        return False
    try:
        [parse(value, "length") for value in at]
    except UnitError:
        return False
    return True


# The drawing: the plain data of a model with its history. Every edit makes new data; undo takes the earlier ones again.

STEPS = 500
"""Largest number of steps that can be undone."""

HEADER = {"kinetruss": 1}


@dataclass(frozen=True, eq=False)
class State:
    """One state of a drawing: its data, the text if someone typed it, and what the step that led to it did.

    last : the state whose text this one's text continues, with its comments. folder : of files that the text names.
    """

    data: Data
    typed: str | None = None
    words: str = "the beginning"
    drag: int | None = None
    last: State | None = None
    folder: Path = Path()

    @cached_property
    def text(self) -> str:
        """The file: the typed text, or that of the last state with the changes written into it."""
        if self.typed is not None:
            return self.typed
        if self.last is None:
            return text_of(self.data)
        found = changed_text(self.last.text, self.last.data, self.data, self.folder, within=True)
        found = head_of(self.last.text) + text_of(self.data) if found is None else found
        object.__setattr__(self, "last", None)  # it is not needed any more
        return found


def fresh(dim: int) -> Data:
    """The data of an empty drawing; it weighs along -y, or -z in space."""
    gravity = [0.0] * dim
    gravity[-1] = -9.81
    return {**HEADER, "nodes": {}, "gravity": gravity}


class Drawing:
    """The present state, those before and after it, and what the present one is worth."""

    def __init__(self, state: State, dim: int) -> None:
        self.past: list[State] = []
        self.future: list[State] = []
        self.state = state
        self.own_dim = dim
        self.found = judged(state.data)
        self.revision = 0

    @property
    def dim(self) -> int:
        """2 or 3; of an empty drawing the chosen one."""
        names = self.state.data.get("nodes") or {}
        return len(place_of(self.state.data, next(iter(names)))) if names else self.own_dim

    def edit(self, data: Data, words: str, drag: int | None = None, *, anew: bool = False) -> None:
        """Take new data as the next state. anew : another drawing, whose text does not continue the present one.

        Raises
        ------
        ModelError : the data have faults that the present ones do not have; nothing is changed.
        """
        merged = drag is not None and self.state.drag == drag
        found = judged(data, fine=drag is None, last=self.found if drag is not None and self._plain() else None)
        known = {(fault.path, fault.message) for fault in self.found.faults}
        if new := [fault for fault in found.faults if (fault.path, fault.message) not in known]:
            raise ModelError(new)
        if shifted := {name: place for name, place in found.moved.items() if name in data["nodes"]}:
            data = moved(data, shifted)
        last = self.past[-1] if merged else self.state
        self._next(State(data, None, words, drag, None if anew else last, last.folder), found, merged)

    def write(self, text: str, folder: Path, within: bool = True, drag: int | None = None) -> list[Fault]:
        """Take the drawing of a text, even if the model has faults; returns the faults for which it is not taken.

        within : only files of the folder may be read for it. drag : texts with the same number are one step.
        """
        try:
            data, faults = data_of(text, folder, within=within)
        except ModelError as error:
            return error.faults
        if wrong := faults or faulty_shape(data):
            return wrong
        if data != self.state.data:
            merged = drag is not None and self.state.drag == drag
            self._next(State(data, text, "the text", drag, folder=folder), judged(data), merged)
        else:
            self.state = replace(self.state, typed=text)
            self.revision += 1
        return []

    def _plain(self) -> bool:
        """True if places of nodes alone differ between the model and a model with moved nodes: nothing is derived from them."""
        model = self.found.model
        if model is None or model.beams or model.bodies or model.hubs:
            return False
        return all(node.director is None for node in model.nodes.values()) and not any(b.brace for b in model.bars.values())

    def _next(self, state: State, found: Judged, merged: bool) -> None:
        if not merged:
            self.past = [*self.past, self.state][-STEPS:]
        self.future = []
        self.state, self.found = state, found
        self.revision += 1

    def rest(self) -> None:
        """Compute what waited for the end of a drag."""
        self.found = judged(self.state.data)

    def undo(self) -> None:
        """The state before the last step."""
        if not self.past:
            raise InputError("There is nothing to undo.")
        self.future = [self.state, *self.future]
        self.state = self.past.pop()
        self._again()

    def redo(self) -> None:
        """The state after the step that was undone."""
        if not self.future:
            raise InputError("There is nothing to redo.")
        self.past = [*self.past, self.state]
        self.state, *self.future = self.future
        self._again()

    def _again(self) -> None:
        self.found = judged(self.state.data)
        self.revision += 1

    def names(self) -> list[str]:
        """Names of all members."""
        return [name for table in MEMBERS for name in self.state.data.get(table) or {}]
