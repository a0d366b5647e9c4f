"""Reads the arrays of a run folder by zarr, but a missing or damaged chunk is an error instead of zeros."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from numcodecs.zstd import Zstd
from zarr.storage import LocalStore

from kinetruss.errors import StoreError
from kinetruss.results.folder import MODEL, stamp_of

CHUNK = re.compile(r"(?:.*/)?(\d+)(?:\.\d+)*")


class RunArrays(LocalStore):
    """Reads the arrays of one run; it is an error if another run replaces it in the folder.

    The model file identifies a run: it is written once, as the last step of the start, and removed first when the run is
    replaced. blocks : number of chunks along the first axis; a running analysis may have more.
    """

    def __init__(self, root: Path | str, *, blocks: int = 0, read_only: bool = True) -> None:
        super().__init__(root, read_only=read_only)
        self._blocks = blocks
        self._model = Path(root).parent / MODEL
        self._stamp = stamp_of(self._model)

    def with_read_only(self, read_only: bool = False) -> RunArrays:
        """Returns the store itself: it is always read-only."""
        return RunArrays(self.root, blocks=self._blocks, read_only=read_only)

    async def get(self, key: str, *given: Any, **more: Any) -> Any:
        """Read one file. Raises StoreError if a chunk is missing, or another run has replaced this one."""
        return self._checked(key, await super().get(key, *given, **more))

    def get_sync(self, key: str, **more: Any) -> Any:
        """The same without asyncio."""
        return self._checked(key, super().get_sync(key, **more))

    def _checked(self, key: str, found: Any) -> Any:
        if stamp_of(self._model) != self._stamp:
            raise StoreError(f"{self.root.parent} was replaced by another run while it was read. Read it again.")
        if (chunk := CHUNK.fullmatch(key)) and int(chunk[1]) < self._blocks and (what := _wrong(found)):
            raise StoreError(f"{self.root.parent} is damaged: {key} {what}. Run it again with --overwrite.")
        return found


def _wrong(chunk: Any) -> str:
    """The fault of a chunk as text: it is missing, or its checksum is wrong."""
    if chunk is None:
        return "is missing"
    try:
        Zstd().decode(chunk.to_bytes())
    except RuntimeError:
        return "is not what was written"
    return ""
