"""A model from the lines of a DXF drawing."""

from __future__ import annotations

import logging
import math
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from kinetruss.display import counted
from kinetruss.errors import Fault, InputError, ModelError, few, shown
from kinetruss.exchange.drawings import Names, joined, length_of, matches, model_of, unjoined
from kinetruss.exchange.imported import Imported, needed
from kinetruss.exchange.robots import LeftOut
from kinetruss.limits import MOST_ENTRIES, hold
from kinetruss.model import AngleDrive, Bar

UNITS: Mapping[int, float] = {
    1: 0.0254, 2: 0.3048, 3: 1609.344, 4: 1e-3, 5: 1e-2, 6: 1.0, 7: 1e3, 8: 25.4e-9, 9: 25.4e-6, 10: 0.9144, 11: 1e-10,
    12: 1e-9, 13: 1e-6, 14: 0.1, 15: 10.0, 16: 100.0, 21: 1200 / 3937,
}  # fmt: skip
"""Metres of a unit, by the number of $INSUNITS (DXF reference, HEADER section)."""
NEAR = 1e-6
"""Default tolerance of nodes, relative to the size of the drawing."""
FIXED = ("*support*", "*fixed*")
ACTIVE, MOTOR = ("*active*",), ("*motor*",)
LABEL = 0.25
"""Largest distance of a text from the middle of its line, relative to the length of the line."""
CURVES = ("ARC", "CIRCLE", "ELLIPSE", "SPLINE")
MOST_ARCS, DEEPEST = 360, 8
"""Bars of a whole turn of a curve, blocks within each other."""
TAKEN = "--hidden takes it"
MOST_REPAIRS = 5
BROKEN = (
    ArithmeticError, AssertionError, AttributeError, LookupError, OSError, RuntimeError, StopIteration, TypeError, ValueError,
    struct.error,
)  # fmt: skip
"""What ezdxf raises for broken files, besides its own errors."""


@dataclass(eq=False)
class _Drawing:
    """Lines with layer and place in the file, places of supports, texts; in the unit of the drawing.

    arcs : straight bars of a whole turn of a curve; 0: curves are left out. skip : patterns of layers that are left out.
    unseen : layer in lower case -> ``frozen`` or ``off``; empty if what is hidden is taken too (`hidden`).
    """

    path: Path
    arcs: int = 0
    skip: Sequence[str] = ()
    hidden: bool = False
    unseen: dict[str, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    lines: list[tuple[str, Any, Any, str]] = field(default_factory=list)
    supports: list[tuple[Any, str]] = field(default_factory=list)
    texts: list[tuple[Any, str, str]] = field(default_factory=list)
    left: list[LeftOut] = field(default_factory=list)
    layers: dict[str, str] = field(default_factory=dict)
    """Bar -> layer."""

    def fault(self, message: str, mend: str) -> ModelError:
        return ModelError([Fault((), message, mend, file=str(self.path))])


def dxf(
    path: Path, *, max_size: int, unit: str | None = None, tolerance: str | float | None = None, active: Sequence[str] = (),
    fixed: Sequence[str] = (), motor: Sequence[str] = (), skip: Sequence[str] = (), arcs: int = 0, hidden: bool = False,
) -> Imported:  # fmt: skip
    """The model of the lines and polylines in the model space of a drawing, and in the blocks that are inserted there.

    Bars are called ``LAYER.1``, ... by their layer, or after a text at their middle. Patterns of layers: active, whose lines
    become driven bars, which change their length, by default ``*active*``; motor, whose lines are bars that motors turn in the
    plane, by default ``*motor*``; fixed, whose points, circles and inserted symbols mark supports, by default ``*support*`` and
    ``*fixed*``; skip, which are left out, e.g. centre lines. arcs : straight bars of a whole turn of arcs, circles, ellipses,
    and of each piece of a spline; by default curves are left out.
    """
    if arcs and not 3 <= arcs <= MOST_ARCS:
        raise InputError(f"arcs is {arcs}. Give 3 to {MOST_ARCS} bars for a whole turn, or leave it out.")
    drawing, code = _drawn(path, max_size, fixed or FIXED, skip, arcs, hidden)
    scale, notes = _scale(drawing, code, unit)
    notes = drawing.notes + notes
    if not drawing.lines:
        kinds = ", ".join(dict.fromkeys(one.what for one in drawing.left)) or "nothing"
        mend = "Draw members as LINE, LWPOLYLINE or POLYLINE."
        if any(one.why.endswith(TAKEN) for one in drawing.left):
            mend = "Some are hidden: take them with --hidden (hidden=True)."
        raise drawing.fault(f"has no lines in its model space, but {kinds}.", mend)
    ends = np.array([point for _, a, b, _ in drawing.lines for point in (a, b)]) * scale
    size = float(np.ptp(ends, axis=0).max())
    near = NEAR * size if tolerance is None else length_of(tolerance, "tolerance")
    node = joined(ends, near)
    number = {k: f"n{i + 1}" for i, k in enumerate(sorted(set(node.tolist())))}
    places = {name: ends[k] for k, name in number.items()}
    bars = _bars(drawing, [number[k] for k in node.tolist()], places, scale, active or ACTIVE)
    notes += unjoined(places, bars, near)
    held = _supported(drawing, places, scale, max(near, 1e-3 * size))
    if not held:
        notes.append("no supports: put points or circles on a layer called support, or add fixed: to the model")
    turned = [name for name in bars if matches(drawing.layers[name], motor or MOTOR)]
    model = model_of(str(path), places, bars, held, title=path.stem)
    if turned and model.dim == 2:
        model = model.with_(drives={f"{name}.motor": AngleDrive(name) for name in turned})
    elif turned:
        drawing.left += [
            LeftOut("motor", name, "in space an angle needs an axis; add the drive to the model") for name in turned
        ]
    notes.append("bars have no section and no material: give section: and material: in the model")
    return Imported(model=model, source=str(path), left_out=drawing.left, notes=notes)


def _drawn(
    path: Path, max_size: int, fixed: Sequence[str], skip: Sequence[str], arcs: int, hidden: bool
) -> tuple[_Drawing, int]:
    """The drawing, and the number of its unit. A file that ezdxf does not read is repaired as far as it can be."""
    ezdxf = needed("ezdxf", "exchange")
    drawing = _Drawing(path, arcs, skip, hidden)
    if not path.is_file():
        raise drawing.fault("there is no such file.", "Check the name.")
    if path.stat().st_size > max_size:
        raise drawing.fault(f"has more than {max_size:,} bytes.", "Raise --max-size if the file is meant.")
    said = _Said()
    logger = logging.getLogger("ezdxf")
    logger.addHandler(said)
    try:
        try:
            return _collected(drawing, ezdxf.readfile(path), fixed)
        except (*BROKEN, ezdxf.DXFError) as error:
            said_by_it = isinstance(error, (ezdxf.DXFError, OSError))
            words = " ".join(str(error).split()).rstrip(".") if said_by_it else "a value is missing, or is none there"
        try:
            document, audit = needed("ezdxf.recover", "exchange").readfile(path)
            drawing = _Drawing(path, arcs, skip, hidden, notes=[_repaired(words, audit)])
            if len(document.modelspace()):
                return _collected(drawing, document, fixed)
        except (*BROKEN, ezdxf.DXFError):
            pass
        raise drawing.fault(f"is no whole DXF file: {words}.", "Save it again as DXF.")
    finally:
        logger.removeHandler(said)
        drawing.left += [LeftOut("remark of ezdxf", str(path), text) for text in said.texts]


def _repaired(words: str, audit: Any) -> str:
    """The note on a file that was repaired."""
    texts = list(dict.fromkeys(" ".join(one.message.split()).rstrip(".") for one in (*audit.errors, *audit.fixes)))
    more = f"; and {len(texts) - MOST_REPAIRS} more" if len(texts) > MOST_REPAIRS else ""
    listed = "; ".join(texts[:MOST_REPAIRS]) + more if texts else "it names no single repair"
    return f"the file is damaged ({words}); ezdxf repaired it: {listed}. Lines may be missing: compare with the drawing"


def _collected(drawing: _Drawing, document: Any, fixed: Sequence[str]) -> tuple[_Drawing, int]:
    """The drawing with all entities of the model space of a document, and the number of its unit."""
    if not drawing.hidden:
        for layer in document.layers:
            if layer.is_frozen() or layer.is_off():
                drawing.unseen[str(layer.dxf.name).lower()] = "frozen" if layer.is_frozen() else "off"
    for entity in document.modelspace():
        _take(drawing, entity, fixed)
    for name in document.layout_names_in_taborder()[1:]:
        _sheet(drawing, document.layouts.get(name))
    return drawing, int(document.header.get("$INSUNITS", 0))


def _sheet(drawing: _Drawing, layout: Any) -> None:
    """What a layout of the paper space has of its own, and the layers that its viewports do not show."""
    where, views = f"{drawing.path}: layout {shown(layout.name)}", layout.query("VIEWPORT")
    if own := len(layout) - len(views):
        why = f"its paper space has {counted(own, 'entity', 'entities')}; only the model space is read"
        drawing.left.append(LeftOut("layout", where, why))
    frozen = sorted({str(name) for one in views for name in one.frozen_layers})
    if frozen and not drawing.hidden:
        drawing.notes.append(f"{where} does not show the layers {few(frozen, 8)}; they are taken: --skip leaves them out")


class _Said(logging.Handler):
    """Collects what ezdxf logs about a drawing."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self.texts: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        """Keep the text of a record."""
        self.texts.append(record.getMessage())


def _take(drawing: _Drawing, entity: Any, fixed: Sequence[str], within: tuple[str, str] | None = None, level: int = 0) -> None:
    """Collect an entity. within : layer of the inserted block that has it, and its place; level : blocks around it."""
    kind, layer = entity.dxftype(), str(entity.dxf.layer)
    where = f"{drawing.path}: {kind} #{entity.dxf.handle} on layer {shown(layer)}"
    if within is not None:
        where = f"{within[1]}, {kind}"
        layer = within[0] if layer == "0" else layer  # entities of a block on layer 0 are on that of the insertion
    state = drawing.unseen.get(layer.lower(), "")
    if not drawing.hidden and entity.dxf.get("invisible", 0):
        drawing.left.append(LeftOut(kind, where, f"it is invisible; {TAKEN}"))
    elif state == "frozen" or (state and (kind != "INSERT" or matches(layer, fixed))):
        # of an insertion on a layer that is off, other layers are seen
        drawing.left.append(LeftOut(kind, where, f"its layer {shown(layer)} is {state}; {TAKEN}"))
    elif matches(layer, drawing.skip):
        drawing.left.append(LeftOut(kind, where, "its layer is skipped"))
    elif kind in ("POINT", "CIRCLE", "INSERT") and matches(layer, fixed):
        place = entity.dxf.insert if kind == "INSERT" else entity.dxf.center if kind == "CIRCLE" else entity.dxf.location
        drawing.supports.append((_xyz(place if kind == "POINT" else entity.ocs().to_wcs(place)), where))
    elif kind == "LINE":
        drawing.lines.append((layer, _xyz(entity.dxf.start), _xyz(entity.dxf.end), where))
    elif kind == "LWPOLYLINE" or (kind == "POLYLINE" and (entity.is_2d_polyline or entity.is_3d_polyline)):
        points = [_xyz(one) for one in (entity.vertices_in_wcs() if kind == "LWPOLYLINE" else entity.points_in_wcs())]
        points += points[:1] if (entity.closed if kind == "LWPOLYLINE" else entity.is_closed) else []
        drawing.lines += [(layer, a, b, where) for a, b in pairwise(points)]
        if len(points) < 2:
            drawing.left.append(LeftOut(kind, where, "it has less than two points"))
        if entity.has_arc:
            drawing.left.append(LeftOut("arc", where, "arcs of polylines are taken as straight lines between their ends"))
    elif kind == "INSERT":
        _block(drawing, entity, fixed, (layer, where), level)
    elif kind in CURVES and drawing.arcs:
        points = [_xyz(one) for one in _curve(entity, drawing.arcs)]
        drawing.lines += [(layer, a, b, where) for a, b in pairwise(points)]
        hold(len(drawing.lines), str(drawing.path), "Import a smaller part.", most=MOST_ENTRIES, of="lines")
    elif kind in ("TEXT", "ATTRIB", "MTEXT"):
        text = entity.plain_text() if kind == "MTEXT" else entity.dxf.text
        place = entity.dxf.insert if kind == "MTEXT" else entity.ocs().to_wcs(entity.dxf.insert)
        drawing.texts.append((_xyz(place), str(text).strip(), where))
    else:
        why = "only straight lines become bars" + ("; give --arcs N for N bars a turn" if kind in CURVES else "")
        drawing.left.append(LeftOut(kind, where, why))


def _block(drawing: _Drawing, entity: Any, fixed: Sequence[str], within: tuple[str, str], level: int) -> None:
    """The entities of an inserted block, where it puts them; of a grid of insertions each."""
    if level >= DEEPEST:
        drawing.left.append(LeftOut("INSERT", within[1], f"more than {DEEPEST} blocks in each other are not read"))
        return
    if entity.block() is None:
        drawing.left.append(LeftOut("INSERT", within[1], f"the block {shown(entity.dxf.name)} is not in the file"))
        return
    if not len(entity.block()):
        drawing.left.append(LeftOut("INSERT", within[1], f"the block {shown(entity.dxf.name)} is empty"))
    for text in entity.attribs:
        _take(drawing, text, fixed, within, level + 1)
    each = entity.mcount
    hold(each, within[1], "Explode a smaller part.", most=MOST_ENTRIES, of="insertions")
    for one in entity.multi_insert() if each > 1 else [entity]:
        lost: list[str] = []
        for child in one.virtual_entities(skipped_entity_callback=lambda _, why, lost=lost: lost.append(str(why))):
            _take(drawing, child, fixed, within, level + 1)
            hold(
                len(drawing.lines) + len(drawing.left),
                str(drawing.path),
                "Import a smaller part.",
                most=MOST_ENTRIES,
                of="parts",
            )
        drawing.left += [LeftOut("part of a block", within[1], why) for why in lost]


def _curve(entity: Any, arcs: int) -> list[Any]:
    """Points of a curve in order; chords of equal turns of arcs and circles."""
    kind = entity.dxftype()
    if kind in ("ARC", "CIRCLE"):
        start, end = (entity.dxf.start_angle, entity.dxf.end_angle) if kind == "ARC" else (0.0, 360.0)
        turn = (end - start) % 360.0 or 360.0
        count = max(1, math.ceil(turn / 360.0 * arcs - 1e-9))
        return list(entity.vertices([start + turn * k / count for k in range(count + 1)]))
    tool = entity.construction_tool()
    if kind == "ELLIPSE":
        span = tool.param_span
        count = max(1, math.ceil(span / math.tau * arcs - 1e-9))
        return list(tool.vertices([tool.start_param + span * k / count for k in range(count + 1)]))
    return list(tool.approximate(arcs))


def _xyz(point: Any) -> tuple[float, float, float]:
    return float(point[0]), float(point[1]), float(point[2])


def _scale(drawing: _Drawing, code: int, unit: str | None) -> tuple[float, list[str]]:
    """Metres of one unit of the drawing."""
    own = UNITS.get(code)
    if unit is None:
        if own is None:
            raise drawing.fault("names no unit of lengths ($INSUNITS).", "Give it: --unit mm (unit='mm').")
        return own, []
    scale = length_of(unit, "unit")
    if own is not None and abs(scale / own - 1) > 1e-9:
        return scale, [f"the drawing says that its unit is {own:g} m; {unit} was given and is taken"]
    return scale, []


def _bars(
    drawing: _Drawing, node: Sequence[str], places: Mapping[str, Any], scale: float, active: Sequence[str]
) -> dict[str, Bar]:
    """A bar for each line, named after a text beside its middle or after its layer."""
    names, labels = Names(), _labels(drawing, node, places, scale)
    count: dict[str, int] = {}
    bars: dict[str, Bar] = {}
    seen: set[frozenset[str]] = set()
    for index, (layer, _, _, where) in enumerate(drawing.lines):
        ends = node[2 * index], node[2 * index + 1]
        if ends[0] == ends[1]:
            drawing.left.append(LeftOut("line", where, "its two ends are one node"))
        elif frozenset(ends) in seen:
            drawing.left.append(LeftOut("line", where, f"a line from {ends[0]} to {ends[1]} is there already"))
        else:
            seen.add(frozenset(ends))
            count[layer] = count.get(layer, 0) + 1
            name = names.of(labels.get(index, f"{layer}.{count[layer]}"), where, "bar")
            drawing.layers[name] = layer
            bars[name] = Bar(ends=ends, kind="driven" if matches(layer, active) else "rigid")
    drawing.left += names.renamed
    return bars


def _labels(drawing: _Drawing, node: Sequence[str], places: Mapping[str, Any], scale: float) -> dict[int, str]:
    """Number of a line -> the text nearest to its middle."""
    a = np.array([places[name] for name in node[::2]])
    b = np.array([places[name] for name in node[1::2]])
    middle, length = (a + b) / 2, np.linalg.norm(b - a, axis=1)
    found: dict[int, str] = {}
    for place, text, where in drawing.texts:
        away = np.linalg.norm(middle - np.array(place) * scale, axis=1)
        line = int(np.argmin(away))
        if not text or away[line] > LABEL * length[line] or line in found:
            drawing.left.append(LeftOut(f"text {shown(text)}", where, "is beside no middle of a line without a name"))
        else:
            found[line] = text
    return found


def _supported(drawing: _Drawing, places: Mapping[str, Any], scale: float, reach: float) -> list[str]:
    """The nodes at the marks of supports."""
    names, at = list(places), np.array(list(places.values()))
    found = []
    for place, where in drawing.supports:
        away = np.linalg.norm(at - np.array(place) * scale, axis=1)
        if away.min() <= reach:
            found.append(names[int(np.argmin(away))])
        else:
            drawing.left.append(LeftOut("support", where, f"no line ends within {reach:.3g} m of it"))
    return list(dict.fromkeys(found))
