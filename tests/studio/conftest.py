"""A studio that all tests of one worker share."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from samples import tripod
from served import Served, serve


@pytest.fixture(scope="session")
def studio(tmp_path_factory) -> Iterator[Served]:
    """A tripod with a payload, live."""
    served = serve(tripod(), tmp_path_factory.mktemp("studio"))
    yield served
    served.process.kill()
    served.process.communicate()
