"""Errors of a disk that refuses to write, and their fixes."""

from __future__ import annotations

import errno
from pathlib import Path

from kinetruss.errors import StoreError

__all__ = ["FULL", "cannot_write", "cause_and_mend"]

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
