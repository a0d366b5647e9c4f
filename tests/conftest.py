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

from hypothesis import settings

from kinetruss.kernels.compiled import jit

sys.path.insert(0, str(Path(__file__).parent))

if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

settings.register_profile("patient", deadline=None)
settings.register_profile("quick", settings.get_profile("patient"), max_examples=10)
settings.load_profile("patient")

jit.keeper.progress.stream = io.StringIO()
