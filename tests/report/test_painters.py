"""Pictures drawn by processes beside the computation are the same pictures."""

import pytest

from kinetruss import report
from kinetruss.errors import StoreError
from kinetruss.report.pictures import painters as _painters
from kinetruss.report.pictures.painters import painters
from kinetruss.runs import RunResult, run
from samples import fourbar


@pytest.fixture(scope="module")
def fourbar_run() -> RunResult:
    return run(fourbar())


def test_painters_draw_what_figures_draws(fourbar_run, tmp_path, monkeypatch):
    monkeypatch.setattr(_painters.os, "cpu_count", lambda: 2)
    with painters() as found:
        assert found is not None
        written = found.figures(fourbar_run, tmp_path / "beside", ["svg"])
    here = report.figures(fourbar_run, tmp_path / "here", ["svg"])
    assert [path.name for path in written] == [path.name for path in here]
    assert [path.read_bytes() for path in written] == [path.read_bytes() for path in here]


def test_a_painter_that_dies_is_replaced(fourbar_run, tmp_path, monkeypatch):
    monkeypatch.setattr(_painters.os, "cpu_count", lambda: 2)
    monkeypatch.setattr(_painters.sys, "executable", "/bin/false")
    with painters() as found:
        written = found.figures(fourbar_run, tmp_path, ["svg"])
    assert all(path.exists() for path in written)
    assert len(written) >= 4


def test_what_painters_cannot_write_is_said(fourbar_run, tmp_path, monkeypatch):
    monkeypatch.setattr(_painters.os, "cpu_count", lambda: 2)
    (tmp_path / "file").write_text("")
    with painters() as found, pytest.raises(StoreError, match="cannot be written"):
        found.figures(fourbar_run, tmp_path / "file" / "pictures")


def test_one_processor_has_no_painters(monkeypatch):
    monkeypatch.setattr(_painters.os, "cpu_count", lambda: 1)
    with painters() as found:
        assert found is None
