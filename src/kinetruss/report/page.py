"""A page: one output in several formats. What it says is a list of entries, written once for all of them."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError
from kinetruss.report.entries import Entry, as_text
from kinetruss.report.typesetting import bare_page
from kinetruss.results.folder import whole_file


@dataclass(frozen=True, slots=True, kw_only=True)
class Page:
    """The output of a function of this package. Each format is made when it is requested, and is empty if there is none."""

    found: Any
    as_record: Callable[[Any], Any]
    as_entries: Callable[[Any], Iterable[Entry]] | None = None
    as_rows: Callable[[Any], Iterable[Sequence[Any]]] | None = None
    as_html: Callable[[Any], str] | None = None

    @property
    def record(self) -> Any:
        """Plain data for JSON; SI units, all digits."""
        return self.as_record(self.found)

    @property
    def text(self) -> str:
        """The page as text."""
        return as_text(self.as_entries(self.found)) if self.as_entries else ""

    @property
    def rows(self) -> list[Sequence[Any]]:
        """A table with a head; SI units, all digits."""
        return list(self.as_rows(self.found)) if self.as_rows else []

    @property
    def html(self) -> str:
        """A self-contained HTML page."""
        if self.as_html is not None:
            return self.as_html(self.found)
        if self.as_entries is None:
            return ""
        return bare_page(list(self.as_entries(self.found)))

    def write(self, file: str | Path) -> Path:
        """Write the rows as CSV.

        Raises
        ------
        InputError : a wrong suffix, or a page without rows. StoreError : the file cannot be written.
        """
        path = Path(file)
        if path.suffix != ".csv":
            raise InputError(f"{path}: the table is written as .csv.")
        if self.as_rows is None:
            raise InputError(f"{path}: this page has no rows. Take its text or its record.")
        with whole_file(path) as draft, draft.open("w", newline="", encoding="utf-8") as target:
            csv.writer(target, lineterminator="\n").writerows(self.rows)
        return path
