"""The folder of a run: how it is recognised, its ledger, and what may be replaced in it."""

from __future__ import annotations

import errno
import json
import os
import shutil
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError, StoreError

__all__ = ["Ledger", "check_target", "is_locked", "is_store"]

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
OWN = (ARRAYS, PACKED, PICTURES, REPORT, STATE, MODEL, LEDGER)


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
    """Refuse an output folder that would lose something.

    Raises
    ------
    InputError : it is a file, or a folder that is neither empty nor (with `overwrite`) a run of this package.
    """
    if not path.exists():
        return
    if not path.is_dir():
        raise InputError(f"{path} is a file. Name a folder for the run.")
    if not any(path.iterdir()):
        return
    if is_store(path) and not overwrite:
        raise InputError(f"{path} holds a run already. Name another folder, or replace it with --overwrite (overwrite=True).")
    if not is_store(path):
        raise InputError(
            f"{path} is not empty and is no kinetruss run, so it is never overwritten. Name another folder, "
            "or empty it yourself."
        )


def is_locked(path: Path) -> bool:
    """True while a process writes the run."""
    try:
        handle = lock(path)
    except StoreError:
        return True
    if handle is not None:
        os.close(handle)
    return False


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


def lock(path: Path) -> int | None:
    """Hold the ledger's folder for one writer; freed by the system when the process ends, however it ends."""
    try:
        import fcntl
    except ImportError:  # Windows: one writer at a time is left to the user
        return None
    handle = os.open(path, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(handle)
        raise StoreError(f"{path} is being written by another process. Wait for it, or name another folder.") from None
    return handle


def clear(path: Path) -> None:
    """Remove what a run wrote, the ledger last, so that a kill leaves it recognisable; other files stay."""
    for name in OWN:
        target = path / name
        if target.is_dir() and not target.is_symlink():
            shutil.rmtree(target)
        else:
            target.unlink(missing_ok=True)


def failure(path: Path, ledger: Ledger, error: OSError) -> str:
    """What the disk said, what is kept, and the mend."""
    full = error.errno in (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
    cause = f"the disk is full ({error.strerror})" if full else f"{error.strerror or error}"
    kept = f"{ledger.committed} of {ledger.samples} samples are kept in it and good"
    go_on = (
        f" Make room and go on with: kinetruss run --resume {path}"
        if ledger.committed
        else " Make room and run it again with --overwrite."
    )
    return f"{path}: {cause}; {kept}.{go_on}"
