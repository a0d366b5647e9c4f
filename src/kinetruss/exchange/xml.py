"""XML with the line of every element. Document types and entities are refused: no robot description needs them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.parsers import expat

import numpy as np

from kinetruss.display import counted
from kinetruss.errors import Fault, ModelError, shown
from kinetruss.limits import LARGEST, MOST_ENTRIES
from kinetruss.model import nearest

if TYPE_CHECKING:
    from numpy.typing import NDArray


DEEPEST = 500
"""Levels of nesting; a chain of bodies has as many as it has links."""


@dataclass(eq=False)
class Element:
    """An element of a file: its tag, attributes, children and line."""

    file: str
    tag: str
    line: int
    attributes: Mapping[str, str]
    children: list[Element] = field(default_factory=list)

    @property
    def label(self) -> str:
        """Tag and name, for messages."""
        name = self.attributes.get("name")
        return f"<{self.tag} name={shown(name)}>" if name else f"<{self.tag}>"

    @property
    def where(self) -> str:
        """File, line, tag and name."""
        return f"{self.file}:{self.line} {self.label}"

    def fault(self, message: str, mend: str) -> ModelError:
        """The error of this element."""
        return ModelError([Fault((self.label,), message, mend, self.line, 1, file=self.file)])

    def all(self, tag: str) -> Iterator[Element]:
        """Children with a tag."""
        return (child for child in self.children if child.tag == tag)

    def one(self, tag: str) -> Element | None:
        """The child with a tag, None without; an error if there are several."""
        found = list(self.all(tag))
        if len(found) > 1:
            raise found[1].fault(f"is the second <{tag}> of {self.label}.", "Keep one.")
        return found[0] if found else None

    def text(self, name: str, default: str | None = None) -> str:
        """An attribute; an error if it is missing and has no default."""
        found = self.attributes.get(name, default)
        if found is None:
            raise self.fault(f"has no attribute {name!r}.", f'Write <{self.tag} {name}="...">.')
        return found

    def numbers(self, name: str, counts: int | tuple[int, ...], default: Any = None) -> NDArray[np.float64]:
        """Numbers of an attribute; an error if they are not as many, or not finite."""
        text = self.attributes.get(name)
        counts = (counts,) if isinstance(counts, int) else counts
        if text is None and default is not None:
            return np.array(default, float)
        try:
            found = np.array([float(word) for word in self.text(name).split()])
        except ValueError:
            raise self.fault(f"{name} is {shown(text)}, which is not all numbers.", _example(name, counts)) from None
        if len(found) not in counts:
            raise self.fault(
                f"{name} has {counted(len(found), 'number')}; expected {' or '.join(map(str, counts))}.", _example(name, counts)
            )
        if not (np.abs(found) <= LARGEST).all():
            raise self.fault(f"{name} is {shown(text)}: not finite, or beyond {LARGEST:g}.", "Give finite numbers in SI.")
        return found

    def number(self, name: str, default: float | None = None) -> float:
        """One number of an attribute."""
        return float(self.numbers(name, 1, None if default is None else [default])[0])

    def choice(self, name: str, known: tuple[str, ...], default: str | None = None) -> str:
        """One of some words."""
        found = self.text(name, default)
        if found not in known:
            raise self.fault(f"{name} is {shown(found)}.", nearest(found, known))
        return found


def _example(name: str, counts: tuple[int, ...]) -> str:
    return f'Write for example {name}="{" ".join(["0"] * counts[-1])}", with decimal points and spaces between the numbers.'


def parse_xml(path: Path, text: str, root: str | tuple[str, ...]) -> Element:
    """The root element of a text. root : its tag, or tags it may have.

    Raises
    ------
    ModelError : no XML, another root than expected, a document type or an entity, too many or too deeply nested elements.
    """
    file = str(path)
    roots = (root,) if isinstance(root, str) else root
    wanted = " or ".join(f"<{one}>" for one in roots)
    open_: list[Element] = []
    found: list[Element] = []
    count = 0
    parser = expat.ParserCreate()
    parser.buffer_text = True

    def refuse(message: str, mend: str) -> ModelError:
        fault = Fault((), message, mend, parser.CurrentLineNumber, parser.CurrentColumnNumber + 1, file=file)
        return ModelError([fault])

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal count
        count += 1
        if count > MOST_ENTRIES or len(open_) >= DEEPEST:
            raise refuse(f"has more than {MOST_ENTRIES:,} elements, or {DEEPEST} levels.", "Give a smaller file.")
        element = Element(file, tag, parser.CurrentLineNumber, attributes)
        (open_[-1].children if open_ else found).append(element)
        open_.append(element)

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: open_.pop()
    _refuse_entities(parser, refuse)
    try:
        parser.Parse(text.encode(), True)
    except expat.ExpatError as error:
        message = f"is not XML: {expat.errors.messages[error.code]}."
        mend = f"Give a whole file whose elements are all closed, with {wanted} outermost."
        raise ModelError([Fault((), message, mend, error.lineno, error.offset + 1, file=file)]) from None
    if found[0].tag not in roots:
        raise found[0].fault(
            f"is the outermost element; expected {wanted}.", f"Name a file whose outermost element is {wanted}."
        )
    return found[0]


def _refuse_entities(parser: Any, refuse: Callable[[str, str], ModelError]) -> None:
    """Document types could make a short file as large as one likes."""

    def stop(*_: Any) -> None:
        raise refuse("has a document type or an entity.", "Remove <!DOCTYPE ...> and what it defines.")

    parser.StartDoctypeDeclHandler = stop
    parser.EntityDeclHandler = stop
