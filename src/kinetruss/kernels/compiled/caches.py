"""Compiled kernels kept on disk, and found again only in the state of the kernel files that they were compiled from.

Numba's own keeping asks whether the file of a kernel has changed, not those of the kernels compiled into it; it ends with an
error where no folder can be written, and where a file is damaged. So kernels are kept here, one file a kernel and signature:

    PLACE/kernels-PYTHON/MODULE.FUNCTION-LINE.STATE.KEY.kernel     a checksum, and what Numba makes of the compiled kernel

MODULE is the path of the kernel's file below the package, with '-' between its parts.
STATE is a hash of the kernel's file, of all kernel files that it imports, directly or not, and of the versions that compile;
KEY is one of signature and processor. A file takes its name when it is whole, so that several first starts at once do not
disturb each other. What is missing, unreadable or damaged is compiled anew. Places are read in this order, and written to
where it works first:

    NUMBA_CACHE_DIR                where that is set
    __pycache__                    beside the kernel files
    the user's folder of caches    where there is a home

Where none can be written, kernels live in memory only; a warning says so once.
"""

from __future__ import annotations

import errno
import hashlib
import logging
import os
import pickle
import re
import sys
import threading
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import llvmlite
import numba
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from kinetruss.errors import KernelCacheWarning
from kinetruss.kernels.compiled.progress import Progress

__all__ = ["Keeper", "Kept", "places_of", "states_of"]

log = logging.getLogger("kinetruss.kernels")
CHECK = 16
"""Bytes of a checksum."""
FOLDER = f"kernels-{sys.version_info[0]}{sys.version_info[1]}"
IMPORT = re.compile(r"^[ \t]*from kinetruss\.([.\w]*) import ([^(\n]+|\([^)]*\))", re.MULTILINE)
PACKAGES = ("kernels", "elements")
"""Folders whose files have kernels."""
JIT = "kernels-compiled-jit"
"""The module that says how all are compiled."""


def module_of(file: Path, folder: Path) -> str | None:
    """The name of a file below a folder: its parts with '-' between them; None for a file elsewhere."""
    return "-".join(file.relative_to(folder).with_suffix("").parts) if file.is_relative_to(folder) else None


def states_of(folder: Path) -> dict[str, str]:
    """Module -> hash of the contents of its file and of all that it imports of `PACKAGES`, and of what compiles them."""
    # this file keeps kernels and compiles none
    every = [file for package in PACKAGES for file in sorted((folder / package).rglob("*.py"))]
    files = [file for file in every if file.name != Path(__file__).name]
    texts = {str(module_of(file, folder)): file.read_bytes() for file in files}
    imports = {name: {*_imported(text.decode())} & texts.keys() for name, text in texts.items()}
    versions = f"{numba.__version__} {llvmlite.__version__}".encode()
    always = {JIT} & texts.keys()
    found = {}
    for name in texts:
        closure, new = set[str](), {name} | always
        while new:
            closure |= new
            new = {other for one in new for other in imports[one]} - closure
        parts = [hashlib.sha256(texts[one]).digest() + one.encode() for one in sorted(closure)]
        found[name] = hashlib.sha256(b" ".join([versions, *parts])).hexdigest()[:16]
    return found


def _imported(text: str) -> Iterator[str]:
    """Modules that a file may import: what stands behind `from`, and each name behind `import` as a module of it."""
    for package, names in IMPORT.findall(text):
        parts = package.strip(".").split(".") if package else []
        for name in ("", *re.findall(r"(\w+)(?: as \w+)?", names)):
            yield "-".join([*parts, *([name] if name else [])])


def places_of(folder: Path) -> list[Path]:
    """Folders where the compiled kernels of a package folder may be, each only for this one."""
    name = f"kinetruss-{hashlib.sha256(str(folder).encode()).hexdigest()[:8]}"
    own, user = os.environ.get("NUMBA_CACHE_DIR"), _user_caches()
    return [*([Path(own) / name] if own else []), folder / "__pycache__", *([user / name] if user else [])]


def _user_caches() -> Path | None:
    """The user's folder of caches; None for a user without a home."""
    if given := os.environ.get("XDG_CACHE_HOME"):
        return Path(given)
    try:
        home = Path.home()
    except RuntimeError:
        return None
    if not home.is_dir():
        return None
    if sys.platform == "win32":
        return home / "AppData" / "Local"
    return home / ("Library/Caches" if sys.platform == "darwin" else ".cache")


class Keeper:
    """Reads and writes compiled kernels.

    states : of modules, as `states_of` gives them. places : folders. folder : that of all kernels, by which modules are named.
    """

    def __init__(self, states: Mapping[str, str], places: Sequence[Path], folder: Path = Path()) -> None:
        self.states, self.folder = dict(states), folder
        self.places = tuple(places)
        self._writable = list(places)
        self._reasons: list[str] = []
        self._swept: set[Path] = set()
        self.progress = Progress()

    def kept(self) -> set[str]:
        """Kernels of which at least one form is kept, as MODULE.FUNCTION-LINE."""
        files = (file.name for place in self.places for file in (place / FOLDER).glob("*.kernel"))
        return {name.rsplit(".", 3)[0] for name in files if self._current(name)}

    def folders(self) -> list[Path]:
        """Where kernels are kept."""
        return [place / FOLDER for place in self.places if any((place / FOLDER).glob("*.kernel"))]

    def name(self, stem: str, key: str) -> str:
        """The name of a file. stem : MODULE.FUNCTION-LINE."""
        return f"{stem}.{self.states[stem.partition('.')[0]]}.{hashlib.sha256(key.encode()).hexdigest()[:16]}.kernel"

    def read(self, name: str) -> bytes | None:
        """What was kept under a name; None where nothing whole is."""
        for place in self.places:
            try:
                found = (place / FOLDER / name).read_bytes()
            except OSError:
                continue
            if found[:CHECK] == _checksum(found[CHECK:]):
                return found[CHECK:]
        return None

    def write(self, name: str, data: bytes) -> None:
        """Keep data under a name, in the first place that takes it."""
        while self._writable:
            if self._wrote(self._writable[0], name, _checksum(data) + data):
                return
            del self._writable[0]  # the others would not be kept either
        if self._reasons:
            warnings.warn(
                f"Compiled kernels cannot be kept on disk, so every start compiles them anew ({'; '.join(self._reasons)}). "
                "Set NUMBA_CACHE_DIR to a folder that can be written.",
                KernelCacheWarning,
                stacklevel=2,
            )
            self._reasons.clear()

    def _wrote(self, place: Path, name: str, data: bytes) -> bool:
        folder = place / FOLDER
        draft = folder / f"{name}.{os.getpid()}-{threading.get_ident()}.part"
        for again in (True, False):
            try:
                folder.mkdir(parents=True, exist_ok=True)
                draft.write_bytes(data)
                draft.replace(folder / name)
            except OSError as error:
                with suppress(OSError):
                    draft.unlink(missing_ok=True)
                if again and error.errno == errno.ENOENT:
                    continue  # somebody has just emptied the place
                self._reasons.append(f"{place}: {error.strerror or error}")
                return False
            break
        self._sweep(place)
        return True

    def _sweep(self, place: Path) -> None:
        """Remove what belongs to other states, and what Numba kept by itself, once a process."""
        if place in self._swept:
            return
        self._swept.add(place)
        old = [file for file in (place / FOLDER).glob("*.kernel") if not self._current(file.name)]
        for file in [*old, *place.glob("*.nbi"), *place.glob("*.nbc"), *place.glob("kernels.stamp")]:
            with suppress(OSError):
                file.unlink()

    def _current(self, name: str) -> bool:
        parts = name.split(".")
        return len(parts) > 4 and self.states.get(parts[0]) == parts[-3]


class Kept:
    """The compiled forms of one kernel, as Numba asks for them.

    form : tells what is compiled of one function apart. rebuilt : makes of a context and what was kept what was compiled. A
    function of a file whose state the keeper does not know, as in a test, is compiled and not kept.
    """

    def __init__(
        self, keeper: Keeper, function: Callable[..., Any], form: str = "kernel", rebuilt: Callable[..., Any] | None = None
    ) -> None:
        self.keeper, self._form, self._rebuilt = keeper, form, rebuilt or _rebuilt
        code = function.__code__
        module = module_of(Path(code.co_filename), keeper.folder)
        self._stem = f"{module}.{function.__qualname__}-{code.co_firstlineno}"
        self._known = module in keeper.states

    @property
    def cache_path(self) -> str:
        """The first place, for Numba's statistics."""
        return str(self.keeper.places[0])

    def load_overload(self, signature: Any, context: Any) -> Any:
        """The compiled form for a signature, or None."""
        context.refresh()
        found = self.keeper.read(self._name(signature, context.codegen())) if self._known else None
        if found is not None:
            return self._rebuilt(context, pickle.loads(found))
        self.keeper.progress.begin(self._form)  # Numba compiles it now, and saves it below
        return None

    def save_overload(self, signature: Any, compiled: Any) -> None:
        """Keep a form that was just compiled."""
        log.info("compiled %s", self._stem)
        self.keeper.progress.compiled(self._form)
        if not log.handlers:  # else somebody listens and tells
            self.keeper.progress.tell()
        # what holds an address of this process is of no use to another
        if self._known and not compiled.library.has_dynamic_globals:
            data: bytes = dumps(compiled._reduce())
            self.keeper.write(self._name(signature, compiled.codegen), data)

    def flush(self) -> None:
        """Nothing is written late."""

    def _name(self, signature: Any, codegen: Any) -> str:
        args = getattr(signature, "args", signature)  # of a kernel with a C address it is more than its arguments
        layouts = [getattr(getattr(one, "instance_class", None), "FIELDS", "") for one in args]
        return self.keeper.name(self._stem, f"{self._form} {signature} {codegen.magic_tuple()} {layouts}")


def _rebuilt(context: Any, data: tuple[Any, ...]) -> Any:
    return CompileResult._rebuild(context, *data)


def _checksum(data: bytes) -> bytes:
    return hashlib.blake2b(data, digest_size=CHECK).digest()
