"""How the command begins: Ctrl-C at any import, the compiling of kernels ahead."""

import json
import logging
import signal
import subprocess
import sys
import tomllib
import warnings
from itertools import chain, pairwise
from pathlib import Path

import pytest
from click.testing import CliRunner

import kinetruss as kt
from kinetruss import runs
from kinetruss.cli import common as _progress, compiling as _compile, main
from kinetruss.kernels.compiled import caches, jit
from kinetruss.kernels.compiled.progress import Progress

ROOT = Path(__file__).parents[2]
FOURBAR = kt.library.example_files()["four_bar"][0]
AT_IMPORT = """
import os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
from kinetruss.cli.start import start
class Stop:
    def find_spec(self, name, path=None, target=None):
        if name == wanted:
            os.kill(os.getpid(), signal.SIGINT)
wanted = sys.argv.pop(1)
sys.meta_path.insert(0, Stop())
start()
"""


def test_the_command_begins_where_ctrl_c_is_told():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    assert project["project"]["scripts"] == {"kinetruss": "kinetruss.cli.start:start"}


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="Windows cannot send these signals to a process")
@pytest.mark.parametrize(
    ("module", "words"),
    [
        ("click", "Interrupted."),
        ("kinetruss.cli.running", "Interrupted."),
        ("kinetruss.report", "Interrupted"),
        ("numpy", "Interrupted"),
        ("numpy.exceptions", "Interrupted"),  # within a library, which cannot be loaded twice
        ("numba", "Interrupted before the first samples were written."),
        ("kinetruss.dynamics.prescribed", "Interrupted before the first samples were written."),
    ],
)
def test_ctrl_c_during_imports_ends_in_one_line(tmp_path, module, words):
    command = [sys.executable, "-c", AT_IMPORT, module, "run", str(FOURBAR), "-o", str(tmp_path / "run"), "--pictures"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (130, "")
    assert words in done.stderr
    assert len([line for line in done.stderr.splitlines() if "compil" not in line]) == 1
    assert (tmp_path / "run").exists() == (module == "kinetruss.report")  # what is read or drawn comes after the run


def test_ctrl_c_with_json_is_one_object(monkeypatch):
    def stop(_look, drawn):
        raise KeyboardInterrupt

    monkeypatch.setattr(_compile, "_run_all", stop)
    done = CliRunner().invoke(main, ["compile", "--json"])
    assert (done.exit_code, json.loads(done.stdout)["error"]) == (130, "Interrupted.")


def compiling(count: int, error: Warning | None = None):
    def work(_look: object, *, drawn: bool) -> None:
        for k in range(count):
            logging.getLogger("kinetruss.kernels").info("compiled %s", f"_new.f{k}-1")
        if error is not None:
            warnings.warn(error, stacklevel=2)

    return work


@pytest.mark.slow
def test_compiling_says_how_far_it_is(monkeypatch):
    monkeypatch.setattr(_compile, "_run_all", compiling(45))
    done = CliRunner().invoke(main, ["compile"])
    assert done.exit_code == 0, done.output
    counts = [int(line.split()[3]) for line in done.stderr.splitlines()]
    assert counts
    assert all(later - sooner == _compile.STEP for sooner, later in pairwise(counts))
    assert all(line.endswith("so far") for line in done.stderr.splitlines())  # how many there will be is not known
    assert "45 kernels compiled" in done.stdout
    assert json.loads(CliRunner().invoke(main, ["compile", "--json"]).stdout)["compiled"] == 45
    assert CliRunner().invoke(main, ["compile", "-q"]).output == ""


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ([], ["compiling (first start only) ...", "compiled 10 kernels in 50 s."]),
        (["--json"], ["compiling (first start only) ...", "compiled 10 kernels in 50 s."]),
        (["-q"], []),
    ],
)
def test_a_run_off_a_terminal_says_that_it_compiles_and_when_that_is_done(monkeypatch, tmp_path, more, said):
    clock = [0.0]
    monkeypatch.setattr(jit.keeper, "progress", Progress(clock=lambda: clock[0]))
    run = runs.run

    def cold(*given, **chosen):
        for _ in range(10):  # as Numba asks for what is kept, and saves it
            jit.keeper.progress.begin()
            clock[0] += 5.0
            jit.keeper.progress.compiled()
            if not caches.log.handlers:
                jit.keeper.progress.tell()
        return run(*given, **chosen)

    monkeypatch.setattr(runs, "run", cold)
    done = CliRunner().invoke(main, ["run", str(FOURBAR), "-o", str(tmp_path / "run"), *more])
    assert done.exit_code == 0, done.output
    assert done.stderr.splitlines() == [f"kinetruss: {words}" for words in said]
    if "--json" in more:
        assert json.loads(done.stdout)["status"] == "COMPLETED"


def test_a_long_computation_off_a_terminal_is_not_silent_and_its_count_ends_at_its_total(monkeypatch, capsys):
    clock = [0.0]
    monkeypatch.setattr(_progress.time, "monotonic", lambda: clock[0])
    with _progress.bar(False) as shown:
        for done in range(0, 101, 20):
            shown(done, 100)
            clock[0] += 10.0
    lines = capsys.readouterr().err.splitlines()
    assert lines[0] == "kinetruss: 40 of 100 samples, 20 s"
    assert lines[-1] == "kinetruss: 100 of 100 samples, 50 s"
    with _progress.bar(False) as shown:
        shown(100, 100)
    assert capsys.readouterr().err == ""
    with _progress.bar(False, "bodies", first=" of arm.xml"):
        assert capsys.readouterr().err == "kinetruss: bodies of arm.xml ...\n"


def test_kernels_that_cannot_be_kept_end_with_1(monkeypatch):
    told = kt.errors.KernelCacheWarning("Compiled kernels cannot be kept on disk")
    monkeypatch.setattr(_compile, "_run_all", compiling(1, told))
    done = CliRunner().invoke(main, ["compile"])
    assert (done.exit_code, "cannot be kept on disk" in done.stderr) == (1, True)


@pytest.mark.filterwarnings("default")
def test_a_warning_is_one_line(monkeypatch):
    def work(_look: object, *, drawn: bool) -> None:
        warnings.warn("It is so.", UserWarning, stacklevel=2)

    monkeypatch.setattr(_compile, "_run_all", work)
    done = CliRunner().invoke(main, ["compile", "--json"])
    assert done.stderr == "Warning: It is so.\n"


def test_rare_kernels_are_compiled_where_all_are_asked_for(monkeypatch):
    from kinetruss.kernels.compiled.calls import Interface

    monkeypatch.setattr(_compile, "_run_all", compiling(1))
    asked = []
    monkeypatch.setattr(Interface, "address", lambda _, kernel: asked.append(kernel.py_func.__name__) or 0)
    kinds = []
    monkeypatch.setattr("kinetruss.elements.kinds.compile_kinds", lambda: kinds.append(1))
    assert CliRunner().invoke(main, ["compile", "-q"]).exit_code == 0
    assert not asked
    assert not kinds
    assert CliRunner().invoke(main, ["compile", "-q", "--all"]).exit_code == 0
    assert {"sum_torques", "sparse_factor", "sum_gaps"} <= {*asked}
    assert kinds


def test_the_runs_that_are_compiled_for_are_there():
    for example, name in chain.from_iterable(_compile.RUNS):
        assert name in kt.read(kt.library.example_files()[example][0]).runs


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="Windows cannot send these signals to a process")
def test_in_the_background_tests_hear_ctrl_c_all_the_same():
    code = "import signal, conftest; raise SystemExit(signal.getsignal(signal.SIGINT) is signal.SIG_IGN)"

    def ignore() -> None:
        signal.signal(signal.SIGINT, signal.SIG_IGN)

    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT / "tests", preexec_fn=ignore, check=False)
    assert done.returncode == 0


def test_no_line_of_the_help_is_cut():
    """A line that ends in dots after its noun says less than a shorter one."""
    from click.testing import CliRunner

    from kinetruss.cli import main

    text = CliRunner().invoke(main, ["-h"], terminal_width=80).output
    assert "..." not in text.partition("Commands:")[2]
