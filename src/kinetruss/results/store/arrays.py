"""The arrays of a run folder as zarr reads them, with one difference: what is missing or damaged is an error, not NaN or 0."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from numcodecs.zstd import Zstd
from zarr.storage import LocalStore

from kinetruss.errors import StoreError
from kinetruss.results.store.folder import MODEL
from kinetruss.results.store.stamp import stamp_of

__all__ = ["RunArrays"]

CHUNK = re.compile(r"(?:.*/)?(\d+)(?:\.\d+)*")


class RunArrays(LocalStore):
    """Reads the arrays of one run, and of no other that takes its place in the folder on the way.

    A run is told by its model, which is written once, last of all when a run begins, and removed first when it is replaced.
    blocks : so many chunks along the first axis are there; of a run on its way, others may be.
    """

    def __init__(self, root: Path | str, *, blocks: int = 0, read_only: bool = True) -> None:
        super().__init__(root, read_only=read_only)
        self._blocks = blocks
        self._model = Path(root).parent / MODEL
        self._stamp = stamp_of(self._model)

    def with_read_only(self, read_only: bool = False) -> RunArrays:
        """The same arrays."""
        return RunArrays(self.root, blocks=self._blocks, read_only=read_only)

    async def get(self, key: str, *given: Any, **more: Any) -> Any:
        """One file. Raises StoreError where a chunk is missing, or the run is another one by now."""
        return self._checked(key, await super().get(key, *given, **more))

    def get_sync(self, key: str, **more: Any) -> Any:
        """The same at once."""
        return self._checked(key, super().get_sync(key, **more))

    def _checked(self, key: str, found: Any) -> Any:
        if stamp_of(self._model) != self._stamp:
            raise StoreError(f"{self.root.parent} was replaced by another run while it was read. Read it again.")
        if (chunk := CHUNK.fullmatch(key)) and int(chunk[1]) < self._blocks and (what := _wrong(found)):
            raise StoreError(f"{self.root.parent} is damaged: {key} {what}. Run it again with --overwrite.")
        return found


def _wrong(chunk: Any) -> str:
    """What is wrong with a chunk: it is not there, or not as it was written (its checksum says so)."""
    if chunk is None:
        return "is missing"
    try:
        Zstd().decode(chunk.to_bytes())
    except RuntimeError:
        return "is not what was written"
    return ""
