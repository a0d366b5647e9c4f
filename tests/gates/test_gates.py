"""Every gate of the repository, seen red: a fault planted in a copy must be caught."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
BIN = Path(sys.executable).parent


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """The configuration and the package, without what was compiled."""
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    ignore = shutil.ignore_patterns("__pycache__", "*.csv", "*.json", "*.yaml")
    shutil.copytree(ROOT / "src", tmp_path / "src", ignore=ignore)
    return tmp_path


@pytest.fixture
def bare(tmp_path: Path) -> Path:
    """The configuration, and a package of that name with next to nothing in it."""
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    package = tmp_path / "src" / "kinetruss"
    package.mkdir(parents=True)
    (package / "__init__.py").write_text('"""Nothing."""\n')
    (package / "py.typed").touch()
    return tmp_path


def outcome(folder: Path, tool: str, *arguments: str) -> tuple[int, str]:
    environment = os.environ | {"PYTHONPATH": str(folder / "src"), "NO_COLOR": "1"}
    found = subprocess.run([BIN / tool, *arguments], cwd=folder, env=environment, capture_output=True, text=True, check=False)
    return found.returncode, found.stdout + found.stderr


@pytest.mark.parametrize(
    ("line", "rule"),
    [
        ("import os", "F401"),
        ('print("here")', "T201"),
        ("try:\n    x = 1\nexcept Exception:\n    x = 2", "BLE001"),
        ("assert 1 == 1", "S101"),
        ("# x = compute(1)", "ERA001"),
        ("def public():\n    return 1", "D103"),
    ],
)
def test_lint_catches(bare, line, rule):
    (bare / "src" / "kinetruss" / "bad.py").write_text(f'"""A module."""\n\n{line}\n')
    code, text = outcome(bare, "ruff", "check", "--no-cache", ".")
    assert code == 1
    assert rule in text


def test_format_catches_what_is_not_formatted(bare):
    (bare / "src" / "kinetruss" / "bad.py").write_text("x = {'a':1}\n")
    code, text = outcome(bare, "ruff", "format", "--no-cache", "--check", ".")
    assert code == 1
    assert "bad.py" in text


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("def double(x):\n    return 2 * x\n", "no-untyped-def"),
        ('def double(x: float) -> str:\n    return 2 * x\n\n\nY: int = "text"\n', "return-value"),
    ],
)
def test_types_catch(bare, text, complaint):
    (bare / "src" / "kinetruss" / "bad.py").write_text(text)
    code, said = outcome(bare, "mypy")
    assert code == 1
    assert complaint in said


def plant(copy: Path, module: str, line: str) -> None:
    path = copy / "src" / "kinetruss" / module
    path.write_text((path.read_text() if path.exists() else "") + f"\n{line}\n")


@pytest.mark.parametrize(
    ("module", "line", "contract"),
    [
        ("kernels/sweep/blocks.py", "def later():\n    from kinetruss.model import Model\n    return Model", "layers"),
        ("results/records.py", "import kinetruss.runs", "layers"),
        ("actuators/__init__.py", "import kinetruss.library", "layers"),
        ("utils.py", "X = 1", "layers"),
        ("model/the_model.py", "import numba", "numba"),
        ("runs/running.py", "import matplotlib", "drawing"),
        ("viewer/self_contained.py", "import matplotlib", "drawing"),
        ("viewer/self_contained.py", "import kinetruss.report", "layers"),
    ],
)
def test_import_contract_catches(copy, module, line, contract):
    plant(copy, module, line)
    code, said = outcome(copy, "lint-imports", "--no-cache", "--contract", contract)
    assert code == 1, said
    assert "broken" in said.lower() or "not listed" in said or "layers contract" in said


def test_import_contract_keeps_the_package_as_it_is(copy):
    code, said = outcome(copy, "lint-imports", "--no-cache")
    assert code == 0, said


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ('def half(x: float) -> float:\n    """Half.\n\n    >>> half(1)\n    0.4\n    """\n    return x / 2\n', "Expected"),
        ("import warnings\n\n\ndef test_it() -> None:\n    warnings.warn('old', DeprecationWarning)\n", "DeprecationWarning"),
        ("import pytest\n\n\n@pytest.mark.sloow\ndef test_it() -> None:\n    assert True\n", "sloow"),
    ],
)
def test_the_test_configuration_catches(bare, text, complaint):
    """Doctests in src are collected, a warning is an error, an unknown mark is refused."""
    name = "bad.py" if "half" in text else "test_bad.py"
    folder = bare / ("src/kinetruss" if name == "bad.py" else "tests")
    folder.mkdir(exist_ok=True)
    (bare / "tests").mkdir(exist_ok=True)
    (folder / name).write_text(text)
    code, said = outcome(bare, "pytest", "-p", "no:cacheprovider")
    assert code != 0
    assert complaint in said


def test_the_bundle_compared_with_its_sources_catches_another_one(tmp_path):
    """What `.ci/run` does with the page's program: built twice alike, and a changed source gives another."""
    node = shutil.which("node")
    modules = ROOT / "viewer-src" / "node_modules"
    if node is None or not modules.exists():
        assert not os.environ.get("CI"), "CI sets viewer-src up before the tests"
        # the page's sources need node, which `make test` does not ask for
        pytest.skip("needs the packages of viewer-src (make viewer installs them; CI does)")
    sources = tmp_path / "viewer-src"
    shutil.copytree(ROOT / "viewer-src", sources, ignore=shutil.ignore_patterns("node_modules"))
    (sources / "node_modules").symlink_to(modules)
    built = [tmp_path / name for name in ("one", "two")]
    subprocess.run([node, sources / "build.mjs", built[0]], check=True)
    committed = ROOT / "src" / "kinetruss" / "viewer"
    for name in ("bundle.js", "three.LICENSE.txt"):
        assert (built[0] / name).read_bytes() == (committed / name).read_bytes()
    with (sources / "src" / "colour.js").open("a") as file:
        file.write('\nexport const ANOTHER = "#123456";\nconsole.log(ANOTHER);\n')
    subprocess.run([node, sources / "build.mjs", built[1]], check=True)
    assert (built[1] / "bundle.js").read_bytes() != (committed / "bundle.js").read_bytes()
