"""Scenes as bytes: a header in JSON and arrays in a form that compresses well and that a browser reads quickly.

bytes   = MAGIC, n (uint32), n bytes of zlib stream 1, zlib stream 2
stream 1 = header length (uint32), header, plain arrays; stream 2 = histories. An array begins at ``at`` of its stream
    (in stream 1 counted from the end of the header).
plain   = an array as it is in memory.
history = an array over time. Its bytes are in planes: all lowest bytes, then the next, .., of
    ``float32``  words w: w[k] - w[k-1] (mod 2^32)                             exact to float32
    ``rounded``  q = round(value/2^e) - base, by column (e int8, base int32): differences over time of the given
                 ``order`` (mod 2^16), zigzag coded
All numbers are little endian.
"""

from __future__ import annotations

import json
import zlib
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.errors import InputError
from kinetruss.viewer.moving import FORMAT, VERSION, Scene

if TYPE_CHECKING:
    from numpy.typing import NDArray


MAGIC = b"KTSCENE1"
LEVELS = {"position": 2**16, "member_force": 2**16}
"""Rounding steps over the range of each curve in a rounded scene; other histories get `FEW`."""
FEW = 2**12
FINEST = 2.0**-30
"""Smallest step relative to the largest value of a kind of curve: smaller differences are round-off, which compresses badly."""
ORDERS = (1, 2, 3)


def pack(scene: Scene) -> bytes:
    """A scene as compressed bytes.

    >>> import kinetruss as kt
    >>> scene = kt.viewer.scene(kt.library.vgt.triangular())
    >>> data = kt.viewer.pack(scene)  # bytes, for a page or a websocket
    >>> kt.viewer.unpack(data).header["nodes"] == scene.header["nodes"]
    True
    """
    rounded = bool(scene.header["rounded"])
    table: dict[str, dict[str, Any]] = {}
    plain: list[bytes] = []
    histories: list[bytes] = []
    for name, values in scene.arrays.items():
        blocks = histories if name in scene.header["histories"] else plain
        entry: dict[str, Any] = {"shape": list(values.shape), "at": sum(map(len, blocks))}
        table[name] = entry
        if blocks is plain:
            entry |= {"form": "plain", "type": "int32" if values.dtype.kind in "iub" else "float32"}
            blocks.append(np.ascontiguousarray(values, "<i4" if entry["type"] == "int32" else "<f4").tobytes())
        elif rounded and np.isfinite(values).all():
            blocks += _rounded(values, entry, LEVELS.get(name, FEW))
        else:
            entry["form"] = "float32"
            blocks.append(_words(values))
    header = json.dumps({**scene.header, "arrays": table}, ensure_ascii=False, allow_nan=False).encode()
    first = zlib.compress(b"".join([len(header).to_bytes(4, "little"), header, *plain]), 6)
    # rounded curves have no repeated strings: use run lengths and Huffman codes only
    squeeze = zlib.compressobj(1, zlib.DEFLATED, 15, 9, zlib.Z_RLE) if rounded else zlib.compressobj(9)
    second = [squeeze.compress(block) for block in histories]
    return b"".join([MAGIC, len(first).to_bytes(4, "little"), first, *second, squeeze.flush()])


def unpack(data: bytes) -> Scene:
    """The scene of `pack`; histories come back as float32.

    Raises
    ------
    InputError : not a scene, or of another version.

    Examples
    --------
    >>> import kinetruss as kt
    >>> scene = kt.viewer.scene(kt.library.vgt.triangular())
    >>> kt.viewer.unpack(kt.viewer.pack(scene)).header == scene.header
    True
    """
    if not data.startswith(MAGIC):
        raise InputError("These bytes are no kinetruss scene.")
    begin = len(MAGIC) + 4
    end = begin + int.from_bytes(data[begin - 4 : begin], "little")
    first, second = zlib.decompress(data[begin:end]), zlib.decompress(data[end:])
    start = 4 + int.from_bytes(first[:4], "little")
    header = json.loads(first[4:start])
    if (header["format"], header["version"]) != (FORMAT, VERSION):
        raise InputError(f"Scene version {header['version']} is not known here. This release reads {VERSION}.")
    arrays = {}
    for name, entry in header.pop("arrays").items():
        plain = entry["form"] == "plain"
        arrays[name] = _plain(first, start, entry) if plain else _history(second, entry)
    return Scene(header=header, arrays=arrays)


def _words(values: NDArray[Any]) -> bytes:
    words = np.array(values, "<f4", order="C").reshape(len(values), -1).view("<u4")
    words[1:] -= words[:-1].copy()
    return _planes(words, 4)


def _rounded(values: NDArray[Any], entry: dict[str, Any], levels: int) -> list[bytes]:
    """Exponents and bases of the columns, then the planes of the coded differences."""
    columns = values.reshape(len(values), -1)
    low, high = columns.min(axis=0), columns.max(axis=0)
    largest = max(float(np.abs(columns).max(initial=0.0)), float(np.finfo(np.float32).tiny) / FINEST)
    least = np.maximum((high - low) / (levels - 2), largest * FINEST)
    exponent = np.ceil(np.log2(least)).astype(int)
    step = np.ldexp(1.0, exponent)
    base = np.rint(low / step)
    order, signed = _differences(np.rint(columns / step - base).astype("<u2"))
    coded = ((signed << 1) ^ (signed >> 15)).view("<u2")
    entry |= {"form": "rounded", "levels": levels, "order": order}
    return [exponent.astype("i1").tobytes(), base.astype("<i4").tobytes(), _planes(coded, 2)]


def _differences(q: NDArray[Any]) -> tuple[int, NDArray[Any]]:
    """The order of differences over time with the smallest remainder, judged by some columns, and those differences (int16)."""
    some = q[:, :: max(1, q.shape[1] // 200)]
    left = [int(np.abs(_differenced(some.copy(), order).astype(int)).sum()) for order in ORDERS]
    order = ORDERS[left.index(min(left))]
    return order, _differenced(q, order)


def _differenced(q: NDArray[Any], order: int) -> NDArray[Any]:
    for first in range(1, order + 1):
        q[first:] -= q[first - 1 : -1].copy()
    return q.view("<i2")


def _planes(words: NDArray[Any], size: int) -> bytes:
    return np.ascontiguousarray(words.reshape(-1).view("u1").reshape(-1, size).T).tobytes()


def _plain(body: bytes, start: int, entry: dict[str, Any]) -> NDArray[Any]:
    shape = tuple(entry["shape"])
    kind = "<i4" if entry["type"] == "int32" else "<f4"
    return np.frombuffer(body, kind, int(np.prod(shape)), start + entry["at"]).reshape(shape)


def _history(body: bytes, entry: dict[str, Any]) -> NDArray[Any]:
    shape, at = tuple(entry["shape"]), entry["at"]
    count = int(np.prod(shape))
    if entry["form"] == "float32":
        words = _joined(body, at, count, 4, "<u4").reshape(shape[0], -1)
        return np.cumsum(words, axis=0, dtype="<u4").view("<f4").reshape(shape)
    columns = count // shape[0]
    exponent = np.frombuffer(body, "i1", columns, at).astype(int)
    base = np.frombuffer(body, "<i4", columns, at + columns)
    coded = _joined(body, at + 5 * columns, count, 2, "<u2").reshape(shape[0], columns)
    q = (coded >> 1) ^ -(coded & 1)
    for first in range(entry["order"] - 1, -1, -1):
        q[first:] = np.cumsum(q[first:], axis=0, dtype="<u2")
    values: NDArray[Any] = np.ldexp(q + base.astype(float), exponent)
    return values.astype("f4").reshape(shape)


def _joined(body: bytes, at: int, count: int, size: int, kind: str) -> NDArray[Any]:
    planes = np.frombuffer(body, "u1", size * count, at).reshape(size, count)
    return np.ascontiguousarray(planes.T).reshape(-1).view(kind)
