"""How many updates a second a page of the studio gets, by the number of members: through a real server and its websocket.

    python bench/studio.py [--json] [--updates N]

One update: drives moved and followed, forces, stresses, motors of small models, packing, the way to the client. Wall time and
processor time of the server (where the system tells it), medians of all updates after a warm-up.

Then, where there is Chromium, a drawing that plays: a lattice boom on a jack, of 40 and of 400 bars. `ready_s` is from the
press of Play to the first picture, once kernels are loaded; `pictures_per_second` counts pictures on the screen during 3 s,
`page_ms` is what the page computes for each. Then the same with the strength as colour.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from websockets.sync.client import connect

import kinetruss as kt


def models() -> dict[str, kt.Model]:
    """A double-octahedral bay with the three bars of its base triangle (21 members), and a chain of 56 bays."""
    bay = kt.library.vgt.double_octahedral(bays=1)
    feet = list(bay.fixed)
    base = {f"base_{k}": kt.Bar(ends=(feet[k], feet[k - 1])) for k in range(3)}
    return {"bay": bay.with_(bars={**bay.bars, **base}), "chain": kt.library.vgt.double_octahedral(bays=56)}


def processor_time(pid: int) -> float:
    """Seconds that a process has computed."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / 100


@contextmanager
def studio_of(model: kt.Model, folder: str) -> Iterator[tuple[str, int]]:
    """Address and process of a studio of a model."""
    path = kt.write(model, Path(folder) / "model.yaml")
    command = [sys.executable, "-c", "from kinetruss.cli import main; main()", "studio", str(path), "--no-open"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield re.search(r"http://\S+", process.stdout.readline())[0], process.pid
        finally:
            process.kill()


def measure(name: str, model: kt.Model, updates: int) -> dict[str, object]:
    with tempfile.TemporaryDirectory() as folder, studio_of(model, folder) as (address, pid):
        counts = {"case": name, "members": len(model.members), "drives": len(model.all_drives)}
        return counts | talk(address, pid, updates)


def talk(address: str, pid: int, updates: int) -> dict[str, float]:
    origin = "/".join(address.split("/")[:3])
    with connect(
        address.replace("http", "ws", 1) + "live", origin=origin, max_size=2**26, compression=None, proxy=None
    ) as page:
        first = page.recv(300)
        header = json.loads(first[4 : 4 + int.from_bytes(first[:4], "little")])
        start = dict(list(header["state"]["values"].items())[:3])
        times = []
        for k in range(updates + 5):
            if k == 5:
                computed = processor_time(pid)
            began = time.perf_counter()
            page.send(json.dumps({"do": "move", "values": {d: v * (1 + 0.0005 * (k % 20)) for d, v in start.items()}}))
            answer = page.recv(300)
            times.append(time.perf_counter() - began)
        computed = (processor_time(pid) - computed) / updates
    wall = statistics.median(times[5:])
    return {"ms": 1e3 * wall, "per_second": 1 / wall, "processor_ms": 1e3 * computed, "kB": len(answer) / 1e3}


def boom(bays: int) -> kt.Model:
    """A lattice boom, held at its foot and luffed by a jack: four bars a bay and two."""
    nodes = {f"{row}{k}": (float(k), float(height)) for k in range(bays + 1) for row, height in (("b", 0), ("t", 1))}
    pairs = [(f"b{k}", f"t{k}") for k in range(bays + 1)]
    for k in range(bays):
        pairs += [(f"b{k}", f"b{k + 1}"), (f"t{k}", f"t{k + 1}"), (f"b{k}", f"t{k + 1}")]
    bars = {f"m{k}": kt.Bar(ends=ends) for k, ends in enumerate(pairs)}
    bars["jack"] = kt.Bar(ends=("J", "b3"), kind="driven")
    return kt.Model(
        nodes={**nodes, "J": (2.0, -2.0)}, fixed={"b0": "xy", "J": "xy"}, bars=bars, gravity=(0, -9.81),
        section="tube_lacy_planar", material="aluminium_lacy",
    )  # fmt: skip


PLAY = """async (strength) => {
  const { draw } = kinetruss, { play } = draw;
  play.home();
  play.film = null;
  draw.shown.strength = strength;
  const began = performance.now();
  await play.toggle();
  await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  const ready = (performance.now() - began) / 1000, show = play.goTo.bind(play);
  let [count, spent] = [0, 0];
  play.goTo = (index) => {
    const at = performance.now();
    show(index);
    spent += performance.now() - at;
    count++;
  };
  const start = performance.now();
  while (performance.now() - start < 3000) await new Promise((resolve) => requestAnimationFrame(resolve));
  const passed = (performance.now() - start) / 1000;
  play.pause();
  play.goTo = show;
  return { ready_s: ready, pictures_per_second: count / passed, page_ms: spent / count, samples: play.film.frames };
}"""


def played(model: kt.Model) -> dict[str, object] | None:
    """A drawing that plays in a browser; None without one."""
    program = shutil.which("chromium") or shutil.which("chromium-browser")
    if program is None:
        return None
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, studio_of(model, folder) as (address, _), sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        page.goto(f"{address}draw/")
        page.wait_for_selector("#kinetruss[data-state=ready]", timeout=300_000)
        page.evaluate("async () => { const { draw } = kinetruss; draw.shown.strength = true; await draw.play.load(); }")
        found, judged = (page.evaluate(PLAY, strength) for strength in (False, True))
        browser.close()
    counts = {"case": "plays", "members": len(model.members), "drives": len(model.all_drives)}
    return counts | found | {f"strength_{name}": value for name, value in judged.items() if name != "samples"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--updates", type=int, default=60)
    options = parser.parse_args()
    rows = [measure(name, model, options.updates) for name, model in models().items()]
    rows += filter(None, [played(boom(bays)) for bays in (10, 100)])
    if options.json:
        print(json.dumps({"rows": rows}))
        return
    for row in rows:
        print(", ".join(f"{key} {value:.1f}" if isinstance(value, float) else f"{key} {value}" for key, value in row.items()))


if __name__ == "__main__":
    main()
