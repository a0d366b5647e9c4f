"""What outlives a page and a studio: the autosaved drawing, versions to go back to, and the address of the studio."""

from __future__ import annotations

import http.client
import json
import re
import time
from contextlib import suppress
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any
from urllib.parse import quote

from kinetruss.errors import InputError, StoreError
from kinetruss.results.folder import whole_file

FOLDER = ".kinetruss"
MOST = 50
"""Largest number of versions; the oldest are removed."""

PAGES = 16
"""Largest number of slider pages that a later studio can go on with; the oldest are removed."""

KEY = re.compile("[0-9a-f]{16}")
"""Keys of slider pages; a browser sends them, and they become parts of file names."""


@dataclass(frozen=True)
class Keep:
    """Side files of one drawing in the folder ``.kinetruss`` beside it. name : of its file, or ``untitled``."""

    folder: Path
    name: str

    @classmethod
    def unused(cls, folder: Path, name: str, token: str | None = None) -> Keep:
        """The side files of a name, or of name-2, name-3, ..., that no other running studio has. token : of this studio."""
        keep = cls(folder, name)
        for number in count(2):
            if not keep.in_use(token):
                break
            keep = cls(folder, f"{name}-{number}")
        return keep

    def in_use(self, token: str | None) -> bool:
        """True if another studio of this drawing answers at its address."""
        found = self.address()
        if found is None or found[0] == token:
            return False
        line = http.client.HTTPConnection("127.0.0.1", found[1], timeout=2.0)
        try:
            line.request("GET", f"/{quote(found[0])}/draw/")
            return line.getresponse().status == 200
        except (OSError, http.client.HTTPException):
            return False
        finally:
            line.close()

    def path(self, what: str) -> Path:
        """The side file for a purpose."""
        return self.folder / FOLDER / f"{self.name}.{what}"

    def autosave(self, text: str) -> None:
        """Keep a text until it is saved or removed.

        Raises
        ------
        StoreError : it cannot be written.
        """
        self._write("autosave.yaml", text)

    def found(self) -> tuple[str, float] | None:
        """An autosaved text and its time, s since 1970."""
        path = self.path("autosave.yaml")
        try:
            return path.read_text(encoding="utf-8"), path.stat().st_mtime
        except (OSError, UnicodeDecodeError):
            return None

    def remove(self) -> None:
        """Remove the autosaved text."""
        with suppress(OSError):
            self.path("autosave.yaml").unlink(missing_ok=True)

    def versions(self) -> list[dict[str, Any]]:
        """Saved states, oldest first: number, when (s since 1970), words, text."""
        try:
            found = json.loads(self.path("versions.json").read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return []
        fit = isinstance(found, list) and all(isinstance(one, dict) and {"number", "text", "when"} <= set(one) for one in found)
        return found if fit else []

    def add(self, text: str, words: str) -> None:
        """One more version; not if it is the same as the last."""
        rows = self.versions()
        if rows and rows[-1]["text"] == text:
            return
        number = rows[-1]["number"] + 1 if rows else 1
        rows.append({"number": number, "when": time.time(), "words": words, "text": text})
        self._write("versions.json", json.dumps(rows[-MOST:], ensure_ascii=False))

    def version(self, number: int) -> str:
        """The text of a version.

        Raises
        ------
        InputError : there is none with this number.
        """
        for row in self.versions():
            if row["number"] == number:
                return str(row["text"])
        raise InputError(f"There is no version {number}.")

    def keep_picture(self, place: dict[str, Any] | None, source: str | None) -> None:
        """Keep the picture to trace and its place; no place removes it, no source leaves the one that is kept."""
        if place is None:
            for what in ("picture.json", "picture.txt"):
                with suppress(OSError):
                    self.path(what).unlink(missing_ok=True)
            return
        if source is not None:
            self._write("picture.txt", source)
        self._write("picture.json", json.dumps(place))

    def picture(self) -> dict[str, Any] | None:
        """The picture that was kept: place and source."""
        try:
            place = json.loads(self.path("picture.json").read_text(encoding="utf-8"))
            source = self.path("picture.txt").read_text(encoding="utf-8")
        except (OSError, ValueError):
            return None
        return {"place": place, "source": source} if isinstance(place, dict) and source.startswith("data:image/") else None

    def pages(self) -> list[tuple[str, float]]:
        """Slider pages that are kept, newest first: key and time, s since 1970. Those beyond the largest number are removed."""
        start, end = f"{self.name}.page-", ".json"
        found = []
        with suppress(OSError):
            for path in (self.folder / FOLDER).iterdir():
                key = path.name.removeprefix(start).removesuffix(end)
                if path.name == start + key + end and KEY.fullmatch(key):
                    found.append((key, path.stat().st_mtime))
        found.sort(key=lambda one: -one[1])
        for key, _ in found[PAGES:]:
            self.keep_page(key, None)
        return found[:PAGES]

    def keep_page(self, key: str, record: dict[str, Any] | None) -> None:
        """Keep the changes of a slider page; None removes them.

        Raises
        ------
        StoreError : they cannot be written.
        """
        if record is not None:
            self._write(f"page-{key}.json", json.dumps(record, ensure_ascii=False))
            return
        with suppress(OSError):
            self.path(f"page-{key}.json").unlink(missing_ok=True)

    def page(self, key: str) -> dict[str, Any] | None:
        """The changes of a slider page."""
        if not KEY.fullmatch(key):
            return None
        try:
            found = json.loads(self.path(f"page-{key}.json").read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None
        return found if isinstance(found, dict) else None

    def address(self) -> tuple[str, int] | None:
        """Token and port of the last studio of this drawing."""
        try:
            found = json.loads(self.path("address.json").read_text(encoding="utf-8"))
            return str(found["token"]), int(found["port"])
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def keep_address(self, token: str, port: int) -> None:
        """Let the next studio of this drawing have the same address; only the user can read it."""
        with suppress(StoreError):
            self._write("address.json", json.dumps({"token": token, "port": port}))

    def _write(self, what: str, text: str) -> None:
        path = self.path(what)
        with whole_file(path) as draft:
            draft.touch(mode=0o600)
            draft.write_text(text, encoding="utf-8", newline="\n")
