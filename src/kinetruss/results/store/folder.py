"""The folder of a run: how it is recognised, its ledger, and what may be replaced in it."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss.errors import InputError
from kinetruss.results.store.lock import LOCK, check_unlocked, holding, is_locked
from kinetruss.results.store.refused import FULL, cause_and_mend

if TYPE_CHECKING:
    from kinetruss.results.store.lock import Lock

__all__ = ["Ledger", "check_target", "claimed", "is_locked", "is_store"]

LEDGER = "kinetruss.json"
MODEL = "model.json"
FORMAT = 1
ARRAYS = "results.zarr"
PACKED = "results.zarr.zip"
PICTURES = "pictures"
"""Folder in a run folder that its pictures go to."""
REPORT = "report"
"""Folder in a run folder that its report goes to."""
STATE = "state"
DRAFT = ".kinetruss.part"
"""What a run in one file is made in, in its folder; a process that was killed may leave it."""
OWN = (MODEL, ARRAYS, PACKED, PICTURES, REPORT, STATE, LEDGER)


@dataclass(frozen=True, slots=True, kw_only=True)
class Ledger:
    """What is known of a stored run.

    committed, samples : good samples, and samples asked for.
    state : ``writing`` until the end; then ``finished``.
    status, message : of a finished run, the name of a `Status` and its details; of an interrupted one, INTERRUPTED.
    """

    run: str
    samples: int
    block: int
    committed: int = 0
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
        """True when the run ended and every sample is good, or an event that was to end it did."""
        return self.state == "finished" and (self.committed == self.samples or self.status == "EVENT")


def is_store(path: Path) -> bool:
    """True for a folder made by this package: its ledger says so."""
    try:
        return bool(read_ledger(path).get("kinetruss_run"))
    except (OSError, ValueError, AttributeError):
        return False


def read_ledger(path: Path) -> dict[str, Any]:
    """The ledger as plain data."""
    record: dict[str, Any] = json.loads((path / LEDGER).read_text("utf-8"))
    return record


def check_target(path: Path, overwrite: bool) -> None:
    """Refuse an output folder that would lose something, whoever writes it.

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
    if all(item.name in (LOCK, DRAFT) for item in path.iterdir()):
        return  # what a process that was killed has left
    if is_store(path) and not overwrite:
        raise InputError(f"{path} holds a run already. Name another folder, or replace it with --overwrite (overwrite=True).")
    if not is_store(path):
        raise InputError(
            f"{path} is not empty and is no kinetruss run, so it is never overwritten. Name another folder, "
            "or empty it yourself."
        )


@contextmanager
def claimed(path: Path, overwrite: bool) -> Iterator[Lock]:
    """A folder held for one run, from before its first sample is computed; nothing in it is touched.

    A folder that is made for it goes again where nothing is written.

    Raises
    ------
    StoreError : another process writes it, or it cannot be written. InputError : see `check_target`.
    """
    check_unlocked(path)
    check_target(path, overwrite)
    with holding(path) as held:
        check_target(path, overwrite)  # another process may have been faster
        yield held


def write_ledger(path: Path, ledger: Ledger) -> None:
    """Replace the ledger in one step: a reader sees the old one or the new one."""
    atomic(path / LEDGER, ledger_text(ledger))


def ledger_text(ledger: Ledger) -> str:
    """The ledger as it is written."""
    return json.dumps({name: getattr(ledger, name) for name in ledger.__slots__}, indent=1, default=str)


def atomic(target: Path, text: str, *, durable: bool = True) -> None:
    """Replace a file in one step; `durable` also waits until the disk has it."""
    draft = target.with_name(target.name + ".part")
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


def clear(path: Path, *, ledger: bool = True) -> None:
    """Remove what a run wrote; other files stay.

    The model goes first, so that nobody goes on with half a run; the ledger last or not at all, so that a kill leaves the
    folder recognisable.
    """
    for name in OWN if ledger else OWN[:-1]:
        target = path / name
        if target.is_dir() and not target.is_symlink():
            shutil.rmtree(target)
        else:
            target.unlink(missing_ok=True)


def failure(path: Path, ledger: Ledger, error: OSError) -> str:
    """What the disk said, what is kept, and the mend."""
    cause, mend = cause_and_mend(error)
    cause = f"the disk is full ({cause})" if error.errno in FULL else cause
    if not _keeps(path, ledger):
        return f"{path}: {cause}. The run is no longer in it as it was written: something else changed it. Run it again."
    kept = f"{ledger.committed} of {ledger.samples} samples are kept in it and good"
    go_on = f"go on with: kinetruss run --resume {path}" if ledger.committed else "run it again with --overwrite."
    return f"{path}: {cause}; {kept}. {f'{mend} and {go_on}' if mend else go_on[0].upper() + go_on[1:]}"


def _keeps(path: Path, ledger: Ledger) -> bool:
    """Whether the folder still has what the ledger counts."""
    if not ledger.committed:
        return path.is_dir()
    try:
        return bool(read_ledger(path)["committed"] == ledger.committed) and (path / MODEL).is_file()
    except (OSError, ValueError, KeyError):
        return False
