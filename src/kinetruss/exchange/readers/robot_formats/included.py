"""Files that an MJCF file includes."""

from __future__ import annotations

from pathlib import Path

from kinetruss.exchange.readers.robot_formats.xml import Element, parse_xml
from kinetruss.exchange.readers.texts import text_of
from kinetruss.limits import MOST_ENTRIES

__all__ = ["beside", "included"]

ROOTS = ("mujocoinclude", "mujoco")


def included(root: Element, folder: Path, max_size: int) -> Element:
    """The tree with each <include file="..."/> replaced by the elements of that file, whose path starts at `folder`.

    Raises
    ------
    ModelError : a file that is not there, not XML, outside the folder, or included twice.
    """
    return _expanded(root, folder, max_size, set(), [0])


def _expanded(element: Element, folder: Path, max_size: int, seen: set[Path], count: list[int]) -> Element:
    children: list[Element] = []
    for child in element.children:
        count[0] += 1
        if count[0] > MOST_ENTRIES:
            raise child.fault(f"makes more than {MOST_ENTRIES:,} elements.", "Give a smaller file.")
        if child.tag == "include":
            other = _file(child, folder, max_size, seen)
            children += _expanded(other, folder, max_size, seen, count).children
        else:
            children.append(_expanded(child, folder, max_size, seen, count))
    return Element(element.file, element.tag, element.line, element.attributes, children)


def _file(element: Element, folder: Path, max_size: int, seen: set[Path]) -> Element:
    path = beside(element, folder, folder)
    if path.resolve() in seen:
        raise element.fault(f"includes {element.text('file')!r} a second time.", "MuJoCo allows a file once. Remove one.")
    seen.add(path.resolve())
    return parse_xml(path, text_of(path, max_size), ROOTS)


def beside(element: Element, folder: Path, top: Path) -> Path:
    """The file that an element names from the folder `top`, which must be in the folder of the model."""
    name = element.text("file")
    path = top / name
    if not path.resolve().is_relative_to(folder.resolve()):
        raise element.fault(f"file {name!r} is outside the folder of the model.", "Move it beside the model, or below.")
    if not path.is_file():
        raise element.fault(f"file {name!r} is not there.", f"Put it into {top}, or correct the name.")
    return path
