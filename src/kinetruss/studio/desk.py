"""The desk of one studio: the drawing that all its pages share, and the answers to their messages."""

from __future__ import annotations

import threading
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError, KinetrussError, ModelError
from kinetruss.io.writing import text_of, value_of
from kinetruss.model import Model, turns
from kinetruss.shelves import shelf, shelves
from kinetruss.studio import drawing_commands as say
from kinetruss.studio.drawing import Drawing, State, fresh
from kinetruss.studio.drawing_edits import (
    CELLS,
    MEMBERS,
    added_bar,
    added_node,
    copied,
    deleted,
    mirrored,
    moved,
    renamed,
    stacked,
    with_value,
)
from kinetruss.studio.drawing_state import fault_rows, state_of
from kinetruss.studio.edits import FileThereError, Seen, save, seen_now
from kinetruss.studio.keeping import Keep
from kinetruss.studio.new_parts import forms, made, with_analysis
from kinetruss.studio.requested_runs import Results, curve

Record = dict[str, Any]


class Desk:
    """A drawing on the server: messages in, records out.

    model : the model drawn first, or None for an empty drawing. text : of its file. folder : the only one written to.
    """

    def __init__(
        self, model: Model | None = None, file: Path | None = None, folder: Path | None = None, *, dim: int = 2,
        seen: Seen | None = None,
    ) -> None:  # fmt: skip
        self.file = file
        self.folder = folder
        self.seen = seen_now(file) if seen is None else dict(seen)
        self.keep = None if folder is None else Keep.unused(folder, file.stem if file is not None else "untitled")
        self.given = model
        self.drawing = self._opened(model, dim)
        self.offered = self.keep.found() if self.keep is not None else None
        if self.offered is not None and self.offered[0] == self.drawing.state.text:
            self.offered = None
        self.saved = self.drawing.state
        self.lock = threading.Lock()
        self.address: tuple[str, int] | None = None
        self.kept = False
        self.left = self.keep.pages() if self.keep is not None else []
        self.results = Results()

    # -- slider pages ----------------------------------------------------------------------------------------------

    def page_left(self) -> tuple[str, float] | None:
        """Key and time of the newest slider page of an earlier studio that nobody has taken up."""
        return self.left[0] if self.left else None

    def take_page(self, key: str) -> Record | None:
        """The changes of a slider page; it is offered to no other page any more."""
        with self.lock:
            self.left = [one for one in self.left if one[0] != key]
            return None if self.keep is None else self.keep.page(key)

    def keep_page(self, key: str, record: Record | None) -> None:
        """Keep the changes of a slider page beside the file; None removes them.

        Raises
        ------
        StoreError : they cannot be written.
        """
        with self.lock:
            self.left = [one for one in self.left if one[0] != key]
            if self.keep is None:
                return
            self._settle()
            self.keep.keep_page(key, record)
            if record is not None and self.address is not None:
                self.keep.keep_address(*self.address)

    def _opened(self, model: Model | None, dim: int) -> Drawing:
        if model is None:
            return Drawing(State(fresh(dim)), dim)
        drawing = Drawing(State(fresh(model.dim)), model.dim)
        text = text_of(model)
        if self.file is not None and self.file.suffix.lower() in (".yaml", ".yml"):
            text = self.file.read_text(encoding="utf-8-sig")
        if drawing.write(text, self.folder or Path(), within=False) or drawing.found.model is None:
            drawing.write(text_of(model), Path())
        drawing.past.clear()
        return drawing

    # -- messages --------------------------------------------------------------------------------------------------

    def first(self) -> Record:
        """The record of a page that has just connected."""
        with self.lock:
            picture = self.keep.picture() if self.keep is not None else None
            return self._state() | {
                "choices": choices(),
                "offer": self._offer(),
                "picture": picture,
                "running": self.results.running(),
            }

    def answer(self, text: str | bytes) -> Record:
        """The answer to one message; errors are records too, and change nothing."""
        with self.lock:
            try:
                command = say.command_of(text)
                if not isinstance(command, say.Run | say.Running | say.Stop):
                    return self.do(command)
            except ModelError as error:
                return {"kind": "error", "message": " ".join(str(fault) for fault in error.faults[:3])}
            except KinetrussError as error:
                return {"kind": "error", "message": str(error)}
        try:  # a run is computed beside the messages: every page goes on drawing
            return self.of_run(command)
        except KinetrussError as error:
            return {"kind": "error", "message": str(error)}

    def of_run(self, command: say.Run | say.Running | say.Stop) -> Record:
        """Begin a run, say how far it is, or stop it."""
        if isinstance(command, say.Run):
            with self.lock:
                revision = self.drawing.revision
            return self.results.start(self.model(), command.name, revision)
        if isinstance(command, say.Stop):
            return self.results.stop()
        return self.results.running() or {"kind": "stopped"}

    def model(self) -> Model:
        """The model of the drawing, for the live page.

        Raises
        ------
        InputError : nothing is drawn, or it has faults.
        """
        with self.lock:
            found = self.drawing.found
            if self.drawing.state is self.saved and self.given is not None:
                return self.given
            if found.model is None or not found.model.members:
                raise InputError("The drawing is no model yet: it needs nodes and bars, without faults.")
            return found.model

    def text(self) -> str:
        """The text of the drawing, with its comments."""
        with self.lock:
            return self.drawing.state.text

    def do(self, command: Any) -> Record:
        """Do one command."""
        match command:
            case say.Show():
                self.drawing.rest()
            case say.Undo():
                self.drawing.undo()
            case say.Redo():
                self.drawing.redo()
            case say.Text():
                if faults := self.drawing.write(command.text, self.folder or Path(), drag=command.drag):
                    return {"kind": "faults", "faults": fault_rows(faults)}
            case say.Curve():
                return self.curve(command)
            case say.Save():
                return self.save(command)
            case say.Versions():
                return self._versions()
            case say.Picture():
                return self.keep_picture(command)
            case say.Keep():
                return self.keep_version(command.words)
            case say.Restore():
                return self._written(self._kept().version(command.number), f"version {command.number}")
            case say.Draft():
                return self.draft(command.keep)
            case _:
                return self.edit(command)
        self._autosave()
        return self._state()

    def edit(self, command: Any) -> Record:
        """A command that changes the data."""
        data, drawing = self.drawing.state.data, self.drawing
        picked: Record = {}
        match command:
            case say.Move():
                drawing.edit(moved(data, command.places), f"moving {_list(command.places)}", command.drag)
                if command.drag is not None:
                    return state_of(drawing, light=True)
            case say.Fresh():
                drawing.own_dim = command.dim
                drawing.edit(fresh(command.dim), "the empty drawing", anew=True)
            case say.Add():
                data, name = added_node(data, command.name, command.at)
                picked = {"node": name}
                if command.bar_from is not None:
                    data, picked["member"] = added_bar(data, None, (command.bar_from, name))
                drawing.edit(data, f"adding {name}")
            case say.Bar():
                data, name = added_bar(data, command.name, command.ends)
                picked = {"member": name}
                drawing.edit(data, f"adding {name}")
            case say.Set():
                value = self._typed(command.value) if command.typed else command.value
                run = command.path[0] == "runs" and len(command.path) == 3 and command.path[2] == "analysis" and value
                new = with_analysis(data, command.path[1], str(value)) if run else with_value(data, command.path, value)
                drawing.edit(new, f"setting {'.'.join(command.path)}")
            case say.Make():
                data, table, name = made(data, command.what, command.nodes, command.members, self._present())
                drawing.edit(data, f"making {name}")
                picked = {"entry": [table, name]} | ({"member": name} if table in MEMBERS else {})
            case say.Rename():
                drawing.edit(renamed(data, command.table, command.old, command.new), f"renaming {command.old}")
                picked = {"renamed": [command.old, command.new]}
            case say.Delete():
                data, lost = deleted(data, command.nodes, command.members)
                drawing.edit(data, f"deleting {_list([*command.nodes, *command.members])}")
                picked = {"lost": lost}
            case say.Copy():
                drawing.edit(copied(data, command.nodes, command.by, command.count), "copying")
            case say.Mirror():
                drawing.edit(mirrored(data, command.nodes, command.axis, command.at), "mirroring")
            case say.Stack():
                drawing.edit(stacked(data, command.cell, command.count, command.arguments), f"stacking {command.cell}")
        self._autosave()
        return self._state() | {"made": picked}

    def _present(self) -> dict[str, tuple[float, str]]:
        """Value and unit of each drive in the pose drawn."""
        found = self.drawing.found
        if found.model is None:
            return {}
        records = found.model.all_drives
        return {name: (value, "rad" if turns(records[name]) else "m") for name, value in found.drives.items()}

    def _typed(self, value: Any) -> Any:
        """A value of a form, in which each text is YAML."""
        if isinstance(value, dict):
            return {key: self._typed(one) for key, one in value.items()}
        if isinstance(value, list):
            return [self._typed(one) for one in value]
        names = {name for table in self.drawing.state.data.values() if isinstance(table, dict) for name in table}
        return value_of(value, names) if isinstance(value, str) else value

    def curve(self, command: say.Curve) -> Record:
        """The path of a node and the force of a drive along its range."""
        found = self.drawing.found
        if found.model is None or found.position is None or found.apart:
            raise InputError("No curve: the drawing is no closed model yet.")
        return {"kind": "curve"} | curve(found.model, found.position, command.node, command.drive, command.low, command.high)

    # -- files -----------------------------------------------------------------------------------------------------

    def save(self, command: say.Save) -> Record:
        """Write the file; a question if another one would be lost."""
        model = self.drawing.found.model
        if model is None:
            raise InputError("A model with faults is not saved; it is kept beside the file. Mend the faults first.")
        text = self.drawing.state.text
        try:
            path = save(model, self.folder, command.name, self.seen, replace=command.replace, text=text)
        except FileThereError as there:
            return {"kind": "exists", "message": str(there)}
        kept = self._kept()
        kept.add(text, f"saved as {path.name}")
        kept.remove()
        self.file, self.saved, self.given = path, self.drawing.state, model
        self._picture_with_file()
        return self._state() | {"saved": f"Written: {path.name}."}

    def keep_version(self, words: str) -> Record:
        """Put the present state into the list of versions."""
        self._kept().add(self.drawing.state.text, words or "kept")
        return self._versions()

    def keep_picture(self, command: say.Picture) -> Record:
        """Keep the picture to trace, or another place of it, beside the drawing."""
        if self.keep is None:
            return {"kind": "picture", "kept": False}
        self._settle()
        self.keep.keep_picture(command.place, command.source)
        self._picture_with_file()
        return {"kind": "picture", "kept": True}

    def _picture_with_file(self) -> None:
        """The picture beside the saved file too: its next studio looks for it there."""
        if self.keep is None or self.file is None or self.file.stem == self.keep.name:
            return
        found = self.keep.picture()
        other = Keep(self.keep.folder, self.file.stem)
        other.keep_picture(*((found["place"], found["source"]) if found is not None else (None, None)))

    def draft(self, keep: bool) -> Record:
        """Take up or remove the autosaved drawing of an earlier studio."""
        offered, self.offered = self.offered, None
        if offered is None:
            raise InputError("There is no autosaved drawing.")
        if keep:
            return self._written(offered[0], "the autosaved drawing")
        self._kept().remove()
        return self._state()

    def _written(self, text: str, words: str) -> Record:
        if faults := self.drawing.write(text, self.folder or Path()):
            raise ModelError(faults)
        self.drawing.state = replace(self.drawing.state, words=words)
        self._autosave()
        return self._state()

    def _versions(self) -> Record:
        rows = self.keep.versions() if self.keep is not None else []
        return {"kind": "versions", "rows": [{k: row.get(k) for k in ("number", "when", "words")} for row in rows]}

    def _kept(self) -> Keep:
        if self.keep is None:
            raise InputError("No folder was chosen to write to.")
        return self.keep

    def _autosave(self) -> None:
        """Keep the drawing beside its file; one of an earlier studio that nobody has taken up becomes a version."""
        if self.keep is None or (self.drawing.state is self.saved and self.offered is not None):
            return
        self._settle()
        if self.offered is not None:
            self.keep.add(self.offered[0], "left by an earlier studio")
            self.offered = None
        if self.drawing.state is self.saved:
            self.keep.remove()
        else:
            self.keep.autosave(self.drawing.state.text)
        if self.address is not None:
            self.keep.keep_address(*self.address)

    def _settle(self) -> None:
        """From now on the side files of this name are those of this studio."""
        if self.keep is not None and not self.kept:
            token = self.address[0] if self.address is not None else None
            self.keep, self.kept = Keep.unused(self.keep.folder, self.keep.name, token), True

    def _state(self) -> Record:
        record = state_of(self.drawing)
        return record | {
            "file": "" if self.file is None else self.file.name,
            "dirty": self.drawing.state is not self.saved,
            "writable": self.folder is not None,
            "offered": self.offered is not None,
        }

    def _offer(self) -> Record | None:
        if self.offered is None:
            return None
        return {"when": self.offered[1], "ago": time.time() - self.offered[1], "lines": self.offered[0].count("\n")}


def choices() -> Record:
    """Names of the library that the page offers, and the forms of all records."""
    return {name: sorted(shelf(name)) for name in shelves()} | {"cells": list(CELLS), "forms": forms()}


def _list(names: Any) -> str:
    shown = list(names)
    return ", ".join(shown[:3]) + (f" and {len(shown) - 3} more" if len(shown) > 3 else "")
