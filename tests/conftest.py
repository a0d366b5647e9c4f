"""Makes the oracles in tests/reference importable; no time limits inside property tests, on busy machines too. The profile
`quick` tries fewer examples (tests/quick.py).

A shell starts what runs in the background with Ctrl-C ignored, and children would inherit that: tests that interrupt a child
need it as it is on a terminal.

What is said of kernels while they are compiled goes nowhere: which test is the first to need one depends on the order of tests.
"""

import io
import signal
import sys
from pathlib import Path

import pytest
from hypothesis import settings

import kinetruss as kt
from kinetruss.kernels.compiled import jit

sys.path.insert(0, str(Path(__file__).parent))

from samples import fourbar, tripod

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

settings.register_profile("patient", deadline=None)
settings.register_profile("quick", settings.get_profile("patient"), max_examples=10)
settings.load_profile("patient")

jit.keeper.progress.stream = io.StringIO()


@pytest.fixture
def undrawn(monkeypatch):
    """Pages have empty pictures: for tests of words and numbers, of which drawing takes the most time."""
    from kinetruss.display import element
    from kinetruss.report.document import figure, run_pictures, run_report
    from kinetruss.report.entries import Figure

    monkeypatch.setattr(run_report, "picture", lambda spec, number, caption: Figure(panels=[element("svg")], caption=caption))
    for module in (figure, run_pictures):
        monkeypatch.setattr(module, "drawn", lambda *_, **__: None)
        monkeypatch.setattr(module, "lines_of", lambda _, __, words: element("svg", role="img", aria_label=words))


@pytest.fixture(scope="session")
def turn():
    """The run of a planar four-bar linkage."""
    return kt.run(fourbar(), "turn")


@pytest.fixture(scope="session")
def lift():
    """A run in space with active members and two load cases."""
    return kt.run(tripod(), "lift")
