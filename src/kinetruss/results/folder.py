"""The folder of a run: how it is recognised, its ledger and which files may be replaced; files that appear whole."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError
from kinetruss.results.lock import FULL, LOCK, cannot_write, cause_and_mend, check_unlocked, holding

if TYPE_CHECKING:
    from kinetruss.results.lock import Lock


Stamp = tuple[int, int]
"""Number of the file on its disk, and the time of its last change, ns."""


def stamp_of(file: Path) -> Stamp | None:
    """The stamp of a file; None if it does not exist."""
    try:
        found = file.stat()
    except OSError:
        return None
    return found.st_ino, found.st_mtime_ns


# The folder of a run: how it is recognised, its ledger, and which files may be replaced.

LEDGER = "kinetruss.json"
MODEL = "model.json"
FORMAT = 2
ARCHIVE = "results.zarr.zip"
ARRAYS = "results.zarr"
"""Folder of the arrays before format 2; a short variant had an archive."""
PICTURES = "pictures"
"""Folder of the pictures in a run folder."""
REPORT = "report"
"""Folder of the report in a run folder."""
STATE = "state"
DRAFT = ".kinetruss.part"
"""The archive of a short variant until it is complete; a killed process may leave it."""
PART = ".part"
"""End of the name of a file until it is complete; a killed process may leave it."""
LEFT = (LOCK, DRAFT, LEDGER + PART, MODEL + PART)
"""What a process that is killed before its ledger stands may leave in a folder."""
OWN = (MODEL, ARCHIVE, ARRAYS, PICTURES, REPORT, STATE, DRAFT, MODEL + PART, LEDGER)


@dataclass(frozen=True, slots=True, kw_only=True)
class Ledger:
    """The state of a stored run.

    committed, samples : good samples, and requested samples. length : bytes of the archive that hold them.
    state : ``writing`` until the end; then ``finished``.
    status, message : for a finished run, the name of a `Status` and its details; for an interrupted one, INTERRUPTED.
    """

    run: str
    samples: int
    block: int
    committed: int = 0
    length: int = 0
    state: str = "writing"
    status: str = ""
    message: str = ""
    model_hash: str = ""
    wall_time: float = 0.0
    options: Mapping[str, Any]
    provenance: Mapping[str, Any]
    kinetruss_run: int = FORMAT

    @property
    def whole(self) -> bool:
        """True if the run ended and every sample is good, or an event stopped it as requested."""
        return self.state == "finished" and (self.committed == self.samples or self.status == "EVENT")


def is_store(path: Path) -> bool:
    """True for a folder made by this package, recognised by its ledger."""
    try:
        return bool(read_ledger(path).get("kinetruss_run"))
    except (OSError, ValueError, AttributeError):
        return False


def read_ledger(path: Path) -> dict[str, Any]:
    """The ledger as plain data."""
    record: dict[str, Any] = json.loads((path / LEDGER).read_text("utf-8"))
    return record


def check_target(path: Path, overwrite: bool) -> None:
    """Raise an error if writing to a folder would lose data.

    Raises
    ------
    InputError : a file, a link to nothing, or a folder that is neither empty nor (with `overwrite`) a run of this package.
    """
    if not path.exists():
        if path.is_symlink():
            raise InputError(f"{path} is a link to {path.readlink()}, which is not there. Make that folder, or name another.")
        return
    if not path.is_dir():
        raise InputError(f"{path} is a file. Name a folder for the run.")
    if all(item.name in LEFT for item in path.iterdir()):
        return
    if is_store(path) and not overwrite:
        raise InputError(f"{path} holds a run already. Name another folder, or replace it with --overwrite (overwrite=True).")
    if not is_store(path):
        raise InputError(
            f"{path} is not empty and is not a kinetruss run, so it is never overwritten. Name another folder, "
            "or empty it yourself."
        )


@contextmanager
def claimed(path: Path, overwrite: bool) -> Iterator[Lock]:
    """Lock a folder for one run before its first sample is computed; its files are not changed.

    A folder that was made for the run is removed again if nothing is written.

    Raises
    ------
    StoreError : another process writes it, or it cannot be written. InputError : see `check_target`.
    """
    check_unlocked(path)
    check_target(path, overwrite)
    with holding(path) as held:
        check_target(path, overwrite)  # another process may have been faster
        yield held


def write_ledger(path: Path, ledger: Ledger, *, durable: bool = True) -> None:
    """Replace the ledger in one step: a reader sees the old one or the new one."""
    record = {name: getattr(ledger, name) for name in ledger.__slots__}
    atomic(path / LEDGER, json.dumps(record, indent=1, default=str), durable=durable)


def atomic(target: Path, text: str, *, durable: bool = True) -> None:
    """Replace a file in one step; `durable` also waits until the disk has it."""
    draft = target.with_name(target.name + PART)
    try:
        with draft.open("w", encoding="utf-8") as file:
            file.write(text)
            if durable:
                file.flush()
                os.fsync(file.fileno())
        draft.replace(target)
    except OSError:
        with suppress(OSError):
            draft.unlink(missing_ok=True)
        raise


@contextmanager
def whole_file(path: Path) -> Iterator[Path]:
    """A temporary file in the folder of `path`, which is made if needed; at the end it replaces `path`.

    If writing fails, the temporary file is removed and an old file at `path` stays. A pipe or a device is written directly.

    Raises
    ------
    StoreError : the file cannot be written.
    """
    draft = path.with_name(f".{path.stem}.{os.getpid()}.part{path.suffix}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.exists() and not (path.is_file() or path.is_dir()):
            yield path
        else:
            yield draft
            draft.replace(path)
    except OSError as error:
        raise cannot_write(path, error) from error
    finally:
        with suppress(OSError):
            draft.unlink(missing_ok=True)


def clear(path: Path, keep: Collection[str] = ()) -> None:
    """Remove the files of a run, except some; other files stay.

    The model is removed first, so that nobody continues half a run; the ledger last or not at all, so that the folder is
    still recognised after a kill.
    """
    for name in OWN:
        if name not in keep:
            remove(path / name)


def remove(target: Path) -> None:
    """Remove a file or a folder, if it is there; of a link the link."""
    if target.is_dir() and not target.is_symlink():
        shutil.rmtree(target)
    else:
        target.unlink(missing_ok=True)


def failure(path: Path, ledger: Ledger, error: OSError) -> str:
    """The error of the disk, the samples that are kept, and the fix."""
    cause, mend = cause_and_mend(error)
    cause = f"the disk is full ({cause})" if error.errno in FULL else cause
    if not _keeps(path, ledger):
        return f"{path}: {cause}. The run in it was changed by another program. Run it again."
    kept = f"{ledger.committed} of {ledger.samples} samples are kept in it and good"
    go_on = f"continue with: kinetruss run --resume {path}" if ledger.committed else "run it again with --overwrite."
    return f"{path}: {cause}; {kept}. {f'{mend} and {go_on}' if mend else go_on[0].upper() + go_on[1:]}"


def _keeps(path: Path, ledger: Ledger) -> bool:
    """True if the folder still has all samples that the ledger counts."""
    if not ledger.committed:
        return path.is_dir()
    try:
        return bool(read_ledger(path)["committed"] == ledger.committed) and (path / MODEL).is_file()
    except (OSError, ValueError, KeyError):
        return False
