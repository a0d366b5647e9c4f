"""Makes the oracles in tests/reference importable; no time limits inside property tests, on busy machines too."""

import sys
from pathlib import Path

from hypothesis import settings

sys.path.insert(0, str(Path(__file__).parent))

settings.register_profile("patient", deadline=None)
settings.load_profile("patient")
