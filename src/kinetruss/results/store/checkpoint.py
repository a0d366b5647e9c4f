"""The state of an integration after each committed block: plain arrays in OUT/state/COUNT.npz.

COUNT is the number of samples before the state. The file is written before the ledger counts the block, and the previous
one is removed afterwards. So after a kill at any instant there is a state for the count in the ledger.
"""

from __future__ import annotations

import io
import os
import zipfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import StoreError
from kinetruss.results.store.folder import STATE

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["drop_states", "read_state", "write_state"]


def write_state(path: Path, count: int, arrays: Mapping[str, NDArray[Any]]) -> None:
    """Write the state after `count` samples, in one step."""
    target = _file(path, count)
    target.parent.mkdir(exist_ok=True)
    packed = io.BytesIO()
    np.savez(packed, allow_pickle=False, **dict(arrays))
    draft = target.with_suffix(".part")
    with draft.open("wb") as file:
        file.write(packed.getvalue())
        file.flush()
        os.fsync(file.fileno())
    draft.replace(target)


def read_state(path: Path, count: int) -> dict[str, NDArray[Any]] | None:
    """The state after `count` samples, or None if there is none.

    Raises
    ------
    StoreError : the file is damaged.
    """
    file = _file(path, count)
    try:
        with file.open("rb") as handle, np.load(handle, allow_pickle=False) as found:
            return {name: found[name] for name in found.files}
    except FileNotFoundError:
        return None
    except (OSError, ValueError, EOFError, KeyError, zipfile.BadZipFile) as error:
        raise StoreError(f"{file} is damaged: {error}. Run it again with --overwrite.") from error


def drop_states(path: Path, keep: int | None = None) -> None:
    """Remove all states except that after `keep` samples."""
    folder = path / STATE
    kept = None if keep is None else _file(path, keep)
    for file in folder.glob("*.*"):
        if file != kept:
            file.unlink(missing_ok=True)
    if keep is None:
        with suppress(OSError):
            folder.rmdir()


def _file(path: Path, count: int) -> Path:
    return path / STATE / f"{count}.npz"
