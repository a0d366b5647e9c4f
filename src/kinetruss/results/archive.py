"""A ZIP archive that grows by appending; after a kill it is good up to a length that is kept elsewhere.

    members      one after another, each behind its header, stored as they are
    directory    behind the last member, once the archive is sealed; the next member is written over it

Without a directory the members are found by walking from header to header, up to the good length. A name that is written
again means the later member; the bytes of the earlier one stay, and the directory does not list them.
Source: PKWARE, .ZIP File Format Specification, APPNOTE.TXT 6.3.10 (2022), sections 4.3 and 4.5.3.
"""

from __future__ import annotations

import io
import os
import struct
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO, NamedTuple
from zlib import crc32

# section 4.3.7, 4.3.12, 4.3.16, 4.3.14 and 4.3.15
_HEADER = struct.Struct("<4s5H3I2H")
_LISTED = struct.Struct("<4s4B4H3I5H2I")
_END = struct.Struct("<4s4H2IH")
_END_64 = struct.Struct("<4sQ2H2I4Q")
_LOCATOR = struct.Struct("<4sIQI")
_PLACE_64 = struct.Struct("<2HQ")
MAGIC = b"PK\3\4"
VERSION, VERSION_64, UNIX, MODE = 20, 45, 3, 0o600 << 16
DATE = 0x21
"""1980-01-01, the first date of the format: the same run gives the same bytes."""
MOST, MANY = 0xFFFF_FFFF, 0xFFFF
"""From this place of a member, or this number of members on, the directory needs the fields of 64 bits."""


class Member(NamedTuple):
    """Where the header of a member begins, the size of its content, bytes, and its checksum."""

    at: int
    size: int
    crc: int


Members = dict[str, Member]


class Archive:
    """An archive opened for writing; `length` bytes of it are good, and what is behind them is cut off.

    members : what it holds, by name.
    """

    def __init__(self, path: Path, length: int = 0) -> None:
        self._file: BinaryIO = os.fdopen(os.open(path, os.O_RDWR | os.O_CREAT, 0o666), "r+b", buffering=0)
        self.length = length
        try:
            self.members = walked(self._file, length)
            self._file.truncate(length)
        except BaseException:
            self._file.close()
            raise

    def append(self, contents: Mapping[str, bytes], *, durable: bool = True) -> None:
        """Write members by name; those that are there already with the same content are left out.

        durable : wait until the disk has them. If it refuses, the archive stays as it was.
        """
        parts, added, at = [], {}, self.length
        for name, content in contents.items():
            one = Member(at, len(content), crc32(content))
            if self._has(name, one, content):
                continue
            head = header(name, one)
            parts += [head, content]
            added[name] = one
            at += len(head) + len(content)
        self._write(b"".join(parts), durable=durable)
        self.members |= added
        self.length = at

    def read(self, name: str) -> bytes:
        """The content of a member. Raises ValueError if it is damaged."""
        return content_of(self._file, name, self.members[name])

    def seal(self, *, durable: bool = True) -> None:
        """Write the directory, with which the file is a whole ZIP archive."""
        self._file.truncate(self.length)
        self._write(directory(self.members, self.length), durable=durable)

    def close(self) -> None:
        """Let the file go as it is."""
        self._file.close()

    def _has(self, name: str, one: Member, content: bytes) -> bool:
        old = self.members.get(name)
        return old is not None and old[1:] == one[1:] and self.read(name) == content

    def _write(self, data: bytes, *, durable: bool) -> None:
        self._file.seek(self.length)
        left = memoryview(data)
        while left:
            left = left[self._file.write(left) :]
        if durable:
            os.fsync(self._file.fileno())


def header(name: str, one: Member) -> bytes:
    """What stands before the content of a member."""
    size, title = one.size, name.encode("ascii")
    return _HEADER.pack(MAGIC, VERSION, 0, 0, 0, DATE, one.crc, size, size, len(title), 0) + title


def content_of(file: BinaryIO, name: str, one: Member) -> bytes:
    """The content of a member. Raises ValueError if its header or its content is not what was written."""
    head = header(name, one)
    file.seek(one.at)
    found = file.read(len(head) + one.size)
    if found[: len(head)] != head or len(found) != len(head) + one.size or crc32(content := found[len(head) :]) != one.crc:
        raise ValueError(f"{name} is not what was written")
    return content


def walked(file: BinaryIO, length: int) -> Members:
    """The members in the first `length` bytes. Raises ValueError if they do not end there."""
    found: Members = {}
    at = 0
    while at < length:
        file.seek(at)
        head = file.read(_HEADER.size)
        if len(head) < _HEADER.size or not head.startswith(MAGIC):
            raise ValueError(f"its archive has no member at byte {at}")
        _, _, _, _, _, _, crc, size, _, title, _ = _HEADER.unpack(head)
        found[file.read(title).decode("ascii")] = Member(at, size, crc)
        at += _HEADER.size + title + size
    if at != length or file.seek(0, io.SEEK_END) < length:
        raise ValueError(f"its archive ends before byte {max(at, length)}")
    return found


def listed(file: BinaryIO) -> Members:
    """The members by the directory of a sealed archive. Raises ValueError if it has none."""
    try:
        with zipfile.ZipFile(file) as archive:
            return {one.filename: Member(one.header_offset, one.file_size, one.CRC) for one in archive.infolist()}
    except (zipfile.BadZipFile, struct.error, NotImplementedError) as error:  # the last: zipfile's, of a version it cannot read
        raise ValueError(f"its archive has no directory ({error})") from error


def directory(members: Members, length: int) -> bytes:
    """The directory of members that end at `length`, to be written there."""
    lines = [_line(name, one) for name, one in members.items()]
    text, count = b"".join(lines), len(lines)
    end = _END.pack(b"PK\5\6", 0, 0, min(count, MANY), min(count, MANY), min(len(text), MOST), min(length, MOST), 0)
    if count < MANY and length < MOST:
        return text + end
    size = _END_64.size - 12  # without its first two fields
    far = _END_64.pack(b"PK\6\6", size, VERSION_64, VERSION_64, 0, 0, count, count, len(text), length)
    return text + far + _LOCATOR.pack(b"PK\6\7", 0, length + len(text), 1) + end


def _line(name: str, one: Member) -> bytes:
    """The entry of a member in the directory."""
    title, far = name.encode("ascii"), one.at >= MOST
    extra = _PLACE_64.pack(1, 8, one.at) if far else b""
    version, sizes = (VERSION_64 if far else VERSION), (one.size, one.size, len(title), len(extra))
    fixed = _LISTED.pack(b"PK\1\2", version, UNIX, version, 0, 0, 0, 0, DATE, one.crc, *sizes, 0, 0, 0, MODE, min(one.at, MOST))
    return fixed + title + extra
