"""Sphinx extension: writes the pages under docs/made before the site is read."""

from itertools import chain
from pathlib import Path

import api
import gallery
import manual
import tables

MADE = Path(__file__).parents[1] / "made"
(MADE / "static").mkdir(parents=True, exist_ok=True)  # before Sphinx looks for it


def write(_app: object = None) -> None:
    """Write all generated pages; a page that has not changed keeps its time, so that Sphinx does not read it again."""
    log = (MADE.parents[1] / "CHANGELOG.md").read_text("utf-8").replace("](docs/", "](../")
    for name, text in chain([("changelog.md", log)], *(part.pages(MADE) for part in (api, tables, manual, gallery))):
        path = MADE / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")


def setup(app: object) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


if __name__ == "__main__":
    write()
