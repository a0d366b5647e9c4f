"""Run folders as a kill leaves them, and files in their archives."""

import json
from pathlib import Path

from kinetruss.results.archive import Member, content_of, walked
from kinetruss.results.folder import ARCHIVE


def members(folder: Path) -> dict[str, Member]:
    """Members of the archive of a run by name, in the order in which they were written."""
    with (folder / ARCHIVE).open("rb") as file:
        found = walked(file, json.loads((folder / "kinetruss.json").read_text())["length"])
    return dict(sorted(found.items(), key=lambda one: one[1].at))


def archived(folder: Path) -> dict[str, bytes]:
    """Their contents."""
    with (folder / ARCHIVE).open("rb") as file:
        return {name: content_of(file, name, one) for name, one in members(folder).items()}


def stopped(folder: Path, committed: int, status: str = "") -> Path:
    """A whole run in blocks as a kill (or with a status an interrupt) leaves it behind so many samples.

    What was written after them stays in the archive, and is not counted.
    """
    record = json.loads((folder / "kinetruss.json").read_text())
    block = f"/{committed // record['block']}"
    if committed < record["samples"]:
        later = [one.at for name, one in members(folder).items() if name.startswith("motion/") and block in name]
    else:
        later = [one.at for name, one in members(folder).items() if name.startswith("verdict/")]
    record |= {"state": "writing", "committed": committed, "status": status, "length": min(later)}
    (folder / "kinetruss.json").write_text(json.dumps(record))
    return folder
