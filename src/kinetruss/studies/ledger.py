"""The folder of a study: one ledger of all its rows, with what became of each; one process writes it.

    OUT/study.sqlite       the study, its model, the values of every row, and the outcome of those that are done
    OUT/results.parquet    all rows with their values and results, for other programs; written at the end and after Ctrl-C
    OUT/pictures           the pictures, if asked for

A row is done when its transaction is: a process that is killed leaves all rows that were done before. The file appears whole.
"""

from __future__ import annotations

import hashlib
import json
import math
import sqlite3
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kinetruss.errors import InputError, StoreError
from kinetruss.results.folder import PART, PICTURES, remove, whole_file
from kinetruss.results.lock import LOCK, cannot_write, check_unlocked, holding
from kinetruss.studies.evaluating import Outcome
from kinetruss.studies.sampling import Points

FILE, RESULTS = "study.sqlite", "results.parquet"
JOURNAL = f"{FILE}-journal"
OWN = (RESULTS, PICTURES, JOURNAL, FILE)
"""Files of a study, the ledger last: so the folder is recognised until it is gone."""
FORMAT = 1
PAUSE = 1.0
"""Seconds between two commits: what a kill costs at most, besides what is being computed."""
TABLES = """
create table about (name text primary key, value text not null);
create table variables (name text primary key, unit text);
create table results (name text primary key, text text not null, unit text not null);
create table rows (
    row integer primary key, given text not null, status text, message text, seconds real, numbers text
);
"""


@dataclass(frozen=True, kw_only=True, eq=False)
class Contents:
    """What a ledger holds from its beginning.

    whole : the parts of the study that its numbers depend on, by name. more : what is kept beside them. results : name -> text
    and unit.
    """

    whole: Mapping[str, Any]
    more: Mapping[str, Any]
    points: Points
    results: Mapping[str, tuple[str, str]]


def identity(parts: Mapping[str, Any]) -> dict[str, str]:
    """Of each part of a study a hash: equal ones mean the same numbers."""
    texts = {name: json.dumps(one, sort_keys=True, default=str) for name, one in parts.items()}
    return {name: hashlib.sha256(text.encode()).hexdigest()[:16] for name, text in texts.items()}


@dataclass(frozen=True, eq=False)
class Ledger:
    """An open ledger. path : its folder; None in memory."""

    path: Path | None
    connection: sqlite3.Connection

    def about(self, name: str) -> Any:
        """Something that was kept with the study."""
        found = self.connection.execute("select value from about where name = ?", (name,)).fetchone()
        return None if found is None else json.loads(found[0])

    def note(self, name: str, what: Any) -> None:
        """Keep something with the study, at once."""
        self.connection.execute("insert or replace into about values (?, ?)", (name, json.dumps(what)))
        self.commit()

    @property
    def left(self) -> list[int]:
        """The rows that are not done."""
        return [row for (row,) in self.connection.execute("select row from rows where status is null order by row")]

    @property
    def count(self) -> int:
        """Number of rows."""
        return int(self.connection.execute("select count(*) from rows").fetchone()[0])

    def add(self, outcomes: Iterable[Outcome]) -> None:
        """Keep outcomes; a row that is done already stays as it is."""
        self.connection.executemany(
            "update rows set status = ?, message = ?, seconds = ?, numbers = ? where row = ? and status is null",
            [
                (one.status, one.message, one.seconds, None if one.numbers is None else json.dumps(dict(one.numbers)), one.row)
                for one in outcomes
            ],
        )

    def set_units(self, units: Mapping[str, str]) -> None:
        """The units of the results, which are known with the first numbers."""
        self.connection.executemany(
            "update results set unit = ? where name = ?", [(unit, name) for name, unit in units.items()]
        )

    def commit(self) -> None:
        """All that was added is kept from now on.

        Raises
        ------
        StoreError : it cannot be written, e.g. the disk is full; what was committed before stays.
        """
        try:
            self.connection.commit()
        except sqlite3.Error as error:
            raise StoreError(
                f"{self.path}: {error}. Rows that were committed are kept. Make room, and start the study again: it goes on."
            ) from error

    def table(self) -> dict[str, list[Any]]:
        """All rows as columns: row, the variables, status, message, seconds, the results (NaN without a number)."""
        variables = [name for (name,) in self.connection.execute("select name from variables order by rowid")]
        results = [name for (name,) in self.connection.execute("select name from results order by rowid")]
        found: dict[str, list[Any]] = {name: [] for name in ("row", *variables, "status", "message", "seconds", *results)}
        query = "select row, given, status, message, seconds, numbers from rows order by row"
        for row, given, status, message, seconds, numbers in self.connection.execute(query):
            kept = {} if numbers is None else json.loads(numbers)
            values = json.loads(given)
            found["row"].append(row)
            for name, value in zip(variables, values, strict=True):
                found[name].append(value)
            found["status"].append(status or "")
            found["message"].append(message or "")
            found["seconds"].append(math.nan if seconds is None else seconds)
            for name in results:
                found[name].append(kept.get(name, math.nan))
        return found

    def units(self, table: str) -> dict[str, str | None]:
        """Of all variables or results their unit; of variables None of texts."""
        query = {"variables": "select name, unit from variables", "results": "select name, unit from results"}[table]
        return dict(self.connection.execute(f"{query} order by rowid").fetchall())


@contextmanager
def claimed(path: Path, contents: Contents, overwrite: bool) -> Iterator[Ledger]:
    """The ledger of a study in a folder, held by this process: a new one, or that of the same study.

    Raises
    ------
    InputError : the folder holds another study, or something else. StoreError : another process writes it, or it cannot be
    written.
    """
    check_unlocked(path)
    _check(path, contents.whole, overwrite)
    with holding(path):
        _check(path, contents.whole, overwrite)  # another process may have been faster
        if overwrite and (path / FILE).exists():
            for name in OWN:
                remove(path / name)
        if not (path / FILE).exists():
            _create(path, contents)
        with closing(_connected(path)) as connection:
            yield Ledger(path, connection)


@contextmanager
def opened(path: Path) -> Iterator[Ledger]:
    """The ledger of a study, to read it; also while another process writes it.

    Raises
    ------
    StoreError : no study, or a damaged one.
    """
    if not is_study(path):
        raise StoreError(f"{path} holds no study. Make one: kinetruss study FILE -o {path}")
    with closing(_connected(path)) as connection:
        try:
            yield Ledger(path, connection)
        except sqlite3.Error as error:
            raise StoreError(f"{path} is damaged: {error}. Start the study again, in another folder.") from error


def is_study(path: Path) -> bool:
    """True for the folder of a study."""
    return (path / FILE).is_file()


def _connected(path: Path) -> sqlite3.Connection:
    return sqlite3.connect(path / FILE, timeout=30.0, isolation_level="DEFERRED")


def _create(path: Path, contents: Contents) -> None:
    """A ledger with all rows, none of which is done."""
    try:
        with whole_file(path / FILE) as draft, closing(sqlite3.connect(draft)) as connection:
            _fill(connection, contents)
    except sqlite3.Error as error:
        raise cannot_write(path / FILE, OSError(str(error))) from error


def _fill(connection: sqlite3.Connection, contents: Contents) -> None:
    points = contents.points
    connection.executescript(TABLES)
    about = {"format": FORMAT, "identity": identity(contents.whole), "began": time.time(), **contents.more, **contents.whole}
    connection.executemany(
        "insert into about values (?, ?)", [(name, json.dumps(one, default=str)) for name, one in about.items()]
    )
    connection.executemany("insert into variables values (?, ?)", zip(points.names, points.units, strict=True))
    connection.executemany("insert into results values (?, ?, ?)", [(name, *one) for name, one in contents.results.items()])
    connection.executemany(
        "insert into rows (row, given) values (?, ?)", ((k, json.dumps(values)) for k, values in enumerate(points.rows))
    )
    connection.commit()


@contextmanager
def in_memory(contents: Contents) -> Iterator[Ledger]:
    """A ledger that is not kept."""
    with closing(sqlite3.connect(":memory:")) as connection:
        _fill(connection, contents)
        yield Ledger(None, connection)


def _check(path: Path, whole: Mapping[str, Any], overwrite: bool) -> None:
    """Raise an error if the folder is of something else."""
    if not path.exists():
        return
    if not path.is_dir():
        raise InputError(f"{path} is a file. Name a folder for the study.")
    inside = [one.name for one in path.iterdir()]
    if all(name == LOCK or (name.startswith(f".{Path(FILE).stem}.") and PART in name) for name in inside):
        return
    if FILE not in inside:
        raise InputError(
            f"{path} is not empty and is no study, so it is never overwritten. Name another folder, or empty it yourself."
        )
    if overwrite:
        return
    with opened(path) as ledger:
        kept, own = ledger.about("identity") or {}, identity(whole)
    if other := [name for name in own if own[name] != kept.get(name)]:
        raise InputError(
            f"{path} holds another study, with other {' and '.join(other)}. "
            "Name another folder, or replace it with --overwrite (overwrite=True)."
        )


# The results as a file for other programs.


def write_parquet(ledger: Ledger, arrow: Any, parquet: Any) -> Path:
    """All rows as one Parquet file: a column for each variable, with its unit, and for each result; it appears whole."""
    table, texts = ledger.table(), {"status", "message"}
    units = {**ledger.units("variables"), **ledger.units("results"), "seconds": "s"}
    texts |= {name for name, unit in ledger.units("variables").items() if unit is None}
    fields, columns = [], []
    for name, values in table.items():
        kind = arrow.int64() if name == "row" else arrow.string() if name in texts else arrow.float64()
        unit = units.get(name) or ""
        fields.append(arrow.field(name, kind, metadata={"unit": unit} if unit else None))
        columns.append(arrow.array([str(one) for one in values] if name in texts else values, kind))
    path = (ledger.path or Path()) / RESULTS
    with whole_file(path) as draft:
        parquet.write_table(arrow.table(columns, schema=arrow.schema(fields)), draft, compression="zstd")
    return path
