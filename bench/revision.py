"""Files of another revision of the project, from its history."""

from __future__ import annotations

import subprocess
from pathlib import Path

__all__ = ["NoHistoryError", "checkout", "hash_of"]

HERE = Path(__file__).resolve().parents[1]


class NoHistoryError(Exception):
    """The history at hand lacks a revision: none at all, or cut short."""


def hash_of(revision: str) -> str:
    """The whole hash of a revision."""
    return _git("rev-parse", "--verify", "--quiet", f"{revision}^{{commit}}", of=revision).decode().strip()


def checkout(revision: str, folder: Path, *paths: str) -> None:
    """Write the files of a revision, or those under some paths, into a folder."""
    archive = _git("archive", revision, *paths, of=revision)
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["tar", "-x", "-C", folder], input=archive, check=True)


def _git(*words: str, of: str) -> bytes:
    try:
        return subprocess.run(["git", *words], cwd=HERE, check=True, capture_output=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        said = getattr(error, "stderr", b"").decode().strip() or str(error)
        raise NoHistoryError(f"The history in {HERE} lacks revision {of} ({said}). Fetch it: git fetch --unshallow.") from None
