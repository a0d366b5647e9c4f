"""The session of one page: a model, its last good pose, and the commands on them. It does not use the network."""

from __future__ import annotations

import secrets
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from kinetruss.errors import InputError, KinetrussError, StoreError
from kinetruss.io.emitting import plain_model
from kinetruss.io.writing import changed_text
from kinetruss.mechanics import compile
from kinetruss.model import Active, LengthDrive, Model, NodalForce, nearest, turns
from kinetruss.studio import commands as say
from kinetruss.studio.edits import (
    FileThereError,
    Seen,
    posed,
    role_of,
    save,
    seen_now,
    switched,
    with_gravity,
    with_load,
    with_mass,
)
from kinetruss.studio.poses import Instant, Reached, framed, instant, number, present_values, reach, stand, start_of
from kinetruss.studio.travel import NAME, travelled, way_of, with_way, worst_rows
from kinetruss.viewer import pack, scene

Answer = bytes | dict[str, Any]


class Shelf(Protocol):
    """Keeps the changes of pages beside the file: the desk of a studio."""

    def page_left(self) -> tuple[str, float] | None:
        """Key and time of the changes that a page of an earlier studio has left."""

    def take_page(self, key: str) -> dict[str, Any] | None:
        """The changes of a page."""

    def keep_page(self, key: str, record: dict[str, Any] | None) -> None:
        """Keep or remove the changes of a page."""


class Session:
    """A live model: messages in, messages out.

    model : the model shown. file : its file, or None. folder : the only folder in which it can be saved.
    seen : stamp of the file when the model was read (default: its present stamp). text : YAML text of the model, whose
    comments and order a saved file keeps. shelf : keeps the changes until they are saved, or None. key : of the page whose
    changes are taken up, if they were kept.

    Every answer is based on a converged pose. If a pose cannot be reached, the last good pose stays, with a reason.
    """

    def __init__(
        self, model: Model, file: Path | None = None, folder: Path | None = None, seen: Seen | None = None, text: str = "",
        *, shelf: Shelf | None = None, key: str = "",
    ) -> None:  # fmt: skip
        self.original = model
        self.text = text
        self.file = file
        self.folder = folder
        self.seen = seen_now(file) if seen is None else dict(seen)
        self.shelf = shelf
        self.frames: list[say.KeyFrame] = []
        self.kept = True  # False: the pose has changed since the changes were kept
        self.unkept = self.remark = ""
        self.restart()
        record = shelf.take_page(key) if shelf is not None and key else None
        self.key = key if record is not None else secrets.token_hex(8)
        if record is not None:
            try:
                self.take(record)
            except InputError as error:
                self.remark = str(error)

    def restart(self) -> None:
        """Start again with the model as it was given."""
        self.model = self.original
        self.case: str | None = None
        self.lost: list[str] = []
        self.pose: Reached = start_of(self.model)
        self.start = self.pose

    # -- messages --------------------------------------------------------------------------------------------------

    def answer(self, text: str | bytes) -> Answer:
        """The answer to one message: bytes (a scene, a state) or a record for JSON. Errors become records too."""
        try:
            return self.do(say.command_of(text))
        except KinetrussError as error:
            return {"kind": "error", "message": str(error)}

    def do(self, command: Any) -> Answer:
        """Do one command."""
        match command:
            case say.Move():
                return self.move(command.values, command.fine)
            case say.Query():
                return self.query()
            case say.Run():
                return self.run(command)
            case say.Save():
                return self.save(command)
            case say.Case():
                if command.name is not None and command.name not in self.model.load_cases:
                    raise InputError(f"No load case called {command.name!r}. {nearest(command.name, self.model.load_cases)}")
                self.case = command.name
            case say.Reset():
                self.restart()
            case say.Frames():
                self.frames = command.frames
                self.keep()
                return {"kind": "kept"}
            case say.Draft():
                return self.draft(command.keep)
            case say.Live():
                return self.scene()
            case _:
                self.edit(command)
        self.keep()
        return self.scene(say.doubt(command))

    def move(self, values: dict[str, float], fine: bool = False) -> bytes:
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
            self.pose = reach(self.model, self.pose.position, self.pose.values, wanted)
            self.kept = False  # `rest` keeps it: a slider moves many times a second
        return self.state(" ".join(notes), fine)

    def edit(self, command: Any) -> None:
        """Change the model; if the new one has no valid pose, nothing is changed."""
        model, lost = self.model, self.lost
        match command:
            case say.Gravity():
                model = with_gravity(model, command.value)
            case say.Load():
                model = with_load(model, command.name, command.node, command.force)
            case say.Mass():
                model = with_mass(model, command.node, command.mass)
            case say.Switch():
                model, lost = switched(model, self.original, self.pose.position, command.member, command.to)
        pose = self._stand(model)
        instant(model, pose.position, self.case)
        self.model, self.lost, self.pose = model, lost, pose

    def _stand(self, model: Model) -> Reached:
        """The new model closed at the drive values shown, or in equilibrium."""
        values = {}
        for name, value in present_values(model, self.pose.position).items():
            low, high, limited = self.limits(name, model)
            values[name] = self.pose.values.get(name, min(max(value, low), high) if limited else value)
        return stand(model, self.pose.position, values)

    def run(self, command: say.Run) -> bytes:
        """Follow the key frames; returns a scene of the run and its worst instants."""
        shown = posed(self.model, self.pose.position, self.pose.values)  # otherwise the run could start on another branch
        result = travelled(shown, command.frames, self.pose.values, command.samples)
        if not result.good:
            raise InputError(f"The motion cannot start: {result.message}")
        note = "" if result.status.ok else f"{result.status.value} {result.message}"
        return framed({"kind": "run", "worst": worst_rows(result), "note": note}, pack(scene(result)))

    def save(self, command: say.Save) -> dict[str, Any]:
        """Save the model in the folder; if that would replace another file, return a question instead."""
        model = self.model
        if len(command.frames) > 1 and self.pose.values:
            model = with_way(model, way_of(command.frames, self.pose.values), 201)
        if command.pose:
            model = posed(model, self.pose.position, self.pose.values)
        try:
            text = changed_text(self.text, self.original, model, self.folder) if self.text and self.folder else None
            path = save(model, self.folder, command.name, self.seen, replace=command.replace, text=text)
        except FileThereError as there:
            return {"kind": "exists", "message": str(there)}
        words = f"Written: {path.name}" + (f", key frames as run {NAME!r}" if NAME in model.runs else "")
        self._put(None)
        left = f" Removed, because they depend on members that changed: {', '.join(self.lost)}." if self.lost else ""
        return {"kind": "saved", "message": f"{words}.{left}"}

    # -- what is kept ----------------------------------------------------------------------------------------------

    def rest(self) -> None:
        """Keep the pose, if it has changed since the changes were kept."""
        if not self.kept:
            self.keep()

    def keep(self) -> None:
        """Keep the changes beside the file, if there are any."""
        same = self.model is self.original and self.case is None and not self.frames and self.pose is self.start
        self._put(None if same else self.record())

    def _put(self, record: dict[str, Any] | None) -> None:
        self.kept, self.unkept = True, ""
        try:
            if self.shelf is not None:
                self.shelf.keep_page(self.key, record)
        except StoreError as error:
            self.unkept = f"The changes cannot be kept beside the file: {error}"

    def record(self) -> dict[str, Any]:
        """Everything that a later page needs to go on with this one, for JSON."""
        return {
            "original": plain_model(self.original),
            "text": self.text,
            "model": plain_model(self.model),
            "case": self.case,
            "lost": self.lost,
            "values": self.pose.values,
            "position": self.pose.position.tolist(),
            "frames": [frame.model_dump() for frame in self.frames],
        }

    def take(self, record: dict[str, Any]) -> None:
        """Go on with a record; where the file has changed since, the record's own model stays the one to return to.

        Raises
        ------
        InputError : it is no such record, or its pose cannot be closed; nothing is changed.
        """
        try:
            original, model = Model(**record["original"]), Model(**record["model"])
            position = np.array(record["position"], dtype=float)
            if position.shape != (len(model.nodes), model.dim):
                raise ValueError
            values = {str(name): float(value) for name, value in record["values"].items()}
            pose = stand(model, position, values)
            case = None if record["case"] is None else str(record["case"])
            instant(model, pose.position, case)
            frames, lost, text = say.frames_of(record["frames"]), [str(one) for one in record["lost"]], str(record["text"])
        except (KinetrussError, KeyError, TypeError, ValueError, AttributeError) as error:
            why = f" {error}" if isinstance(error, KinetrussError) else ""
            raise InputError(f"The changes that were kept cannot be shown.{why}") from None
        if original != self.original:
            self.original, self.text = original, text
            self.seen = {}  # saving over the changed file takes a confirmation
            self.remark = "The file has changed since these changes were made: they are those of the earlier file."
        self.model = self.original if model == self.original else model
        self.case, self.lost, self.frames, self.pose = case, lost, frames, pose

    def draft(self, keep: bool) -> bytes:
        """Take up or remove the changes that a page of an earlier studio has left."""
        left = self.shelf.page_left() if self.shelf is not None else None
        if self.shelf is None or left is None:
            raise InputError("There are no changes of an earlier page.")
        if keep:
            record = self.shelf.take_page(left[0])
            if record is None:
                raise InputError("The changes of the earlier page cannot be read any more.")
            self.take(record)
            self.keep()
        self.shelf.keep_page(left[0], None)
        return self.first()

    # -- what is shown ---------------------------------------------------------------------------------------------

    def instant(self, fine: bool = True) -> Instant:
        """Forces and the other results of the present pose."""
        return instant(self.model, self.pose.position, self.case, fine)

    def first(self) -> bytes:
        """The scene of a page that has just connected."""
        return self.scene(self.remark)

    def scene(self, note: str = "") -> bytes:
        """The whole scene, and everything that can be changed."""
        now = self.instant()
        picture = scene(now.forces, model=self.model)
        return framed({"kind": "scene", "setup": self.setup(), "state": self._state(now, note)}, pack(picture))

    def state(self, note: str = "", fine: bool = False) -> bytes:
        """The present pose: drive values in the header, positions and forces as float32 after it."""
        now = self.instant(fine)
        blocks = {name: np.ascontiguousarray(values, "<f4") for name, values in now.arrays.items() if name != "time"}
        table = [[name, values.size] for name, values in blocks.items()]
        header = {"kind": "state", "state": self._state(now, note), "arrays": table}
        return framed(header, *(values.tobytes() for values in blocks.values()))

    def _state(self, now: Instant, note: str) -> dict[str, Any]:
        return {
            "values": self.pose.values,
            "gauge": number(self.pose.gauge),
            "stopped": self.pose.stopped,
            "note": " ".join(filter(None, [note, self.unkept, self.pose.note, now.forces.message])),
            "demand": now.demand,
            "mobility": now.mobility,
            "alarms": now.alarms,
            "verdict": now.verdict,
        }

    def query(self) -> dict[str, Any]:
        """All numbers of the present pose in double precision."""
        data = self.instant().forces.data
        names = [name for name in ("member_force", "reaction", "drive_force", "end_force", "joint_force") if name in data]
        return {
            "kind": "numbers",
            "values": self.pose.values,
            "position": self.pose.position.tolist(),
            "stopped": self.pose.stopped,
            "gauge": number(self.pose.gauge),
            "members": list(self.model.members),
            "nodes": list(self.model.nodes),
            **{name: data[name].values[0].tolist() for name in names},
        }

    def limits(self, name: str, model: Model | None = None) -> tuple[float, float, bool]:
        """Smallest and largest value of a slider, and whether they are limits of the model."""
        model = model or self.model
        drive = model.all_drives[name]
        system = compile(model)
        start = float(system.drive_start[list(system.drives).index(name)])
        if isinstance(drive, LengthDrive):
            member = model.members[drive.bar]
            if isinstance(member, Active) and member.limits is not None:
                return (*member.limits, True)
            return 0.6 * start, 1.5 * start, False
        reach = np.pi if turns(drive) else 0.5 * float(np.ptp(self.pose.position, axis=0).max())
        return start - reach, start + reach, False

    def setup(self) -> dict[str, Any]:
        """The data for the controls of the page."""
        model = self.model
        left = self.shelf.page_left() if self.shelf is not None else None
        drives = []
        for name, drive in model.all_drives.items():
            low, high, limited = self.limits(name)
            drives.append({"name": name, "unit": "rad" if turns(drive) else "m", "low": low, "high": high, "limited": limited})
        loads = [
            {"name": name, "node": load.node, "force": None if load.force is None else list(load.force)}
            for name, load in model.loads.items()
            if isinstance(load, NodalForce)
        ]
        return {
            "drives": drives,
            "loads": loads,
            "dim": model.dim,
            "gravity": list(model.gravity or (0.0,) * model.dim),
            "masses": {name: node.mass for name, node in model.nodes.items()},
            "nodes": list(model.nodes),
            "members": [
                {"name": name, "role": role_of(model, name), "own": role_of(self.original, name)}
                for name in self.original.members
            ],
            "cases": list(model.load_cases),
            "case": self.case,
            "file": "" if self.file is None else self.file.name,
            "writable": self.folder is not None,
            "lost": self.lost,
            "page": self.key if self.shelf is not None else "",
            "offer": None if left is None else left[1],
            "frames": [frame.model_dump() for frame in self.frames],
        }
