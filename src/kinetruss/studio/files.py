"""What a studio writes: the model file, and in the folder ``.kinetruss`` beside it drafts, versions and its own address."""

from __future__ import annotations

import http.client
import json
import re
import threading
import time
from contextlib import suppress
from itertools import count
from pathlib import Path
from typing import Any
from urllib.parse import quote

from kinetruss.errors import InputError, StoreError
from kinetruss.io import write
from kinetruss.model import Model
from kinetruss.results.folder import whole_file
from kinetruss.studio.dimensions import Dimensions, read

PLAIN = re.compile(r"[^\W.][\w .+-]{0,120}\.(yaml|yml|json)", re.IGNORECASE)
DEVICE = re.compile(r"(con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9\u00b9\u00b2\u00b3])[ .].*", re.IGNORECASE)
"""Names of devices: on Windows a file with such a name cannot be opened, moved or deleted as usual."""

Seen = dict[Path, tuple[int, int]]
"""Size and modification time (ns) of files that a page has opened or written."""


class FileThereError(InputError):
    """Raised if a file with that name exists and would be lost."""


def seen_now(*paths: Path | None) -> Seen:
    """The present stamps of files; files that do not exist are omitted."""
    return {path.resolve(): _stamp(path) for path in paths if path is not None and path.is_file()}


def save(model: Model, folder: Path | None, name: str, seen: Seen, *, replace: bool = False, text: str | None = None) -> Path:
    """Write a model to a file in a folder, completely or not at all, and store its stamp in `seen`.

    replace : also replace a file that is not in `seen` or was changed since. text : the model as YAML, written as it is.

    Raises
    ------
    InputError : no folder was chosen, or the name is not a plain .yaml, .yml or .json file name.
    FileThereError : it would replace another file.
    StoreError : the file cannot be written.
    """
    if folder is None:
        raise InputError("No folder was chosen to write to.")
    if not PLAIN.fullmatch(name):
        raise InputError(
            f"{name!r} is not a plain file name. Write for example bay.yaml; it goes into {folder.name or folder}."
        )
    if DEVICE.fullmatch(name):
        raise InputError(f"{name!r} is the name of a device on Windows. Choose another name, for example my_{name}.")
    path = folder.resolve() / name
    if path.is_symlink() or (path.exists() and not path.is_file()):
        raise InputError(f"{name} is a link or a folder. Choose another name.")
    if path.exists() and not replace:
        _refuse_to_lose(path, seen)
    if text is None or path.suffix.lower() == ".json":
        write(model, path)
    else:
        with whole_file(path) as draft:
            draft.write_text(text, encoding="utf-8", newline="\n")
    seen[path] = _stamp(path)
    return path


def _refuse_to_lose(path: Path, seen: Seen) -> None:
    """Raise an error if the file was not opened or written by this page, or was changed since."""
    if path not in seen:
        raise FileThereError(
            f"{path.name} exists already, and is not the file that was opened. Overwrite it, or choose another name."
        )
    if seen[path] != _stamp(path):
        raise FileThereError(
            f"{path.name} was changed by another program since it was opened or saved here. "
            "Overwrite it, or choose another name."
        )


def _stamp(path: Path) -> tuple[int, int]:
    found = path.stat()
    return found.st_size, found.st_mtime_ns


# Drafts: what is kept until it is saved, and versions to go back to.

FOLDER = ".kinetruss"
MOST = 50
"""Largest number of versions; the oldest are removed."""

PAGES = 16
"""Largest number of pages with sliders that a later studio can go on with; the oldest are removed."""

KEY = re.compile("[0-9a-f]{16}")
"""Keys of pages; a browser sends them, and they become parts of file names."""


class Drafts:
    """Side files of one model in the folder ``.kinetruss`` beside it, which all pages of a studio share.

    name : of its file, or ``untitled``; -2, -3, ... is added while another running studio has these side files.
    address : token and port of this studio; the next one of this model gets the same.
    left : keys and times (s since 1970) of pages of an earlier studio that nobody has taken up, newest first.
    """

    def __init__(self, folder: Path, name: str) -> None:
        self.folder, self.name = folder, name
        self.address: tuple[str, int] | None = None
        self.lock = threading.RLock()
        self.settled = False
        self._find_unused()
        self.left = self._pages()

    def _find_unused(self) -> None:
        first = self.name
        for number in count(2):
            if not self._in_use():
                break
            self.name = f"{first}-{number}"

    def _in_use(self) -> bool:
        """True if another studio of this model answers at its address."""
        found = self.last_address()
        if found is None or (self.address is not None and found[0] == self.address[0]):
            return False
        line = http.client.HTTPConnection("127.0.0.1", found[1], timeout=2.0)
        try:
            line.request("GET", f"/{quote(found[0])}/draw/")
            return line.getresponse().status == 200
        except (OSError, http.client.HTTPException):
            return False
        finally:
            line.close()

    def path(self, what: str, name: str = "") -> Path:
        """The side file for a purpose; name : of another model."""
        return self.folder / FOLDER / f"{name or self.name}.{what}"

    def last_address(self) -> tuple[str, int] | None:
        """Token and port of the last studio of this model."""
        found = _read(self.path("address.json"))
        with suppress(KeyError, TypeError, ValueError):
            return str(found["token"]), int(found["port"])
        return None

    # -- drafts ----------------------------------------------------------------------------------------------------

    def keep_drawing(self, text: str | None) -> None:
        """Keep the text of the drawing until it is saved; None removes it.

        Raises
        ------
        StoreError : it cannot be written.
        """
        self._keep("autosave.yaml", text)

    def drawing(self) -> tuple[str, float] | None:
        """The text of a drawing that was kept and its time, s since 1970."""
        path = self.path("autosave.yaml")
        try:
            return path.read_text(encoding="utf-8"), path.stat().st_mtime
        except (OSError, UnicodeDecodeError):
            return None

    def keep_page(self, key: str, record: dict[str, Any] | None) -> None:
        """Keep the changes of a page with sliders; None removes them.

        Raises
        ------
        StoreError : they cannot be written.
        """
        with self.lock:
            self.left = [one for one in self.left if one[0] != key]
            self._keep(f"page-{key}.json", None if record is None else json.dumps(record, ensure_ascii=False))

    def take_page(self, key: str) -> dict[str, Any] | None:
        """The changes of a page with sliders; they are offered to no other page any more."""
        if not KEY.fullmatch(key):
            return None
        with self.lock:
            self.left = [one for one in self.left if one[0] != key]
        found = _read(self.path(f"page-{key}.json"))
        return found if isinstance(found, dict) else None

    def _pages(self) -> list[tuple[str, float]]:
        """Pages that are kept, newest first; those beyond the largest number are removed."""
        start, end = f"{self.name}.page-", ".json"
        found = []
        with suppress(OSError):
            for path in (self.folder / FOLDER).iterdir():
                key = path.name.removeprefix(start).removesuffix(end)
                if path.name == start + key + end and KEY.fullmatch(key):
                    found.append((key, path.stat().st_mtime))
        found.sort(key=lambda one: -one[1])
        for key, _ in found[PAGES:]:
            _remove(self.path(f"page-{key}.json"))
        return found[:PAGES]

    # -- versions, the picture to trace, dimensions -------------------------------------------------------------------------

    def versions(self) -> list[dict[str, Any]]:
        """Saved states, oldest first: number, when (s since 1970), words, text."""
        found = _read(self.path("versions.json"))
        fit = isinstance(found, list) and all(isinstance(one, dict) and {"number", "text", "when"} <= set(one) for one in found)
        return found if fit else []

    def add(self, text: str, words: str) -> None:
        """One more version; not if it is the same as the last."""
        with self.lock:
            self._settle()
            rows = self.versions()
            if rows and rows[-1]["text"] == text:
                return
            number = rows[-1]["number"] + 1 if rows else 1
            rows.append({"number": number, "when": time.time(), "words": words, "text": text})
            _write(self.path("versions.json"), json.dumps(rows[-MOST:], ensure_ascii=False))

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

    def keep_picture(self, place: dict[str, Any] | None, source: str | None, file: Path | None) -> None:
        """Keep the picture to trace and its place, also beside a saved file.

        No place removes it, no source leaves the one that is kept.
        """
        with self.lock:
            self._settle()
            self._put_picture(self.name, place, source)
        if file is not None:
            self.copy_picture(file)

    def copy_picture(self, file: Path) -> None:
        """The picture beside a saved file too: its next studio looks for it there."""
        if file.stem != self.name:
            found = self.picture() or {"place": None, "source": None}
            self._put_picture(file.stem, found["place"], found["source"])

    def _put_picture(self, name: str, place: dict[str, Any] | None, source: str | None) -> None:
        where, what = self.path("picture.json", name), self.path("picture.txt", name)
        if place is None:
            _remove(where)
            _remove(what)
            return
        if source is not None:
            _write(what, source)
        _write(where, json.dumps(place))

    def picture(self) -> dict[str, Any] | None:
        """The picture that was kept: place and source."""
        place = _read(self.path("picture.json"))
        try:
            source = self.path("picture.txt").read_text(encoding="utf-8")
        except (OSError, ValueError):
            return None
        return {"place": place, "source": source} if isinstance(place, dict) and source.startswith("data:image/") else None

    def keep_dimensions(self, found: Dimensions, file: Path | None) -> None:
        """Keep the dimensions of the drawing, also beside a saved file: its next studio looks for them there."""
        with self.lock:
            self._settle()
            for name in {self.name} if file is None else {self.name, file.stem}:
                if found:
                    _write(self.path("dimensions.json", name), json.dumps(found, ensure_ascii=False))
                else:
                    _remove(self.path("dimensions.json", name))

    def dimensions(self) -> Dimensions:
        """Those that were kept."""
        return read(_read(self.path("dimensions.json")))

    # -- files -----------------------------------------------------------------------------------------------------

    def _settle(self) -> None:
        """From now on the side files of this name are those of this studio."""
        if not self.settled:
            self._find_unused()
            self.settled = True

    def _keep(self, what: str, text: str | None) -> None:
        """Keep a draft, and let the next studio of this model have the same address; only the user can read it."""
        with self.lock:
            self._settle()
            if text is None:
                _remove(self.path(what))
                return
            _write(self.path(what), text)
            if self.address is not None:
                with suppress(StoreError):
                    token, port = self.address
                    _write(self.path("address.json"), json.dumps({"token": token, "port": port}))


def _read(path: Path) -> Any:
    """The record in a file; None if there is none."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


def _write(path: Path, text: str) -> None:
    with whole_file(path) as draft:
        draft.touch(mode=0o600)
        draft.write_text(text, encoding="utf-8", newline="\n")


def _remove(path: Path) -> None:
    with suppress(OSError):
        path.unlink(missing_ok=True)
