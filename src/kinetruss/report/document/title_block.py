"""What a reader asks of a report first: title block and logo."""

from __future__ import annotations

import base64
import re
import struct
import xml.etree.ElementTree as ET
import zlib
from dataclasses import dataclass
from pathlib import Path

from kinetruss.errors import InputError
from kinetruss.model import TitleBlock

PAPERS = {"a4": "A4", "letter": "letter"}
"""Sizes of paper by name, as CSS names them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Front:
    """block : title block. logo : a ``data:`` address, or empty. paper : one of `PAPERS`. view : a page in three dimensions, or
    empty. summary : only result, figure, governing calculation and assumptions.
    """

    block: TitleBlock
    logo: str = ""
    paper: str = "a4"
    view: str = ""
    summary: bool = False


def front_of(
    block: TitleBlock | None,
    own: TitleBlock | None,
    date: str,
    *,
    view: str = "",
    paper: str = "a4",
    logo: str | Path | None = None,
    summary: bool = False,
) -> Front:
    """The front of a report; empty entries of the block are those of the model. logo : a PNG or SVG file.

    Raises
    ------
    InputError : unknown paper; a logo that cannot be used.
    """
    if paper not in PAPERS:
        raise InputError(f"No paper called {paper!r}. Give one of {', '.join(PAPERS)}.")
    mark = "" if logo is None else read_logo(logo)
    return Front(block=filled(block, own, date), logo=mark, paper=paper, view="" if summary else view, summary=summary)


# The logo of a title block: a PNG or SVG file, checked, as a data address that the page carries.

LARGEST = 1_000_000
"""Size of a file, bytes: every copy of the report carries it."""
SIDE = 4000
"""Largest width and height of a PNG, dots."""
SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
"""Colour type of a PNG -> numbers of a dot (PNG, third edition, 11.2.1)."""
SVG = "{http://www.w3.org/2000/svg}"
ACTIVE = {"script", "foreignObject", "iframe", "handler", "listener", "set", "animate", "animateTransform", "animateMotion"}
"""Elements that run or change, or hold another page."""
OUTSIDE = re.compile(r"url\(\s*['\"]?(?!\s*#|data:image/)|@import", re.IGNORECASE)
"""In a style: an address that is not within the file."""


def read_logo(file: str | Path) -> str:
    """A logo as a ``data:`` address.

    Raises
    ------
    InputError : the file cannot be read, is larger than 1 MB, is neither PNG nor SVG, is damaged, or is an SVG that runs
    scripts or refers to another file.
    """
    path = Path(file)
    try:
        data = path.read_bytes() if path.stat().st_size <= LARGEST else b""
    except OSError as error:
        raise InputError(f"The logo {path} cannot be read ({error.strerror}). Give a PNG or SVG file.") from None
    if not data:
        size = path.stat().st_size
        raise InputError(f"The logo {path} has {size:,} bytes: give a file of 1 to {LARGEST:,}. A logo needs no more.")
    png = data.startswith(SIGNATURE)
    fault = _png_fault(data) if png else _svg_fault(data)
    if fault:
        raise InputError(f"The logo {path} {fault}")
    return f"data:image/{'png' if png else 'svg+xml'};base64,{base64.b64encode(data).decode('ascii')}"


def _png_fault(data: bytes) -> str:
    """What is wrong with a PNG; an empty text for none."""
    mend = "Save it again as PNG."
    place, pixels, header, ended = len(SIGNATURE), b"", b"", False
    while place + 12 <= len(data) and not ended:
        (size,) = struct.unpack(">I", data[place : place + 4])
        kind, body = data[place + 4 : place + 8], data[place + 8 : place + 8 + size]
        if data[place + 8 + size : place + 12 + size] != struct.pack(">I", zlib.crc32(kind + body)):
            return f"is damaged: the part at byte {place} has another checksum. {mend}"
        header = body if kind == b"IHDR" and len(body) == 13 else header
        pixels += body if kind == b"IDAT" else b""
        ended = kind == b"IEND"
        place += 12 + size
    if not (ended and header and pixels):
        return f"is not complete: a PNG has a header, its dots and an end. {mend}"
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", header)
    if not (0 < width <= SIDE and 0 < height <= SIDE):
        return f"is {width} by {height} dots: give 1 to {SIDE} each way."
    if colour not in CHANNELS:
        return f"has the unknown colour type {colour}. {mend}"
    wanted = height * (1 + -(-width * depth * CHANNELS[colour] // 8))
    try:
        found = len(zlib.decompressobj().decompress(pixels, 2 * wanted + 4096))
    except zlib.error:
        return f"is damaged: its dots cannot be unpacked. {mend}"
    return f"is not complete: dots are missing. {mend}" if found < wanted and not interlaced else ""


def _svg_fault(data: bytes) -> str:
    """What is wrong with an SVG; an empty text for none."""
    if re.search(rb"<!(DOCTYPE[^>\[]*\[|ENTITY)", data):
        return "declares entities. Save it as plain SVG, without a DOCTYPE."
    try:
        root = ET.fromstring(data)
    except (ET.ParseError, ValueError) as error:
        return f"is neither PNG nor SVG ({error}). Give a PNG or SVG file."
    if root.tag != f"{SVG}svg":
        return f"is XML, but no SVG: its first element is {root.tag!r}. Give a PNG or SVG file."
    if not root.get("viewBox") and not (root.get("width") and root.get("height")):
        return "has no size: give its svg element a viewBox."
    for one in root.iter():
        if fault := _element_fault(one):
            return fault
    return ""


def _element_fault(one: ET.Element) -> str:
    name = one.tag.rpartition("}")[2] if isinstance(one.tag, str) else ""
    if name in ACTIVE:
        return f"has a {name} element, and a report must not run or change. Save it as plain SVG."
    if name == "style" and OUTSIDE.search(one.text or ""):
        return "has a style that refers to another file, and a report makes no request. Embed it, or leave it out."
    for key, value in one.attrib.items():
        plain = key.rpartition("}")[2]
        if plain.lower().startswith("on"):
            return f"has the script {plain!r} at {name!r}, and a report must not run any. Save it as plain SVG."
        if plain in ("href", "src") and name != "a" and not re.match(r"\s*(#|data:image/)", value):
            return f"refers to {value[:60]!r} at {name!r}, and a report makes no request. Embed it, or leave it out."
        if OUTSIDE.search(value):
            return f"refers to another file in {plain!r} at {name!r}, and a report makes no request. Embed it, or leave it out."
    return ""


# The title block of a report: what is known of the document, and lines for what is not.

ROWS = (("project", "client"), ("number", "revision"), ("author", "date"), ("checker", "checked"))
TITLE_WORDS = {"number": "document", "checked": "date of the check"}
SIGNED = ("author", "checker")


def filled(block: TitleBlock | None, own: TitleBlock | None, date: str = "") -> TitleBlock:
    """A title block whose empty entries are those of a model, and its date that of the report."""
    fields = {"date": date}
    for given in (own, block):
        fields |= {} if given is None else {name: value for name, value in given.model_dump().items() if value}
    return TitleBlock(**fields)
