"""Run with the Python of an environment that holds only the wheel: what it needs at run time is in it."""

import subprocess
import sys
import tempfile
from pathlib import Path

import kinetruss
from kinetruss.library import example_files

package = Path(kinetruss.__file__).parent
program = Path(sys.executable).parent / "kinetruss"
assert "site-packages" in package.parts, package
for needed in (
    "py.typed",
    "io/*.json",
    "verification/*/cases.yaml",
    "library/examples/*.yaml",
    "library/examples/*.csv",
    "report/document/style.css",
    "viewer/bundle.js",
    "viewer/*LICENSE*",
):
    assert list(package.glob(needed)), f"the wheel lacks {needed}"
assert not list(package.glob("**/test*")), "the wheel holds tests"
for name, files in example_files().items():
    subprocess.run([program, "check", files[0]], check=True, stdout=subprocess.DEVNULL)
    print("checked", name)
with tempfile.TemporaryDirectory() as folder:
    out = Path(folder) / "run"
    command = [program, "run", example_files()["four_bar"][0], "-o", out, "--pictures"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    assert list((out / "pictures").glob("*.png"))
    subprocess.run([program, "view", out, "-o", out / "view.html", "--no-open"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([program, "report", out, "--no-open", "--no-pdf"], check=True, stdout=subprocess.DEVNULL)
    assert (out / "report" / "report.html").is_file()
print("the wheel is whole")
