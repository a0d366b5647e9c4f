"""How many updates a second a page of the studio gets, by the number of members: through a real server and its websocket.

    python bench/studio.py [--json] [--updates N]

One update: drives moved and followed, forces, stresses, motors of small models, packing, the way to the client. Wall time and
processor time of the server (where the system tells it), medians of all updates after a warm-up.
"""

from __future__ import annotations

import argparse
import json
import re
import statistics
import subprocess
import sys
import tempfile
import time
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


def measure(name: str, model: kt.Model, updates: int) -> dict[str, object]:
    with tempfile.TemporaryDirectory() as folder:
        path = kt.write(model, Path(folder) / "model.yaml")
        command = [sys.executable, "-c", "from kinetruss.cli import main; main()", "studio", str(path), "--no-open"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            try:
                address = re.search(r"http://\S+", process.stdout.readline())[0]
                counts = {"case": name, "members": len(model.members), "drives": len(model.all_drives)}
                return counts | talk(address, process.pid, updates)
            finally:
                process.kill()


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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--updates", type=int, default=60)
    options = parser.parse_args()
    rows = [measure(name, model, options.updates) for name, model in models().items()]
    if options.json:
        print(json.dumps({"rows": rows}))
        return
    for row in rows:
        print(", ".join(f"{key} {value:.1f}" if isinstance(value, float) else f"{key} {value}" for key, value in row.items()))


if __name__ == "__main__":
    main()
