"""Compiled kernels kept on disk go when any kernel file changes."""

from pathlib import Path

from kinetruss.kernels import _jit
from kinetruss.kernels._caches import STAMP, drop_stale


def test_what_was_compiled_goes_when_any_kernel_file_changes(tmp_path):
    kept = tmp_path / "__pycache__"
    kept.mkdir()
    (tmp_path / "_one.py").write_text("a = 1\n")
    (tmp_path / "_two.py").write_text("b = 1\n")
    assert drop_stale(tmp_path)
    compiled = [kept / "_one.f-1.py311.nbi", kept / "_one.f-1.py311.1.nbc"]
    for file in compiled:
        file.write_bytes(b"")
    assert not drop_stale(tmp_path)
    assert all(file.exists() for file in compiled)
    (tmp_path / "_two.py").write_text("b = 22\n")
    assert drop_stale(tmp_path)
    assert not any(file.exists() for file in compiled)
    assert not drop_stale(tmp_path)


def test_the_kernels_at_hand_are_stamped():
    assert (Path(_jit.__file__).parent / "__pycache__" / STAMP).is_file()
