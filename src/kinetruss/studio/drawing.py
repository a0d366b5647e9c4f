"""The plain data of a model with its text and its history, and what a text must have to be drawn."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from kinetruss.errors import Fault, InputError, ModelError, UnitError
from kinetruss.io.emitting import plain_model
from kinetruss.io.writing import changed_text, data_of, head_of, text_of
from kinetruss.model import Model, of_file
from kinetruss.studio.dimensions import Dimensions, standing
from kinetruss.studio.edits import MEMBERS, Data, moved, place_of
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
            link = table == "links"
            ends = entry.get("nodes" if link else "ends") if isinstance(entry, dict) else entry
            given = ends if isinstance(ends, list) else []
            if not (len(given) >= 2 if link else len(given) == 2) or not all(isinstance(end, str) for end in given):
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


# The drawing: every edit makes new data; undo takes the earlier ones again.

STEPS = 500
"""Largest number of steps that can be undone."""

HEADER = {"kinetruss": 1}


@dataclass(frozen=True, eq=False)
class State:
    """One state of a model: its data, the text if someone typed it, and what the step that led to it did.

    last : the state whose text this one's text continues, with its comments. folder : of files that the text names.
    within : whether only files of the folder may be read for it. model : of the data, where it is known.
    lost : entries by table that were removed because they depend on members that changed. dimensions : that pages show.
    """

    data: Data
    typed: str | None = None
    words: str = "the beginning"
    drag: int | None = None
    last: State | None = None
    folder: Path = Path()
    within: bool = True
    model: Model | None = None
    lost: Data = field(default_factory=dict)
    dimensions: Dimensions = ()

    @cached_property
    def text(self) -> str:
        """The file: the typed text, or that of the last state with the changes written into it."""
        if self.typed is not None:
            return self.typed
        if self.last is None:
            return text_of(self.data)
        found = changed_text(self.last.text, self.last.data, self.data, self.folder, within=self.within)
        found = head_of(self.last.text) + text_of(self.data) if found is None else found
        object.__setattr__(self, "last", None)  # it is not needed any more
        return found

    @property
    def written(self) -> State:
        """This state, or the last one before it whose text is known."""
        return self if self.last is None or "text" in vars(self) else self.last


def fresh(dim: int) -> Data:
    """The data of an empty drawing; it weighs along -y, or -z in space."""
    gravity = [0.0] * dim
    gravity[-1] = -9.81
    return {**HEADER, "nodes": {}, "gravity": gravity}


def read_text(text: str, folder: Path, *, within: bool = True) -> tuple[Data, list[Fault]]:
    """The data of a text, and the faults for which they are not taken. within : only files of the folder may be read."""
    try:
        data, faults = data_of(text, folder, within=within)
    except ModelError as error:
        return {}, error.faults
    return data, faults or faulty_shape(data)


def model_of(data: Data, folder: Path) -> Model:
    """The model of plain data; motions of runs are files of the folder. Nothing is read.

    Raises
    ------
    ModelError : faults, in the words of a file.
    """
    rows = data.get("runs")
    runs = rows if isinstance(rows, dict) else {}
    for name, run in runs.items():
        if isinstance(run, dict) and isinstance(run.get("motion"), str):
            runs = {**runs, name: {**run, "motion": str(folder / run["motion"])}}
    data = {**data, "runs": runs} if runs else data
    with of_file():
        return Model(**data)


def opened(model: Model | None, text: str, folder: Path | None, dim: int, draw: bool) -> State:
    """The state of a model that was read, with its text if that is given and can be followed."""
    if model is None:
        return State(fresh(dim), folder=folder or Path())
    if text:
        data, faults = read_text(text, folder or Path(), within=False)
        if not faults:
            return State(data, text, folder=folder or Path(), within=draw, model=model)
    return State(plain_model(model), model=model)


class Drawing:
    """The present state, those before and after it, and what the present one is worth."""

    def __init__(self, state: State, dim: int) -> None:
        self.past: list[State] = []
        self.future: list[State] = []
        self.state = state
        self.own_dim = dim
        self.revision = 0
        self._found: Judged | None = None

    @property
    def found(self) -> Judged:
        """What the present state is worth."""
        if self._found is None:
            self._found = judged(self.state.data)
        return self._found

    @property
    def dim(self) -> int:
        """2 or 3; of an empty drawing the chosen one."""
        names = self.state.data.get("nodes") or {}
        return len(place_of(self.state.data, next(iter(names)))) if names else self.own_dim

    def edit(
        self, data: Data, words: str, drag: int | None = None, *, anew: bool = False, lost: Data | None = None,
        dimensions: Dimensions | None = None,
    ) -> None:  # fmt: skip
        """Take new data as the next state, closed. anew : another drawing, whose text does not continue the present one.

        Raises
        ------
        ModelError : the data have faults that the present ones do not have; nothing is changed.
        """
        found = judged(data, fine=drag is None, last=self.found if drag is not None and self._plain(data) else None)
        known = {(fault.path, fault.message) for fault in self.found.faults}
        if new := [fault for fault in found.faults if (fault.path, fault.message) not in known]:
            raise ModelError(new)
        if shifted := {name: place for name, place in found.moved.items() if name in data["nodes"]}:
            data = moved(data, shifted)
        self.take(data, words, drag, anew=anew, lost=lost, dimensions=dimensions)
        self._found = found

    def take(
        self, data: Data, words: str, drag: int | None = None, *, typed: str | None = None, model: Model | None = None,
        anew: bool = False, lost: Data | None = None, dimensions: Dimensions | None = None,
    ) -> None:  # fmt: skip
        """Take new data as the next state. drag : steps with the same number are one. anew : as of `edit`."""
        merged = drag is not None and self.state.drag == drag
        before = self.past[-1] if merged else self.state
        last = None if anew or typed is not None else before.written
        lost = self.state.lost if lost is None else lost
        measured = () if anew else standing(before.dimensions if dimensions is None else dimensions, data)
        self.put(State(data, typed, words, drag, last, before.folder, before.within, model, lost, measured), merged=merged)

    def measure(self, dimensions: Dimensions) -> None:
        """Other dimensions of the same drawing as the next state."""
        self.put(replace(self.state, typed=self.state.text, last=None, words="the dimension", drag=None, dimensions=dimensions))

    def put(self, state: State, *, merged: bool = False) -> None:
        """A state as the next one, or in place of the present one."""
        if not merged:
            self.past = [*self.past, self.state][-STEPS:]
        self.future = []
        self._show(state)

    def retyped(self, text: str) -> None:
        """The present data in another text."""
        self._show(replace(self.state, typed=text, last=None))

    def step(self, by: int) -> None:
        """Undo (-1) or redo (1) one step.

        Raises
        ------
        InputError : there is none.
        """
        if not (self.past if by < 0 else self.future):
            raise InputError(f"There is nothing to {'undo' if by < 0 else 'redo'}.")
        if by < 0:
            self.future = [self.state, *self.future]
            self._show(self.past.pop())
        else:
            self.past = [*self.past, self.state]
            first, *self.future = self.future
            self._show(first)

    def rest(self) -> None:
        """Compute what waited for the end of a drag."""
        self._found = None

    def _show(self, state: State) -> None:
        if state.data is not self.state.data:
            self._found = None
            self.revision += 1
        self.state = state

    def _plain(self, data: Data) -> bool:
        """True if places of nodes alone differ between the model and that of the data: nothing is derived from them."""
        model, now = self.found.model, self.state.data
        if data.keys() != now.keys() or any(data[key] is not now[key] for key in data if key != "nodes"):
            return False
        return model is not None and not (model.bending or model.bodies or model.hubs)
