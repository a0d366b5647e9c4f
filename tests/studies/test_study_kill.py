"""A study whose workers, or which itself, are killed: every row once, and the same numbers as of a study that was not."""

import contextlib
import os
import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

import kinetruss as kt
from kinetruss.studies import working

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="processes are forked on Linux alone")

COMMAND = "from kinetruss.cli.start import start; start()"
SLOW = """
model: four_bar.yaml
run: turn
variables:
  nodes.C.mass: {between: [0.2 kg, 1 kg]}
  samples: {paths: [runs.turn.samples], values: [4000, 4001]}
sample: {latin_hypercube: 160, seed: 3}
results: {peak: peak_member_force, power: peak_drive_power}
"""


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    folder = tmp_path_factory.mktemp("study")
    (folder / "four_bar.yaml").write_text(Path(kt.library.example_files()["four_bar"][0]).read_text())
    (folder / "slow.study.yaml").write_text(SLOW)
    return folder / "slow.study.yaml"


@pytest.fixture(scope="module")
def whole(file):
    """The study without interruption."""
    return kt.studies.run_study(file, workers=2)


def begun(file, out, *more):
    command = [sys.executable, "-c", COMMAND, "study", str(file), "-o", str(out), *more]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def kept(out):
    """Row -> what is kept of it, of the rows that are done."""
    if not (out / "study.sqlite").exists():
        return {}
    with contextlib.closing(sqlite3.connect(out / "study.sqlite", timeout=30)) as connection:
        return {
            row: rest for row, *rest in connection.execute("select row, seconds, numbers from rows where status is not null")
        }


def wait_for_rows(process, out, least):
    until = time.monotonic() + 120
    while len(kept(out)) < least:
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < until
        time.sleep(0.02)


def children(parent):
    found = []
    for place in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            fields = (place / "stat").read_text().rpartition(")")[2].split()
            if int(fields[1]) == parent and fields[0] != "Z":
                found.append(int(place.name))
    return found


def both_of(parent):
    """The two processes that work for a study; on a busy machine the second one starts late."""
    until = time.monotonic() + 60
    while len(found := children(parent)) < 2:
        assert time.monotonic() < until
        time.sleep(0.02)
    assert len(found) == 2
    return found


def gone(processes):
    until = time.monotonic() + 30
    while any(
        Path(f"/proc/{one}").exists() and "Z" not in Path(f"/proc/{one}/stat").read_text().split()[2] for one in processes
    ):
        assert time.monotonic() < until
        time.sleep(0.02)


def same(out, whole):
    """All rows once, with the numbers of the study without interruption, in the ledger and for other programs."""
    found = kt.studies.load_study(out)
    assert found.good.all()
    table = pq.read_table(out / "results.parquet").to_pydict()
    assert table["row"] == list(range(160))
    for name in ("nodes.C.mass", "samples", "peak", "power"):
        np.testing.assert_array_equal(found.data[name].values, whole.data[name].values)
        np.testing.assert_array_equal(table[name], whole.data[name].values)


@pytest.mark.slow
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
def test_a_study_that_is_killed_goes_on(tmp_path, file, whole, how):
    out = tmp_path / "out"
    process = begun(file, out, "--workers", "2")
    wait_for_rows(process, out, 10)
    copies = both_of(process.pid)
    process.send_signal(how)
    _, said = process.communicate(timeout=60)
    gone(copies)
    before = kept(out)
    assert 10 <= len(before) < 160
    if how == signal.SIGINT:
        assert process.returncode == 130
        assert f"Interrupted; {len(before)} of 160 variants are kept." in said
        assert pq.read_table(out / "results.parquet").to_pydict()["status"].count("COMPLETED") == len(before)
    again = begun(file, out, "--workers", "2", "-q")
    _, said = again.communicate(timeout=300)
    assert (again.returncode, said) == (0, "")
    after = kept(out)
    assert {row: after[row] for row in before} == before  # nothing is computed twice: also the seconds are those of before
    same(out, whole)


@pytest.mark.slow
def test_a_worker_that_is_killed_costs_nothing(tmp_path, file, whole):
    out = tmp_path / "out"
    process = begun(file, out, "--workers", "2", "-q")
    wait_for_rows(process, out, 5)
    os.kill(children(process.pid)[0], signal.SIGKILL)
    _, said = process.communicate(timeout=300)
    assert (process.returncode, said) == (0, "")
    same(out, whole)


CLUSTER = """
import sys, time
from distributed import LocalCluster
if __name__ == "__main__":
    cluster = LocalCluster(n_workers=3, threads_per_worker=1, host="127.0.0.1", dashboard_address=None, processes=True)
    print(cluster.scheduler_address, flush=True)
    sys.stdin.read()
    cluster.close()
"""


@pytest.fixture
def cluster(tmp_path):
    """The address of a cluster of three worker processes on this machine, and a function for their numbers."""
    pytest.importorskip("distributed")
    (tmp_path / "cluster.py").write_text(CLUSTER)
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
    with subprocess.Popen([sys.executable, "cluster.py"], text=True, cwd=tmp_path, **pipes) as process:
        address = process.stdout.readline().strip()
        yield address, process
        process.stdin.close()
        process.wait(timeout=60)


def workers_of(address):
    """The processes of the workers."""
    code = "import sys, os, distributed\nwith distributed.Client(sys.argv[1]) as client: print(*client.run(os.getpid).values())"
    found = subprocess.run([sys.executable, "-c", code, address], capture_output=True, text=True, check=True)
    return [int(word) for word in found.stdout.split()]


def listeners(process):
    """Addresses on which a process and its descendants listen."""
    every, left = [], [process]
    while left:
        one = left.pop()
        every.append(one)
        left += children(one)
    sockets = {
        link.readlink().name if hasattr(link, "readlink") else ""
        for one in every
        for link in Path(f"/proc/{one}/fd").glob("*")
        if link.is_symlink()
    }
    found = set()
    for table in ("tcp", "tcp6"):
        for line in Path(f"/proc/net/{table}").read_text().splitlines()[1:]:
            fields = line.split()
            if fields[3] == "0A" and f"socket:[{fields[9]}]" in sockets:
                found.add(fields[1].partition(":")[0])
    return found


@pytest.mark.slow
def test_a_cluster_loses_workers_and_the_study_itself(tmp_path, file, whole, cluster):
    address, process = cluster
    out = tmp_path / "out"
    study = begun(file, out, "--cluster", address)
    wait_for_rows(study, out, 10)
    assert listeners(study.pid) == set()  # the study opens nothing; the cluster only what it was told to
    assert listeners(process.pid) <= {"0100007F"}
    victim = workers_of(address)[0]
    os.kill(victim, signal.SIGKILL)
    wait_for_rows(study, out, 30)
    study.kill()
    study.communicate(timeout=60)
    before = kept(out)
    assert 30 <= len(before) < 160
    again = begun(file, out, "--cluster", address, "-q")
    wait_for_rows(again, out, len(before) + 10)
    for one in workers_of(address)[:2]:
        os.kill(one, signal.SIGKILL)
    _, said = again.communicate(timeout=300)
    assert again.returncode == 0, said
    after = kept(out)
    assert {row: after[row] for row in before} == before
    same(out, whole)


def test_a_cluster_that_is_not_there_is_told_before_anything(tmp_path, file):
    pytest.importorskip("distributed")
    process = begun(file, tmp_path / "out", "--cluster", "tcp://127.0.0.1:9")
    _, said = process.communicate(timeout=120)
    assert process.returncode == 2
    assert "The cluster at tcp://127.0.0.1:9 is not reached" in said
    assert "dask scheduler --host 127.0.0.1" in said
    assert not (tmp_path / "out").exists()


def test_a_row_that_kills_its_process_is_a_failure(monkeypatch):
    study = kt.studies.Study(
        model=kt.library.example_files()["four_bar"][0],
        run="turn",
        variables={"nodes.C.mass": {"between": ["0.2 kg", "1 kg"]}},
        sample={"grid": 9},
        results={"peak": "peak_member_force"},
    )
    plain = working.evaluate

    def evaluate(task, rows):
        if any(row == 5 for row, _ in rows):
            os.kill(os.getpid(), signal.SIGKILL)
        return plain(task, rows)

    monkeypatch.setattr(working, "evaluate", evaluate)
    found = kt.studies.run_study(study, workers=2)
    assert found.status.tolist() == ["COMPLETED"] * 5 + ["DIED"] + ["COMPLETED"] * 3
    assert found.data["message"].values[5] == "Its process died 3 times."
    assert np.isnan(found.data["peak"].values[5])
    assert found.failures == {"DIED": 1}
