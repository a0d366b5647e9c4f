"""Names of other entries: what a field may name, said once in its annotation, and the walk that finds the unknown ones."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from functools import cache, partial
from operator import attrgetter
from types import UnionType
from typing import TYPE_CHECKING, Annotated, Any, Union, get_args, get_origin

from kinetruss.errors import Fault, shown
from kinetruss.model.record import Name, Record
from kinetruss.model.words import SECTIONS, nearest
from kinetruss.shelves import shelf

if TYPE_CHECKING:
    from pydantic import GetJsonSchemaHandler

    from kinetruss.model.data import ModelData

Path = tuple[Any, ...]


class Ref:
    """Annotation of a text field, or of the keys of a table: the name of an entry of the model.

    word : for such an entry in messages. tables : that may define it; of ``poses`` the name has a coordinate behind a dot.
    known : all names that a model has; by default those of its tables. also : names that stand for no entry.
    advice : what to do where no known name is similar.
    """

    def __init__(
        self,
        word: str,
        *tables: str,
        known: Callable[[Any], Iterable[str]] | None = None,
        also: tuple[str, ...] = (),
        advice: str = "",
    ) -> None:
        self.word, self.tables, self.known, self.also, self.advice = word, tables, known, also, advice

    def names(self, model: ModelData) -> dict[str, None]:
        """All names that a field of this kind may have, in the order of the model."""
        own = self.known(model) if self.known else (name for table in self.tables for name in getattr(model, table))
        return dict.fromkeys([*own, *self.also])

    def fault(self, model: ModelData, name: str, path: Path) -> Fault:
        """That of an unknown name, with the most similar ones, those of the library included."""
        inner = getattr(model, "inner", None)
        hidden = {} if inner is None else {**inner.bars, **inner.nodes, **inner.couplings, **inner.bodies}
        library = (one for table in self.tables for one in shelf(table))
        mend = nearest(name, dict.fromkeys([*(one for one in self.names(model) if one not in hidden), *library]))
        if name in model.links and "links" not in self.tables and "bars" in self.tables:
            mend = f"{shown(name)} is a link, which keeps its length: name a bar, or drive an angle of the link."
        if name in model.beams and "links" in self.tables and "bars" in self.tables:
            mend = f"{shown(name)} is a beam: name the line between its ends, {shown(name + '.chord')}."
        if self.advice and not mend.startswith("Did"):
            mend = f"{self.advice} By name, {mend[0].lower()}{mend[1:]}"
        about = tuple((table, name.rpartition(".")[0] if table == "poses" else name) for table in self.tables)
        return Fault(path, f"no {self.word} called {shown(name)}.", mend, about=about)

    def __get_pydantic_json_schema__(self, schema: Any, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return handler(schema) | {"x-names": [*self.tables], **({"x-also": [*self.also]} if self.also else {})}


class Unread:
    """Annotation of records whose names are of another kind in this place, and are not looked for."""


NodeName = Annotated[Name, Ref("node", "nodes")]
MemberName = Annotated[Name, Ref("member", "bars", "active")]
TurningName = Annotated[Name, Ref("member", "bars", "active", "links")]
BarName = Annotated[Name, Ref("bar", "bars")]
CouplingName = Annotated[Name, Ref("coupling", "couplings")]
SectionName = Annotated[Name, Ref("section", "sections", advice=SECTIONS)]
MaterialName = Annotated[Name, Ref("material", "materials")]
ScrewName = Annotated[Name, Ref("screw", "screws")]
GearName = Annotated[Name, Ref("gear", "gears")]
MotorName = Annotated[Name, Ref("motor", "motors")]
AmplifierName = Annotated[Name, Ref("amplifier", "amplifiers")]
LoadName = Annotated[Name, Ref("load", "loads")]
LoadCaseName = Annotated[Name, Ref("load case", "load_cases", "combinations", known=attrgetter("cases"))]
LoadCaseNames = Annotated[
    Name, Ref("load case", "load_cases", "combinations", known=lambda model: (*model.cases, *model.combinations))
]
ConditionName = Annotated[Name, Ref("condition", "conditions")]
TrajectoryName = Annotated[Name, Ref("trajectory", "trajectories")]
MotionName = Annotated[Name, Ref("run or trajectory", "runs", "trajectories")]
DriveName = Annotated[Name, Ref("drive", "drives", "bars", "active", known=attrgetter("all_drives"))]


# The walk: each class of records is read once for the fields in which names can stand.

Unknown = Sequence[tuple[Ref, str, Path]]
"""Names that are not known, with their places in a value."""
Known = Callable[[Ref], Collection[str]]
Reader = Callable[[Any, Known], Unknown]


def unknown_names(model: ModelData, value: Any, path: Path, field: tuple[type[Record], str] | None = None) -> list[Fault]:
    """A fault for every name in a record, at any depth, that the model does not know.

    field : the record and its field whose value is given, if this is no record itself.

    >>> import kinetruss as kt
    >>> model = kt.library.mechanisms.four_bar()
    >>> [str(fault) for fault in unknown_names(model, kt.LengthDrive("crnk"), ("drives", "d"))]
    ["drives.d.bar: no member called 'crnk'. Did you mean 'crank'?"]
    """
    read = _of_record if field is None else dict(readers(field[0]))[field[1]]
    unknown = read(value, cache(lambda ref: ref.names(model)))
    return [ref.fault(model, name, (*path, *place)) for ref, name, place in unknown]


def names_in(record: Record) -> Unknown:
    """What every name in a record refers to, the name, and its place.

    >>> import kinetruss as kt
    >>> [(ref.word, name, place) for ref, name, place in names_in(kt.Bar(ends=("A", "B")))]
    [('node', 'A', ('ends', 0)), ('node', 'B', ('ends', 1))]
    """
    return _of_record(record, lambda _: ())


@cache
def readers(record: type[Record]) -> tuple[tuple[str, Reader], ...]:
    """The fields of a record in which names can stand, or records."""
    found = ((name, _reader(field.annotation, field.metadata)) for name, field in record.model_fields.items())
    return tuple((name, read) for name, read in found if read is not None)


def _reader(hint: Any, marks: Iterable[Any] = ()) -> Reader | None:
    """What finds the names in a value of this type; None if there can be none."""
    choices = [(get_origin(kind) or kind, _reader_of(kind, own)) for kind, own in kinds(hint, marks)]
    found = [(kind, read) for kind, read in choices if read is not None]
    if len(found) == 1 and (len(choices) == 1 or found[0][0] is str):
        return found[0][1]
    return partial(_of_union, found) if found else None


def _reader_of(kind: Any, marks: Iterable[Any]) -> Reader | None:
    for mark in marks:
        if isinstance(mark, Ref):
            return partial(_of_name, mark)
        if isinstance(mark, Unread):
            return None
    if isinstance(kind, type) and issubclass(kind, Record):
        return _of_record  # which reads its class when there is one
    parts = [_reader(one) for one in get_args(kind) if one is not Ellipsis] if get_origin(kind) in (dict, tuple) else []
    return partial(_of_table if get_origin(kind) is dict else _of_list, parts) if any(parts) else None


def kinds(hint: Any, marks: Iterable[Any] = ()) -> Iterator[tuple[Any, Iterable[Any]]]:
    """The types that a value may have, each with its annotations."""
    if get_origin(hint) is Annotated:
        yield from kinds(hint.__origin__, (*marks, *hint.__metadata__))
    elif get_origin(hint) in (Union, UnionType):
        for one in get_args(hint):
            yield from kinds(one, marks)
    else:
        yield hint, marks


def _below(key: str | int, unknown: Unknown) -> Unknown:
    return [(ref, name, (key, *place)) for ref, name, place in unknown]


def _of_name(ref: Ref, value: str, known: Known) -> Unknown:
    return ((ref, value, ()),) if isinstance(value, str) and value not in known(ref) else ()


def _of_record(value: Record, known: Known) -> Unknown:
    found: list[tuple[Ref, str, Path]] = []
    values = vars(value)
    for name, read in readers(type(value)):
        if (below := values[name]) and (unknown := read(below, known)):
            found += _below(name, unknown)
    return found


def _of_table(parts: Sequence[Reader | None], value: Mapping[str, Any], known: Known) -> Unknown:
    key, entry = parts
    found: list[tuple[Ref, str, Path]] = []
    for name, below in value.items():
        if key is not None and (unknown := key(name, known)):
            found += _below(name, unknown)
        if entry is not None and (unknown := entry(below, known)):
            found += _below(name, unknown)
    return found


def _of_list(parts: Sequence[Reader | None], value: Sequence[Any], known: Known) -> Unknown:
    found: list[tuple[Ref, str, Path]] = []
    last = len(parts) - 1
    for index, below in enumerate(value):
        read = parts[index if index < last else last]
        if read is not None and (unknown := read(below, known)):
            found += _below(index, unknown)
    return found


def _of_union(choices: Sequence[tuple[type, Reader]], value: Any, known: Known) -> Unknown:
    for kind, read in choices:
        if isinstance(value, kind):
            return read(value, known)
    return ()


def matched(names: Sequence[str], pattern: str) -> list[str]:
    """The names that match a pattern: the pattern itself if it is a name, else all that fit it.

    >>> matched(["M1", "M2", "M13"], "M[12]"), matched(["M1"], "M1")
    (['M1', 'M2'], ['M1'])
    """
    return [pattern] if pattern in names else [name for name in names if fnmatchcase(name, pattern)]
