"""One writer per run folder: a lock that the system frees when its process ends; errors of a disk that refuses to write."""

from __future__ import annotations

import errno
import json
import os
import socket
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from kinetruss.errors import StoreError

FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
FORBIDDEN = (errno.EACCES, errno.EPERM)


def cause_and_mend(error: OSError) -> tuple[str, str]:
    """Cause and fix if a file or folder cannot be written, each without a full stop."""
    said = error.strerror or str(error)
    if error.errno in FULL:
        return said, "Make room"
    if error.errno in FORBIDDEN:
        return said, "Allow this user to write there"
    if error.errno == errno.EROFS:
        return said, "Make the file system writable"
    return said, ""


def cannot_write(path: Path, error: OSError) -> StoreError:
    """The error for a path that cannot be written."""
    cause, mend = cause_and_mend(error)
    return StoreError(f"{path} cannot be written: {cause}. {f'{mend}, or name' if mend else 'Name'} another place.")


# One writer per run folder: a lock that the system frees when its process ends, and a note on its holder.
#
#     OUT/kinetruss.lock     while a process writes the run: its number, its machine, since when
#
# The lock is the system's (flock) on that file, so the file of a killed process blocks nobody, and over NFS the lock works
# between machines. If a file system has no locks, the note decides: a living process, or one on another machine, holds the
# folder. The file is removed when its writer ends.

LOCK = "kinetruss.lock"
_HANDLES = Path("/proc/self/fd")
TRIES, PAUSE = 25, 0.02
"""How often a lock is tried, and seconds between: one who only asks for the writer holds it for some microseconds."""


@dataclass(eq=False)
class Lock:
    """A folder held by this process. handle : of the lock file. place : of the folder, on systems with paths by handles."""

    path: Path
    handle: int | None
    process: int
    place: int | None = None

    @property
    def folder(self) -> Path:
        """A path that leads to the held folder even after it was renamed and another one took its name; elsewhere `path`.

        What is written there after a check lands in no other run's folder.
        """
        return self.path if self.place is None else _HANDLES / str(self.place)

    def check(self) -> None:
        """Raise an error if the folder is no longer the one that was locked.

        Raises
        ------
        StoreError : the folder, or the lock in it, was removed or replaced.
        """
        if self.handle is not None and not _stands(self.path, self.handle):
            raise StoreError(
                f"{self.path} was removed or replaced while this run was written to it. "
                "Nothing more is written. Run it again, to a separate folder."
            )

    def release(self) -> None:
        """Let another process write. A forked copy of the locking process releases nothing."""
        if self.handle is None or self.process != os.getpid():
            return
        if _stands(self.path, self.handle):
            with suppress(OSError):
                (self.path / LOCK).unlink()
        os.close(self.handle)
        if self.place is not None:
            os.close(self.place)
        self.handle = self.place = None


def hold(path: Path) -> Lock:
    """Lock a folder for one writer.

    Raises
    ------
    StoreError : another process writes it, named with its machine and since when; or the folder cannot be written.
    """
    for _ in range(TRIES):
        try:
            handle = os.open(path / LOCK, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except OSError as error:
            raise cannot_write(path, error) from error
        if not _taken(path, handle):
            os.close(handle)
            time.sleep(PAUSE)
        elif not _stands(path, handle):  # the holder removed the file in between: the locked file no longer has a name
            os.close(handle)
        else:
            _sign(path, handle)
            return Lock(path, handle, os.getpid(), _place(path, handle))
    raise StoreError(_refusal(path))


@contextmanager
def holding(path: Path) -> Iterator[Lock]:
    """Lock a folder for one writer, and make it if there is none; a new folder is removed again if nothing is written to it.

    Raises
    ------
    StoreError : another process writes it; or the folder cannot be made or written.
    """
    made = [folder for folder in (path, *path.parents) if not folder.exists()]
    held = None
    try:
        held = _hold_made(path)
        yield held
    finally:
        if held is not None:
            held.release()
        with suppress(OSError):  # the folder is not empty
            for folder in made:
                folder.rmdir()


def _hold_made(path: Path, tries: int = TRIES) -> Lock:
    """Make the folder and lock it; repeat if another writer that ends removes the empty folder in between."""
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise cannot_write(path, error) from error
    try:
        return hold(path)
    except StoreError as error:
        if tries > 1 and isinstance(error.__cause__, FileNotFoundError):
            return _hold_made(path, tries - 1)
        raise


def is_locked(path: Path) -> bool:
    """True while a process writes the run. Needs no write permission."""
    try:
        handle = os.open(path / LOCK, os.O_RDONLY)
    except OSError:
        return False
    try:
        return not _taken(path, handle, shared=True)
    finally:
        os.close(handle)


def check_unlocked(path: Path) -> None:
    """Raise an error if another process is writing the folder.

    Raises
    ------
    StoreError : names the process and the time since when.
    """
    if is_locked(path):
        raise StoreError(_refusal(path))


def _taken(path: Path, handle: int, *, shared: bool = False) -> bool:
    """Try to lock an open file."""
    try:
        import fcntl
    except ImportError:  # Windows: the user must take care of one writer at a time
        return True
    try:
        fcntl.flock(handle, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # this file system has no locks
        return not _noted(path)
    return True


def _noted(path: Path) -> bool:
    """True if the note names a writer that may be alive."""
    note = _note(path)
    if not note:
        return False
    if note.get("machine") != socket.gethostname():
        return True
    try:
        os.kill(int(note["process"]), 0)
    except (ProcessLookupError, ValueError):
        return False
    except OSError:
        return True  # alive, and owned by another user
    return True


def _stands(path: Path, handle: int) -> bool:
    """True if an open lock is still the file in the folder."""
    try:
        return os.path.samestat(os.fstat(handle), (path / LOCK).stat())
    except OSError:
        return False


def _place(path: Path, handle: int) -> int | None:
    """An open handle of the locked folder; None where the system has no path by a handle."""
    if not _HANDLES.is_dir():
        return None
    try:
        place = os.open(path, os.O_RDONLY | os.O_DIRECTORY)
    except OSError:
        return None
    if _stands(_HANDLES / str(place), handle):
        return place
    os.close(place)  # the folder was replaced since it was locked, which `Lock.check` will tell
    return None


def _sign(path: Path, handle: int) -> None:
    since = datetime.now().astimezone().isoformat(" ", "seconds")
    note = {"process": os.getpid(), "machine": socket.gethostname(), "since": since}
    try:
        os.ftruncate(handle, 0)
        os.pwrite(handle, json.dumps(note).encode(), 0)
    except OSError as error:
        os.close(handle)
        raise cannot_write(path, error) from error


def _note(path: Path) -> dict[str, Any]:
    try:
        found = json.loads((path / LOCK).read_text("utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) and {"process", "machine", "since"} <= found.keys() else {}


def _refusal(path: Path) -> str:
    for _ in range(TRIES):
        if note := _note(path):
            break
        time.sleep(PAUSE)  # the lock exists a moment before the note is written
    who = f": process {note['process']} on {note['machine']}, since {note['since']}" if note else ""
    whose = "this process" if note.get("process") == os.getpid() else "another process"
    return f"{path} is being written by {whose}{who}. Nothing in it was changed. Wait for it, end it, or name another folder."
