"""Reads from a printed report on which pages its sections begin, and how far its last page is filled.

Chromium writes the destinations of links as plain objects: ``/Dests`` names them, and each is an array of a page, ``/XYZ``
and a place in points from the lower left corner (PDF 32000-1:2008, 12.3.2).
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field

__all__ = ["Paper", "read_paper"]


@dataclass(frozen=True, slots=True)
class Paper:
    """pages : number of them. starts : name of a destination -> number of its page, from 1. left : height below the end of
    the text on the last page, of the page; 0 if it is not known.
    """

    pages: int = 0
    starts: dict[str, int] = field(default_factory=dict)
    left: float = 0.0


def read_paper(data: bytes, end: str = "end") -> Paper:
    """What a printed file says of its pages; empty if it is written in another way."""
    objects = {int(number): body for number, body in re.findall(rb"(?:^|\n)(\d+) 0 obj\n(.*?)\nendobj", data, re.DOTALL)}
    order = _pages(objects)
    starts: dict[str, int] = {}
    left = 0.0
    for name, page, place in _destinations(objects):
        if page in order:
            starts[name] = order.index(page) + 1
            if name == end and starts[name] == len(order):
                left = place / _height(objects[page])
    return Paper(len(order), starts, left)


def _pages(objects: dict[int, bytes]) -> list[int]:
    """Numbers of the page objects in their order."""
    root = next((number for number, body in objects.items() if b"/Type /Catalog" in body), None)
    found: list[int] = []
    if root is None or not (first := re.search(rb"/Pages (\d+) 0 R", objects[root])):
        return found
    waiting = [int(first[1])]
    while waiting:
        number = waiting.pop(0)
        body = objects.get(number, b"")
        kids = re.search(rb"/Kids \[(.*?)\]", body, re.DOTALL)
        if kids:
            waiting = [int(one) for one in re.findall(rb"(\d+) 0 R", kids[1])] + waiting
        elif b"/Type /Page" in body:
            found.append(number)
    return found


def _destinations(objects: dict[int, bytes]) -> list[tuple[str, int, float]]:
    """Name, page object and height, points, of every destination."""
    for body in objects.values():
        if b"/Type /Catalog" in body and (place := re.search(rb"/Dests (\d+) 0 R", body)):
            listed = objects.get(int(place[1]), b"")
            found = re.findall(rb"/([^\s/\[]+) \[(\d+) 0 R\s*/XYZ \S+ (\S+) ", listed)
            return [(name.decode("latin-1"), int(page), float(height)) for name, page, height in found]
    return []


def _height(page: bytes) -> float:
    box = re.search(rb"/MediaBox \[\s*\S+ \S+ \S+ (\S+?)\s*\]", page)
    return float(box[1]) if box else 842.0
