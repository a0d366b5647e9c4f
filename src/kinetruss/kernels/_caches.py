"""Compiled kernels kept on disk belong to one state of all kernel files.

Numba asks only whether the file of a kernel has changed, not those of the kernels compiled into it; after a change to one of
these it would run the old one, or crash. So what was kept is dropped whenever any kernel file differs.
"""

from __future__ import annotations

import hashlib
from contextlib import suppress
from pathlib import Path

__all__ = ["drop_stale"]

STAMP = "kernels.stamp"


def drop_stale(folder: Path) -> bool:
    """Remove the compiled kernels beside the files of `folder` if they belong to another state of them; True if so."""
    files = sorted(folder.glob("*.py"))
    state = "\n".join(f"{file.name} {found.st_size} {found.st_mtime_ns}" for file in files if (found := file.stat()))
    stamp = hashlib.sha256(state.encode()).hexdigest()
    kept = folder / "__pycache__"
    mark = kept / STAMP
    if mark.is_file() and mark.read_text("ascii") == stamp:
        return False
    with suppress(OSError):  # a folder that cannot be written has no kernels of ours either
        for file in [*kept.glob("*.nbi"), *kept.glob("*.nbc")]:
            file.unlink(missing_ok=True)
        kept.mkdir(exist_ok=True)
        mark.write_text(stamp, "ascii")
    return True
