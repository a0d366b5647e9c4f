"""Run folders as a kill leaves them, and files in their archives."""

import json
import zipfile
from pathlib import Path

from numcodecs.zstd import Zstd

from kinetruss.results.archive import Member, content_of, listed, walked
from kinetruss.results.folder import ARCHIVE, ARRAYS
from kinetruss.results.store import End, Writer


def ended(writer: Writer, status: str, message: str = "") -> None:
    """The run of a writer marked as ended, and its folder let go."""
    try:
        writer.append({}, end=End(status, message))
    finally:
        writer.release()


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


def as_format_1(folder: Path, *, archive: bool = False) -> Path:
    """The folder of a run as versions before format 2 wrote it: a file for every member, or, of a short variant, an archive
    by the zipfile module. What was written after a kill stays among the files.
    """
    record = json.loads((folder / "kinetruss.json").read_text())
    with (folder / ARCHIVE).open("rb") as file:
        names = listed(file)
        contents = {name: _before(name, content_of(file, name, one)) for name, one in names.items()}
    (folder / ARCHIVE).unlink()
    if archive:
        with zipfile.ZipFile(folder / ARCHIVE, "w") as target:
            for name, content in contents.items():
                target.writestr(zipfile.ZipInfo(name), content)
    else:
        for name, content in contents.items():
            place = folder / ARRAYS / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(content)
    del record["length"]
    (folder / "kinetruss.json").write_text(json.dumps(record | {"kinetruss_run": 1}))
    return folder


def _before(name: str, content: bytes) -> bytes:
    """A member with the level of compression that it had."""
    if not name.endswith("zarr.json"):
        return Zstd(level=0, checksum=True).encode(Zstd().decode(content))
    record = json.loads(content)
    for codec in record.get("codecs", []):
        codec.get("configuration", {}).update({"level": 0} if codec["name"] == "zstd" else {})
    return json.dumps(record).encode()
