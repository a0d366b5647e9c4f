"""The session of a model that pages work on: text and history, pose, drafts and runs. It does not use the network."""

from __future__ import annotations

import secrets
import threading
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError, KinetrussError, ModelError, StoreError
from kinetruss.io.writing import changed_text
from kinetruss.model import Model, nearest, turns
from kinetruss.studio import shown
from kinetruss.studio.dimensions import Dimensions, standing
from kinetruss.studio.dragging import Grip
from kinetruss.studio.drawing import Drawing, State, model_of, opened, read_text
from kinetruss.studio.edits import at_pose
from kinetruss.studio.files import Drafts, FileThereError, Seen, save, seen_now
from kinetruss.studio.motions import Motions
from kinetruss.studio.poses import Instant, Reached, instant, posed, present_values, range_of, reach, stand, start_of
from kinetruss.studio.requested_runs import NAME, KeyFrame, Results, frames_of, travelled, way_of, with_way
from kinetruss.units import parse

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from kinetruss.kinematics.synthesis import Linkage
    from kinetruss.studio.edits import Data

SMALL, LARGE = 262_144, 4_000_000
"""Largest size of a message of a page with sliders and of a drawing page, bytes; a text of 20,000 bars has about a million."""

Record = dict[str, Any]
Answer = bytes | Record


class Desk:
    """A model on the server, what changes it, and what pages see of it; a `Session` takes messages.

    model : the model, or None for an empty drawing of `dim` dimensions. file : its file, or None. folder : the only folder in
    which it can be saved. seen : stamp of the file when the model was read (default: its present stamp). text : YAML text of
    the model, whose comments and order a saved file keeps. drafts : keeps changes until they are saved, or None.
    results : of runs, also those of other pages.

    draw : what pages get to see. A drawing may have faults, and is shared by its pages. Otherwise it is a live model: every
    answer is a scene of a converged pose; if a pose cannot be reached, the last good pose stays, with a reason.
    key : of the page whose changes are taken up, if they were kept.
    """

    def __init__(
        self, model: Model | None = None, file: Path | None = None, folder: Path | None = None, seen: Seen | None = None,
        text: str = "", *, dim: int = 2, draw: bool = False, drafts: Drafts | None = None, results: Results | None = None,
        key: str = "",
    ) -> None:  # fmt: skip
        self.file, self.folder, self.draw, self.drafts = file, folder, draw, drafts
        self.seen = seen_now(file) if seen is None else dict(seen)
        self.lock = threading.Lock()
        self.results = results or Results()
        self.most = LARGE if draw else SMALL
        self.original = self.saved = opened(model, text, folder, dim, draw)
        self.case: str | None = None
        self.frames: Sequence[KeyFrame] = ()
        self.motions = Motions(lambda: self.drawing.revision)
        self.asked: tuple[Linkage, ...] = ()  # found for the last task
        self.grip: Grip | None = None
        self.kept = True  # False: the pose has changed since the changes were kept
        self.unkept = self.remark = self.key = ""
        self.offered = drafts.drawing() if drafts is not None and draw else None
        if self.offered is not None and self.offered[0] == self.original.text:
            self.offered = None
        if drafts is not None and draw:
            known, data = drafts.dimensions(), self.original.data
            known = standing(known, data) if self.offered is None else known  # others may be those of the autosaved drawing
            self.original = self.saved = replace(self.original, dimensions=known)
        self.drawing = Drawing(self.original, dim if model is None else model.dim)
        if not draw:
            self._begin(key)

    def _begin(self, key: str) -> None:
        """The pose of a live model, or what was kept of a page."""
        self._pose = self._start = start_of(self.model)
        record = self.drafts.take_page(key) if self.drafts is not None and key else None
        self.key = key if record is not None else secrets.token_hex(8)
        if record is not None:
            try:
                self._take_up(record)
            except InputError as error:
                self.remark = str(error)

    # -- messages --------------------------------------------------------------------------------------------------

    def first(self) -> Answer:
        """The answer to a page that has just connected."""
        with self.lock:
            return shown.first(self) if self.draw else shown.scene_of(self, self.remark)

    def shown(self, note: str = "") -> Answer:
        """What pages see of the present state."""
        return shown.drawing_of(self) if self.draw else shown.scene_of(self, note)

    # -- the model -------------------------------------------------------------------------------------------------

    @property
    def data(self) -> Data:
        """The plain data of the present state."""
        return self.drawing.state.data

    @property
    def model(self) -> Model:
        """The present model.

        Raises
        ------
        InputError : nothing is drawn, or it has faults.
        """
        if self.drawing.state.model is not None:
            return self.drawing.state.model
        found = self.drawing.found.model
        if found is None or not found.members:
            raise InputError("The drawing is no model yet: it needs nodes and bars, without faults.")
        return found

    def opened(self) -> tuple[Model, str]:
        """The present model and its text, with its comments, for a page with sliders."""
        with self.lock:
            return self.model, self.drawing.state.text

    def take(
        self, data: Data, words: str, made: Record | None = None, *, drag: int | None = None, anew: bool = False,
        lost: Data | None = None, note: str = "", dimensions: Dimensions | None = None,
    ) -> Answer:  # fmt: skip
        """Take changed data as the next step; the answer of an edit. made : what it made. lost, dimensions : as in `State`.

        Raises
        ------
        ModelError : the data have new faults. AnalysisError, InputError : a live model has no pose with them.
        """
        if not self.draw:
            self._pose = self._posed(data, words, drag, anew=anew, lost=lost)
        else:
            self.drawing.edit(data, words, drag, anew=anew, lost=lost, dimensions=dimensions)
            if drag is not None:
                return shown.drawing_of(self, light=True)
        self.keep()
        answer = self.shown(note)
        return answer | {"made": made or {}} if isinstance(answer, dict) else answer

    def _posed(
        self, data: Data, words: str, drag: int | None = None, *, typed: str | None = None, anew: bool = False,
        lost: Data | None = None,
    ) -> Reached:  # fmt: skip
        """The pose of changed data of a live model, which become the next step."""
        model = model_of(data, self.drawing.state.folder)
        pose = self._stood(model, self.model)
        self.drawing.take(data, words, drag, typed=typed, model=model, anew=anew, lost=lost)
        return pose

    def _stood(self, model: Model, before: Model) -> Reached:
        """A model closed at the drive values shown, or in equilibrium; checked for forces. before : the model of the pose."""
        if list(model.whole.nodes) != list(before.whole.nodes):
            pose = start_of(model)
        else:
            values = {}
            for name, value in present_values(model, self.pose.position).items():
                low, high, limited = range_of(model, name, self.pose.position)
                values[name] = self.pose.values.get(name, min(max(value, low), high) if limited else value)
            pose = stand(model, self.pose.position, values)
        instant(model, pose.position, self.case)
        return pose

    def write(self, text: str, words: str, drag: int | None = None, *, anew: bool = False) -> Answer:
        """Take the model of a text, a drawing even with faults; those for which it is not taken are the answer.

        anew : it is another drawing.
        """
        data, faults = read_text(text, self.folder or Path())
        if faults:
            return {"kind": "faults", "faults": shown.fault_rows(faults)}
        if data == self.data:
            self.drawing.retyped(text)
        elif self.draw:
            self.drawing.take(data, words, drag, typed=text, anew=anew)
        else:
            self._pose = self._posed(data, words, drag, typed=text)
        self.keep()
        return self.shown()

    def restore(self, text: str, words: str) -> Answer:
        """Take the model of a text that was kept.

        Raises
        ------
        ModelError : it cannot be drawn any more.
        """
        _, faults = read_text(text, self.folder or Path())
        if faults:
            raise ModelError(faults)
        return self.write(text, words)

    def step(self, by: int) -> Answer:
        """Undo (-1) or redo (1) one step."""
        before = None if self.draw else self.model
        self.drawing.step(by)
        if before is not None:
            try:
                self._pose = self._stood(self.model, before)
            except KinetrussError:
                self.drawing.step(-by)
                raise
        self.keep()
        return self.shown()

    def reset(self) -> Answer:
        """Back to the model as it was given."""
        if self.drawing.state is not self.original:
            self.drawing.put(self.original)
        self.case = None
        if not self.draw:
            self._pose = self._start = start_of(self.model)
        self.keep()
        return self.shown()

    # -- the pose --------------------------------------------------------------------------------------------------

    @property
    def pose(self) -> Reached:
        """The last good pose of a live model.

        Raises
        ------
        InputError : this is a drawing.
        """
        if self.draw:
            raise InputError("The drawing has no pose of its own. Use the page with sliders.")
        return self._pose

    def move(self, values: Mapping[str, float], fine: bool = False) -> bytes:
        """Move drives to new values, m or rad, from the last good pose; returns the state there."""
        wanted, notes = {}, []
        for name, value in values.items():
            if name not in self.pose.values:
                raise InputError(f"No drive called {name!r}. {nearest(name, self.pose.values)}")
            low, high, limited = self.limits(name)
            wanted[name] = min(max(value, low), high) if limited else value
            if wanted[name] != value:
                notes.append(f"{name} is at its limit, {wanted[name]:.6g} m.")
        if wanted:  # else only slow results are requested; the pose keeps its reason to stop
            self._pose = reach(self.model, self.pose.position, self.pose.values, wanted)
            self.kept = False  # `rest` keeps it: a slider moves many times a second
        return shown.state_of(self, " ".join(notes), fine)

    def limits(self, name: str) -> tuple[float, float, bool]:
        """Smallest and largest value of a slider, and whether they are limits of the model."""
        return range_of(self.model, name, self.pose.position)

    def instant(self, fine: bool = True) -> Instant:
        """Forces and the other results of the present pose."""
        return instant(self.model, self.pose.position, self.case, fine)

    def drives(self) -> dict[str, tuple[float, str]]:
        """Value and unit of each drive in the pose shown; none of a drawing with faults."""
        if not self.draw:
            model, values = self.model, self.pose.values
        else:
            found = self.drawing.found
            if found.model is None:
                return {}
            model, values = found.model, found.drives
        return {name: (value, "rad" if turns(model.all_drives[name]) else "m") for name, value in values.items()}

    def closed(self) -> tuple[Model, NDArray[np.float64]]:
        """The model and the pose shown.

        Raises
        ------
        InputError : a drawing that is not closed.
        """
        if not self.draw:
            return self.model, self.pose.position
        found = self.drawing.found
        if found.model is None or found.position is None or found.apart:
            raise InputError("No motion: the drawing is no closed model yet.")
        return found.model, found.position

    def carry(self, places: Mapping[str, Sequence[Any]], drag: int | None) -> Answer:
        """Nodes of a drawing dragged to places, m or text with units, with all lengths kept; drives follow.

        Raises
        ------
        InputError : unknown nodes, or this is no closed drawing.
        """
        if not self.draw:
            raise InputError("This message is for a drawing.")
        if self.grip is None or drag is None or self.grip.number != drag or self.drawing.state.drag not in (None, drag):
            self.grip = Grip(self.data, *self.closed(), drag)
        wanted = {name: [float(parse(value, "length")) for value in place] for name, place in places.items()}
        data = at_pose(self.grip.data, self.grip.model, self.grip.to(wanted))
        if data == self.data:
            return shown.drawing_of(self, light=drag is not None)
        return self.take(data, f"moving {', '.join(list(places)[:3])}", drag=drag)

    def put(self, values: Mapping[str, float]) -> Answer:
        """The drawing in the pose of these drive values, m or rad.

        Raises
        ------
        InputError : it cannot be reached, or this is no closed drawing.
        """
        model, position = self.closed()
        now = {name: value for name, (value, _) in self.drives().items()}
        if unknown := [name for name in values if name not in now]:
            raise InputError(f"No drive called {unknown[0]!r}. {nearest(unknown[0], now)}")
        found = reach(model, position, now, values)
        if found.stopped:
            raise InputError(found.stopped)
        return self.take(at_pose(self.data, model, found.position), "the other pose")

    def follow(self, frames: Sequence[KeyFrame], samples: int) -> bytes:
        """Follow key frames; returns a scene of the run and its worst instants."""
        model = posed(self.model, self.pose.position, self.pose.values)  # otherwise the run could start on another branch
        result = travelled(model, frames, self.pose.values, samples)
        if not result.good:
            raise InputError(f"The motion cannot start: {result.message}")
        return shown.run_of(result)

    # -- files -----------------------------------------------------------------------------------------------------

    def save(self, name: str, *, pose: bool = False, replace: bool = False, frames: Sequence[KeyFrame] = ()) -> Record:
        """Save the model in the folder; if that would replace another file, return a question instead."""
        before = model = self._to_save()
        if len(frames) > 1 and self.pose.values:
            model = with_way(model, way_of(frames, self.pose.values))
        if pose:
            model = posed(model, self.pose.position, self.pose.values)
        text: str | None = None
        if self.draw or self.original.typed is not None:
            text = self.drawing.state.text
            if model is not before and self.folder is not None:
                text = changed_text(text, before, model, self.folder)
        try:
            path = save(model, self.folder, name, self.seen, replace=replace, text=text)
        except FileThereError as there:
            return {"kind": "exists", "message": str(there)}
        words = f"Written: {path.name}" + (f", key frames as run {NAME!r}" if NAME in model.runs and not self.draw else "")
        if self.drafts is not None and text is not None:
            try:
                self.drafts.add(text, f"saved as {path.name}")
            except StoreError as error:  # the file is written
                words = f"{words}, but no version was kept: {str(error).rstrip('.')}"
        if not self.draw:
            self._put(None)
            gone = ", ".join(self.lost)
            left = f" Removed, because they depend on members that changed: {gone}." if gone else ""
            return {"kind": "saved", "message": f"{words}.{left}"}
        self.file, self.saved = path, self.drawing.state
        self._put(None)
        if self.drafts is not None:
            self.drafts.copy_picture(path)
            self.drafts.keep_dimensions(self.saved.dimensions, path)
        return shown.drawing_of(self) | {"saved": f"{words}."}

    def _to_save(self) -> Model:
        model = self.drawing.state.model or self.drawing.found.model
        if model is None:
            raise InputError("A model with faults is not saved; it is kept beside the file. Mend the faults first.")
        return model

    @property
    def dirty(self) -> bool:
        """Whether the file would be another one; dimensions are no part of it."""
        state, saved = self.drawing.state, self.saved
        return state is not saved and (state.data is not saved.data or state.text != saved.text)

    @property
    def lost(self) -> list[str]:
        """Entries that depend on members that changed, and are not in the model now."""
        return [f"{table}.{name}" for table, rows in self.drawing.state.lost.items() for name in rows]

    def kept_in(self) -> Drafts:
        """The side files.

        Raises
        ------
        InputError : there are none.
        """
        if self.drafts is None:
            raise InputError("No folder was chosen to write to.")
        return self.drafts

    # -- what is kept until it is saved ----------------------------------------------------------------------------

    def rest(self) -> None:
        """Keep the pose, if it has changed since the changes were kept."""
        if not self.kept:
            self.keep()

    def keep(self) -> None:
        """Keep the changes beside the file, if there are any; a draft that nobody has taken up becomes a version.

        Raises
        ------
        StoreError : those of a drawing cannot be written.
        """
        state = self.drawing.state
        if not self.draw:
            same = state is self.original and self.case is None and not self.frames and self._pose is self._start
            self._put(None if same else self._record())
            return
        if self.drafts is not None and state.dimensions != self.drafts.dimensions():
            self.drafts.keep_dimensions(state.dimensions, self.file)
        if self.drafts is not None and (self.dirty or self.offered is None):
            if self.offered is not None:
                self.drafts.add(self.offered[0], "left by an earlier studio")
                self.offered = None
            self._put(state.text if self.dirty else None)

    def _put(self, draft: Any) -> None:
        self.kept, self.unkept = True, ""
        if self.drafts is None:
            return
        if self.draw:
            self.drafts.keep_drawing(draft)
            return
        try:
            self.drafts.keep_page(self.key, draft)
        except StoreError as error:
            self.unkept = f"The changes cannot be kept beside the file: {error}"

    def _record(self) -> Record:
        """Everything that a later page needs to go on with this live model, for JSON."""
        return {
            "original": self.original.data,
            "text": self.original.typed or "",
            "model": self.data,
            "case": self.case,
            "lost": self.drawing.state.lost,
            "values": self.pose.values,
            "position": self.pose.position.tolist(),
            "frames": [frame.model_dump() for frame in self.frames],
        }

    def _take_up(self, record: Record) -> None:
        """Go on with a record; where the file has changed since, the record's own model stays the one to return to.

        Raises
        ------
        InputError : it is no such record, or its pose cannot be closed; nothing is changed.
        """
        folder = self.original.folder
        try:
            first, data = record["original"], record["model"]
            original, model = (model_of(one, folder) for one in (first, data))
            position = np.array(record["position"], dtype=float)
            if position.shape != (len(model.whole.nodes), model.dim):
                raise ValueError
            pose = stand(model, position, {str(name): float(value) for name, value in record["values"].items()})
            case = None if record["case"] is None else str(record["case"])
            instant(model, pose.position, case)
            frames, lost, text = frames_of(record["frames"]), dict(record["lost"] or {}), str(record["text"])
        except (KinetrussError, KeyError, TypeError, ValueError, AttributeError) as error:
            why = f" {error}" if isinstance(error, KinetrussError) else ""
            raise InputError(f"The changes that were kept cannot be shown.{why}") from None
        if original != model_of(self.original.data, folder):
            self.original = State(first, text or None, folder=folder, within=False, model=original)
            self.drawing = Drawing(self.original, original.dim)
            self.seen = {}  # saving over the changed file takes a confirmation
            self.remark = "The file has changed since these changes were made: they are those of the earlier file."
        if data != self.original.data:
            self.drawing.take(data, "the changes that were kept", model=model, lost=lost)
        self.case, self.frames, self._pose = case, frames, pose

    def draft(self, keep: bool) -> Answer:
        """Take up or remove what a page of an earlier studio has left."""
        if self.draw:
            offered, self.offered = self.offered, None
            if offered is None:
                raise InputError("There is no autosaved drawing.")
            if keep:
                return self.restore(offered[0], "the autosaved drawing")
            self.drawing.state = replace(self.drawing.state, dimensions=standing(self.drawing.state.dimensions, self.data))
            self.keep()
            return self.shown()
        if self.drafts is None or not self.drafts.left:
            raise InputError("There are no changes of an earlier page.")
        key = self.drafts.left[0][0]
        if keep:
            record = self.drafts.take_page(key)
            if record is None:
                raise InputError("The changes of the earlier page cannot be read any more.")
            self._take_up(record)
            self.keep()
        self.drafts.keep_page(key, None)
        return self.shown(self.remark)
