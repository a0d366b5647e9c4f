"""Every gate of the repository, seen red: a fault planted in a small package must be caught."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
BIN = Path(sys.executable).parent


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


def test_lint_catches(bare):
    faults = {
        "F401": "import os",
        "T201": 'print("here")',
        "BLE001": "try:\n    x = 1\nexcept Exception:\n    x = 2",
        "S101": "assert 1 == 1",
        "ERA001": "# x = compute(1)",
        "D103": "def public():\n    return 1",
    }
    for rule, lines in faults.items():
        (bare / "src" / "kinetruss" / f"bad_{rule.lower()}.py").write_text(f'"""A module."""\n\n{lines}\n')
    code, text = outcome(bare, "ruff", "check", "--no-cache", "--output-format", "concise", ".")
    assert code == 1
    for rule in faults:
        assert re.search(rf"bad_{rule.lower()}\.py.*{rule}", text), rule


def test_format_catches_what_is_not_formatted(bare):
    (bare / "src" / "kinetruss" / "bad.py").write_text("x = {'a':1}\n")
    code, text = outcome(bare, "ruff", "format", "--no-cache", "--check", ".")
    assert code == 1
    assert "bad.py" in text


def test_types_catch(bare):
    (bare / "src" / "kinetruss" / "untyped.py").write_text("def double(x):\n    return 2 * x\n")
    (bare / "src" / "kinetruss" / "wrong.py").write_text("def double(x: float) -> str:\n    return 2 * x\n")
    code, said = outcome(bare, "mypy")
    assert code == 1
    assert re.search(r"untyped\.py.*no-untyped-def", said)
    assert re.search(r"wrong\.py.*return-value", said)


def test_import_contract_catches(bare):
    """Of a package with the names of the real one, as the contract lists them, and a fault against each contract."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
    layers, numba, drawing = contracts
    package = bare / "src" / "kinetruss"
    named = {name for one in contracts for name in (*one.get("layers", ()), *one.get("source_modules", ()))}
    for name in {part.strip(" ()") for one in named for part in one.replace("|", ":").split(":")}:
        folder = package / name.removeprefix("kinetruss.").replace(".", "/")
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "__init__.py").touch()
    (package / "kernels" / "late.py").write_text("def later():\n    from kinetruss.model import sums\n    return sums\n")
    (package / "model" / "sums.py").write_text("import numba\n")
    (package / "runs" / "picture.py").write_text("import matplotlib\n")
    (package / "__init__.py").write_text("from kinetruss.runs import picture\n")  # the face may name what it likes
    code, said = outcome(bare, "lint-imports", "--no-cache")
    assert code == 1, said
    for one, found in ((layers, "kinetruss.kernels.late -> kinetruss.model.sums"), (numba, "kinetruss.model.sums -> numba"),
                       (drawing, "kinetruss.runs.picture -> matplotlib")):  # fmt: skip
        assert f"{one['name']} BROKEN" in said, said
        assert found in said, said
    assert "kinetruss -> " not in said, said
    (package / "utils.py").write_text("X = 1\n")
    code, said = outcome(bare, "lint-imports", "--no-cache", "--contract", layers["id"])
    assert code == 1, said
    assert "utils" in said, said


BAD = {
    "src/kinetruss/bad.py": 'def half(x: float) -> float:\n    """Half.\n\n    >>> half(1)\n    4\n    """\n    return x / 2\n',
    "tests/test_old.py": "import warnings\n\n\ndef test_it() -> None:\n    warnings.warn('old', DeprecationWarning)\n",
    "tests/test_marked.py": "import pytest\n\n\n@pytest.mark.sloow\ndef test_it() -> None:\n    assert True\n",
}


def test_the_test_configuration_catches(bare):
    """Doctests in src are collected, a warning is an error, an unknown mark is refused."""
    (bare / "tests").mkdir()
    for name, text in BAD.items():
        (bare / name).write_text(text)
    code, said = outcome(bare, "pytest", "-p", "no:cacheprovider", "--continue-on-collection-errors")
    assert code != 0
    for told in ("FAILED src/kinetruss/bad.py::", "FAILED tests/test_old.py::test_it - DeprecationWarning", "sloow"):
        assert told in said, said


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
