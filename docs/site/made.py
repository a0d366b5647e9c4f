"""Sphinx extension: writes the pages under docs/made before the site is read, again if what they are made from has changed."""

import hashlib
import multiprocessing
from concurrent.futures import ProcessPoolExecutor
from itertools import chain
from pathlib import Path

import api
import gallery
import manual
import parts
import tables

ROOT = Path(__file__).parents[2]
MADE = ROOT / "docs" / "made"
KEY = MADE / "key"
"""The key of what the files there were made from; written last."""
(MADE / "static").mkdir(parents=True, exist_ok=True)  # before Sphinx looks for it


def key(root: Path = ROOT) -> str:
    """A hash of all that pages, films and tutorials are computed from: the package, the site's scripts, the packages used."""
    found = hashlib.sha256()
    files = [path for folder in ("src", "docs/site") for path in (root / folder).rglob("*.*") if path.is_file()]
    for path in sorted([*(path for path in files if "__pycache__" not in path.parts), root / "requirements.lock"]):
        found.update(f"{path.relative_to(root)} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    return found.hexdigest()


def write(_app: object = None) -> None:
    """Write all generated pages; a page that has not changed keeps its time, so that Sphinx does not read it again."""
    log = (ROOT / "CHANGELOG.md").read_text("utf-8").replace("](docs/", "](../")
    found = [[("changelog.md", log)], api.pages(MADE), tables.pages(MADE)]
    now = key()
    if not KEY.is_file() or KEY.read_text("utf-8") != now:
        KEY.unlink(missing_ok=True)
        found += computed()
        KEY.write_text(now, "utf-8")
    parts.write(MADE / "parts", now)
    for name, text in chain(*found):
        path = MADE / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")


def computed() -> list[list[tuple[str, str]]]:
    """Pages that take long: the manual, and the gallery with its pictures and films, in two processes."""
    with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
        verified = pool.submit(manual.pages)
        drawn = {name: pool.submit(gallery.drawn, name, MADE) for name in gallery.names()}
        return [verified.result(), gallery.pages({name: one.result() for name, one in drawn.items()})]


def setup(app: object) -> dict[str, bool]:
    """Register with Sphinx. Tutorials run again when the key changes."""
    app.add_config_value("made_key", key(), "env")
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


if __name__ == "__main__":
    write()
