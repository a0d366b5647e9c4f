"""The gradient of a displacement through tables is that of a complex step of the whole, and of differences of statics."""

import importlib.util
from pathlib import Path

PLACE = Path(__file__).parents[2] / "bench" / "gradients.py"


def test_gradients_are_exact():
    spec = importlib.util.spec_from_file_location("bench_gradients", PLACE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    found = module.measured()
    assert found["error_complex"] < 1e-12
    assert found["error_differences"] < 1e-7
    assert found["ratio"] > 0
