"""Compiled kernels on disk: found again in their own state only, never trusted blindly, and never needed."""

import ast
import errno
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import numba
import pytest
from hypothesis import given, strategies as st

import kinetruss
from kinetruss.errors import KernelCacheWarning
from kinetruss.kernels.compiled import caches
from kinetruss.kernels.compiled.caches import Keeper, Kept, places_of, states_of
from permissions import bound

ADD = """
import json, sys, warnings
from pathlib import Path
import numba
from kinetruss.kernels.compiled.caches import Keeper, Kept
def add(a, b):
    return a + b
found = numba.njit(add)
found._cache = Kept(Keeper({"<string>": sys.argv[1]}, [Path(place) for place in sys.argv[2:]]), add)
with warnings.catch_warnings(record=True) as told:
    warnings.simplefilter("always")
    sums = [found(1, 2), found(1.5, 2.0), found(1j, 1)]
told = [f"{one.category.__name__}: {one.message}" for one in told]
print(json.dumps({"right": sums == [3, 3.5, 1 + 1j], "hits": sum(found.stats.cache_hits.values()), "told": told}))
"""
FORMS = 3
"""Signatures that the small program compiles."""


def besides_compiling(error):
    """What a process says besides that it compiles, which it does where the machine is busy."""
    return "".join(line for line in error.splitlines(True) if not line.startswith("kinetruss: compil"))


SERVER = """
import json, os, sys, traceback
import numba
numba.njit(lambda a: a)(1)
code = json.loads(sys.stdin.readline())
for line in sys.stdin:
    sys.argv[1:] = json.loads(line)
    if (child := os.fork()) == 0:
        try:
            exec(code, {"__name__": "__main__"})
        except BaseException:
            print(json.dumps(traceback.format_exc()))
        sys.stdout.flush()
        os._exit(0)
    os.waitpid(child, 0)
"""


@pytest.fixture(scope="module")
def start() -> Iterator[Callable[..., dict[str, object]]]:
    """What a process that compiles three forms of one kernel says: a copy of one with Numba, or one that `before` starts."""
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    with subprocess.Popen([sys.executable, "-c", SERVER], **pipes) as server:
        server.stdin.write(json.dumps(ADD) + "\n")

        def answer(*places: Path, state: str = "s" * 16, before: tuple[str, ...] = ()) -> dict[str, object]:
            if before:
                command = [*before, sys.executable, "-c", ADD, state, *map(str, places)]
                done = subprocess.run(command, capture_output=True, text=True, check=False)
                assert (done.returncode, besides_compiling(done.stderr)) == (0, "")
                return json.loads(done.stdout)
            server.stdin.write(json.dumps([state, *map(str, places)]) + "\n")
            server.stdin.flush()
            return json.loads(server.stdout.readline())

        yield answer


GOOD = {"right": True, "hits": FORMS, "told": []}
ANEW = GOOD | {"hits": 0}


@pytest.fixture(scope="module")
def filled(tmp_path_factory, start) -> Path:
    place = tmp_path_factory.mktemp("filled")
    assert start(place) == ANEW
    assert start(place) == GOOD
    return place


def files(place: Path) -> list[Path]:
    return sorted(place.glob("kernels-*/*.kernel"))


# -- what is kept and found --------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_a_file_is_whole_or_not_there(filled):
    assert len(files(filled)) == FORMS
    assert all(file.suffix == ".kernel" for file in files(filled))


def broken(file: Path, how: str) -> None:
    data = file.read_bytes()
    match how:
        case "empty":
            file.write_bytes(b"")
        case "short":
            file.write_bytes(data[: len(data) // 2])
        case "noise":
            file.write_bytes(os.urandom(len(data)))
        case "one bit":
            file.write_bytes(data[:-100] + bytes([data[-100] ^ 1]) + data[-99:])
        case "another's":
            file.write_bytes(b"\0" * 16 + data[16:])
        case "unreadable":
            file.chmod(0)
        case "a folder":
            file.unlink()
            file.mkdir()
        case "gone":
            file.unlink()


@pytest.mark.slow
@pytest.mark.parametrize("hows", [("empty", "short", "noise"), ("one bit", "another's", "gone"), ("unreadable",)], ids=str)
def test_what_is_damaged_is_compiled_anew_and_replaced(filled, tmp_path, hows, start):
    place = tmp_path / "place"
    shutil.copytree(filled, place)
    for file, how in zip(files(place), hows, strict=False):
        broken(file, how)
    before = tuple(bound()) if "unreadable" in hows else ()
    assert start(place, before=before) == GOOD | {"hits": FORMS - len(hows)}
    assert start(place, before=before) == GOOD


@pytest.mark.slow
def test_a_name_that_cannot_be_replaced_is_told_once_and_costs_nothing_else(filled, tmp_path, start):
    place = tmp_path / "place"
    shutil.copytree(filled, place)
    broken(files(place)[1], "a folder")
    found = start(place)
    assert (found["right"], found["hits"], len(found["told"])) == (True, FORMS - 1, 1)


@given(data=st.binary(max_size=200))
def test_no_bytes_but_those_written_are_ever_read(tmp_path_factory, data):
    keeper = Keeper({}, [tmp_path_factory.mktemp("place")])
    folder = keeper.places[0] / caches.FOLDER
    folder.mkdir()
    (folder / "name").write_bytes(data)
    assert keeper.read("name") is None
    keeper.write("name", data)
    assert keeper.read("name") == data


def test_the_state_is_that_of_the_contents_of_a_file_and_of_all_that_it_imports(tmp_path):
    def write(files: dict[str, str]) -> None:
        for name, text in files.items():
            file = tmp_path / (name.replace("-", "/") + ".py")
            file.parent.mkdir(exist_ok=True, parents=True)
            file.write_text(text)

    def changed(name: str, text: str) -> set[str]:
        before = states_of(tmp_path)
        write({name: text})
        after = states_of(tmp_path)
        return {name for name in after if after[name] != before.get(name)}

    late = "def f():\n    from kinetruss.kernels.b import (\n        four as another,\n        two,\n    )\n"
    write(
        {
            "kernels-compiled-jit": "",
            "kernels-a-one": "a = 1\n",
            "kernels-b-two": "from kinetruss.kernels.a.one import a\n",
            "kernels-b-four": "b = 4\n",
            "kernels-c": late,
        }
    )
    assert changed("kernels-a-one", "a = 2\n") == {"kernels-a-one", "kernels-b-two", "kernels-c"}
    assert changed("kernels-b-four", "b = 5\n") == {"kernels-b-four", "kernels-c"}
    assert changed("kernels-c", "from kinetruss.kernels.compiled.jit import kernel\n") == {"kernels-c"}
    circle = "from kinetruss.kernels.b.two import f\n"
    assert changed("kernels-a-one", circle) == {"kernels-a-one", "kernels-b-two"}
    assert changed("kernels-compiled-jit", "# how all are compiled\n") == set(states_of(tmp_path))
    assert changed("elements-d-one", "") == {"elements-d-one"}
    before = states_of(tmp_path)
    os.utime(tmp_path / "kernels" / "a" / "one.py", (1, 1))  # unpacked again, or checked out again
    assert states_of(tmp_path) == before


@pytest.mark.slow
def test_imports_are_those_that_python_sees():
    """What compiles into a kernel comes by imports of these two forms, or from outside the folder."""
    folder = Path(caches.__file__).parents[2]
    files = [file for package in caches.PACKAGES for file in (folder / package).rglob("*.py")]
    modules = {caches.module_of(file, folder) for file in files}
    # what elements take from elsewhere are types, and names that no kernel has
    others = {"kernels": {"errors"}, "elements": {"errors", "model", "mechanics"}}
    for file in files:
        text, wanted = file.read_text("utf-8"), set()
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.ImportFrom) and str(node.module).startswith("kinetruss."):
                package, *parts = str(node.module).split(".")[1:]
                own = file.relative_to(folder).parts[0]
                assert package in {*caches.PACKAGES, *others[own]}, f"{file.name}: {node.module}"
                if package in caches.PACKAGES:
                    wanted |= {"-".join([package, *parts]), *("-".join([package, *parts, one.name]) for one in node.names)}
            elif isinstance(node, ast.Import):
                assert not any(one.name.startswith("kinetruss") for one in node.names), file.name
            assert not (isinstance(node, ast.ImportFrom) and node.level), file.name
        assert set(caches._imported(text)) & modules == wanted & modules, file.name


@pytest.mark.slow
def test_another_state_finds_nothing_and_sweeps_what_nobody_needs(filled, tmp_path, start):
    place = tmp_path / "place"
    shutil.copytree(filled, place)
    old = files(place)
    (place / "_lu.solve-1.py311.nbi").write_bytes(b"of Numba's own keeping")
    (place / "_lu.cpython-311.pyc").write_bytes(b"Python's")
    (place / "kernels-299").mkdir()  # of another Python
    (place / "kernels-299" / "f.kernel").touch()
    assert start(place, state="t" * 16) == ANEW
    assert sorted(item.name for item in place.iterdir()) == sorted(["_lu.cpython-311.pyc", "kernels-299", caches.FOLDER])
    assert len(files(place)) == FORMS + 1
    assert not any(file.exists() for file in old)
    assert start(place) == ANEW


def test_a_folder_swept_by_another_state_meanwhile_is_made_again(tmp_path, monkeypatch):
    keeper, real, swept = Keeper({}, [tmp_path]), Path.write_bytes, []

    def write(self, data):
        if not swept:
            swept.append(True)
            shutil.rmtree(self.parent)
        return real(self, data)

    monkeypatch.setattr(Path, "write_bytes", write)
    keeper.write("name", b"data")
    assert keeper.read("name") == b"data"


@pytest.mark.slow
def test_many_first_starts_at_once_disturb_nobody(tmp_path, start):
    command = [sys.executable, "-c", ADD, "s" * 16, str(tmp_path)]
    running = [subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for _ in range(4)]
    for one in running:
        out, error = one.communicate()
        assert (one.returncode, besides_compiling(error)) == (0, "")
        assert json.loads(out)["right"]
    assert start(tmp_path) == GOOD
    assert len(files(tmp_path)) == FORMS


# -- places that cannot be written ------------------------------------------------------------------------------------


@pytest.mark.slow
def test_kernels_of_a_folder_that_may_not_be_written_are_used(filled, tmp_path, start):
    place = tmp_path / "place"
    shutil.copytree(filled, place)
    for item in [*place.rglob("*"), place]:
        item.chmod(0o555 if item.is_dir() else 0o444)
    assert start(place, before=tuple(bound())) == GOOD


@pytest.mark.slow
def test_what_is_missing_there_goes_to_the_next_place(filled, tmp_path, start):
    image, own = tmp_path / "image", tmp_path / "own"
    shutil.copytree(filled, image)
    broken(files(image)[0], "gone")
    for item in [*image.rglob("*"), image]:
        item.chmod(0o555 if item.is_dir() else 0o444)
    before = tuple(bound())
    assert start(image, own, before=before) == GOOD | {"hits": FORMS - 1}
    assert len(files(own)) == 1
    assert Keeper({}, [image, own, tmp_path / "unused"]).folders() == [place / caches.FOLDER for place in (image, own)]
    assert start(image, own, before=before) == GOOD


@pytest.mark.slow
def test_without_any_place_kernels_live_in_memory_and_that_is_said_once(tmp_path, start):
    place = tmp_path / "place"
    place.mkdir(mode=0o555)
    (tmp_path / "file").touch()
    found = start(place, tmp_path / "file" / "below", before=tuple(bound()))
    assert (found["right"], found["hits"], len(found["told"])) == (True, 0, 1)
    (told,) = found["told"]
    assert told.startswith("KernelCacheWarning: Compiled kernels cannot be kept on disk")
    assert f"{place}: Permission denied" in told
    assert "Set NUMBA_CACHE_DIR" in told


@pytest.mark.parametrize("number", [errno.ENOSPC, errno.EDQUOT, errno.EROFS, errno.EIO])
def test_a_full_disk_leaves_nothing_half_and_the_next_place_is_taken(tmp_path, monkeypatch, number):
    full, other = tmp_path / "full", tmp_path / "other"
    real = Path.write_bytes

    def write(self, data):
        if full in self.parents:
            real(self, data[: len(data) // 2])
            raise OSError(number, os.strerror(number))
        return real(self, data)

    monkeypatch.setattr(Path, "write_bytes", write)
    keeper = Keeper({}, [full, other])
    keeper.write("one", b"1")
    keeper.write("two", b"2")
    assert list(full.glob("*/*")) == []
    assert (keeper.read("one"), keeper.read("two")) == (b"1", b"2")
    alone = Keeper({}, [full])
    with pytest.warns(KernelCacheWarning, match="cannot be kept"):
        alone.write("one", b"1")
    alone.write("two", b"2")  # said once: warnings are errors in these tests
    assert list(full.glob("*/*")) == []


def test_places_are_those_of_user_and_package(tmp_path, monkeypatch):
    folder = Path(caches.__file__).parent
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "own"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "user"))
    own, package, user = places_of(folder)
    assert (own.parent, package, user.parent) == (tmp_path / "own", folder / "__pycache__", tmp_path / "user")
    assert own.name == user.name
    assert places_of(tmp_path)[0].name != own.name  # another installation
    monkeypatch.delenv("NUMBA_CACHE_DIR")
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path / "nowhere"))
    assert places_of(folder) == [package]
    assert not (tmp_path / "nowhere").exists()


# -- the package as it is ---------------------------------------------------------------------------------------------

USE = """
import sys, warnings
import numpy as np
from kinetruss.kernels.structure.lengths import lengths
from kinetruss.kernels.structure.sums import sum_first
print(lengths.entry, sys.modules["kinetruss"].__file__)
x = np.zeros((1, 6)); x[0, 3:] = (3.0, 4.0, 12.0)
out = [np.zeros((1, 1)) for _ in range(3)]
lengths(np.array([0]), np.array([1]), x, 0 * x, 0 * x, *out)
print(out[0][0, 0], sum(lengths.entry.stats.cache_hits.values()))
"""


@pytest.mark.slow
def test_a_package_that_may_not_be_written_without_a_home_works_and_says_so(tmp_path):
    """As in a container whose image was built by another user."""
    source = Path(kinetruss.__file__).parent
    package = tmp_path / "kinetruss"
    shutil.copytree(source, package, ignore=shutil.ignore_patterns("__pycache__", "bundle.js", "examples"))
    environment = {key: value for key, value in os.environ.items() if key not in ("NUMBA_CACHE_DIR", "XDG_CACHE_HOME")}
    environment |= {"PYTHONPATH": str(tmp_path), "HOME": str(tmp_path / "nowhere"), "PYTHONDONTWRITEBYTECODE": "1"}

    def use(*before: str) -> tuple[list[str], str]:
        done = subprocess.run(
            [*before, sys.executable, "-c", USE], env=environment, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        assert str(package) in done.stdout
        return done.stdout.splitlines()[1].split(), besides_compiling(done.stderr)

    kernels = package / "kernels"
    kernels.chmod(0o555)
    answer, told = use(*bound())
    assert answer == ["13.0", "0"]
    assert told.count("KernelCacheWarning") == 1
    kernels.chmod(0o755)
    assert use() == (["13.0", "0"], "")  # built by one who may write
    for item in [*kernels.rglob("*"), kernels]:
        item.chmod(0o555 if item.is_dir() else 0o444)
    assert use(*bound()) == (["13.0", "1"], "")  # used by one who may not


@pytest.mark.slow
def test_kernels_that_hold_an_address_of_this_process_are_not_kept(tmp_path):
    import ctypes

    pointer = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)(abs)

    def call(x):
        return pointer(x)

    found = numba.njit(call)
    found._cache = Kept(Keeper({Path(__file__).stem: "s"}, [tmp_path]), call)
    assert found(-2.0) == 2.0
    assert files(tmp_path) == []
