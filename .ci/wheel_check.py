"""Run with the Python of an environment that holds only the wheel: what it needs at run time is in it.

PYTHON wheel_check.py [core] [missing] [extras]

core: the work of a first hour, with the dependencies of the wheel alone. missing: what needs an extra says which one.
extras: what the extras add.
"""

import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import kinetruss
from kinetruss.library import example_files

PACKAGE = Path(kinetruss.__file__).parent
PROGRAM = Path(sys.executable).parent / "kinetruss"
NEEDED = (
    "py.typed",
    "io/*.json",
    "verification/data/*.yaml",
    "library/examples/*.yaml",
    "library/examples/*.csv",
    "report/style.css",
    "report/document/report.html.j2",
    "viewer/bundle.js",
    "viewer/*LICENSE*",
)
EXTRAS = {
    "studio": ("studio", "--no-open"),
    "render": ("render", "leg.yaml", "-o", "leg.mp4"),
    "exchange": ("export", "leg.yaml", "leg.dxf"),
    "export": ("export", "run", "leg.parquet"),
}


def do(*arguments: str | Path, code: int = 0) -> str:
    """What a command prints (what it says on stderr too, where it must fail); it must end with this exit code."""
    started = time.perf_counter()
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)
    said = done.stdout + done.stderr
    assert done.returncode == code, f"kinetruss {' '.join(map(str, arguments))}: exit code {done.returncode}\n{said}"
    assert "Warning" not in said, said
    print(f"  {time.perf_counter() - started:5.1f} s  kinetruss {' '.join(map(str, arguments))}", flush=True)
    return said if code else done.stdout  # that kernels are compiled is said on stderr


def core() -> None:
    """A model is made, checked, run, reported, looked at, carried to other formats and back."""
    assert "site-packages" in PACKAGE.parts, PACKAGE
    for needed in NEEDED:
        assert list(PACKAGE.glob(needed)), f"the wheel lacks {needed}"
    assert not list(PACKAGE.glob("**/test*")), "the wheel holds tests"
    assert "kinetruss new" in do()
    do("new", "leg", "--like", "four_bar")
    do("check", "leg.yaml")
    do("run", "leg.yaml", "-o", "run", "--pictures")
    assert list(Path("run/pictures").glob("*.png"))
    assert "drive" in do("info", "run")
    do("report", "run", "--no-open")  # a PDF only where there is a Chromium
    assert Path("run/report/report.html").stat().st_size > 100_000
    do("view", "run", "-o", "view.html", "--no-open")
    do("plot", "run", "-o", "plot.svg")
    do("picture", "leg.yaml", "-o", "leg.pdf")
    do("export", "run", "leg.csv")
    for file in ("leg.xml", "leg.urdf"):
        do("export", "leg.yaml", file)
        closures = ["--closures", "leg.closures.yaml"] if file.endswith("urdf") else []
        assert "1 loop;" in do("import", file, "-o", f"{file}.yaml", *closures)
        do("check", f"{file}.yaml")
    found = json.loads(do("verify", "--filter", "Table 3.2", "--json"))
    assert found["entries"]
    assert all(entry["passed"] for entry in found["entries"])
    in_python()
    for name, files in example_files().items():
        assert kinetruss.check(files[0]) == [], name


def in_python() -> None:
    """The same by calls: over one turn a drive does no work, and its power is the rate of energy."""
    model = kinetruss.library.mechanisms.four_bar(coupler_mass=0.5)
    motion = kinetruss.kinematics.follow(model, kinetruss.ConstantRate(rates={"motor": math.tau}, duration=1), samples=361)
    forces = kinetruss.dynamics.inverse(model, motion)
    torque = forces.drive_force.sel(drive="motor").values
    assert abs(math.tau * torque[:-1].mean()) < 1e-9
    assert abs(forces.power - forces.energy_rate).max() < 1e-12
    assert len(forces.to_dataframe())


def missing() -> None:
    """A verb whose extra is not installed ends with exit code 2 and the command that installs it."""
    for extra, arguments in EXTRAS.items():
        assert f"kinetruss[{extra}]" in do(*arguments, code=2), extra


def extras() -> None:
    """What the extras add: other formats, pictures, the studio, a model in a notebook."""
    do("new", "beam", "--like", "triangular_truss")
    do("run", "beam.yaml", "-o", "run2")
    for name in ("beam.parquet", "beam.nc", "beam.dxf", "beam.vtu", "beam.pvd"):
        do("export", "run2", name)
        assert Path(name).stat().st_size > 500, name
    do("import", "beam.dxf", "-o", "lines.yaml")
    if shutil.which("chromium"):
        do("render", "beam.yaml", "-o", "beam.png", "--size", "320x240")
        do("render", "run2", "-o", "beam.gif", "--size", "240x180", "--fps", "4")
    else:
        assert "apt-get install chromium" in do("render", "beam.yaml", "-o", "beam.png", code=2)
        print("         no chromium here: pictures are not tried", flush=True)
    from kinetruss import notebook

    assert notebook.live(kinetruss.read("beam.yaml")) is not None
    studio()


def studio() -> None:
    """The studio is asked for its numbers over the network of this machine, and ends with Ctrl-C."""
    from websockets.sync.client import connect

    os.environ["no_proxy"] = "127.0.0.1"  # websockets 14 knows no other way
    served = subprocess.Popen([PROGRAM, "studio", "beam.yaml", "--no-open"], stdout=subprocess.PIPE, text=True)
    try:
        address = re.search(r"http://\S+", served.stdout.readline())[0]
        options = {"origin": address[: address.index("/", 8)], "max_size": 2**24, "compression": None}
        with connect(address.replace("http", "ws", 1) + "live", **options) as page:
            assert b'"scene"' in page.recv(60)[:1000]
            page.send(json.dumps({"do": "query"}))
            assert json.loads(page.recv(60))["kind"] == "numbers"
        served.send_signal(signal.SIGINT)
        assert served.wait(60) == 0
    finally:
        served.kill()
        served.stdout.close()
    print("         kinetruss studio beam.yaml", flush=True)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for part in sys.argv[1:] or ["core"]:
            print(f"{part}, Python {sys.version.split()[0]}", flush=True)
            {"core": core, "missing": missing, "extras": extras}[part]()
    print("the wheel is whole")
