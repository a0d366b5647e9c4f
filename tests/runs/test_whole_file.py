"""Files for people: whole or not there, and what stood there stays."""

import os
import threading

import pytest

import kinetruss as kt
from kinetruss.results.folder import whole_file


def test_what_stood_there_stays_until_the_end(tmp_path):
    target = tmp_path / "table.csv"
    target.write_text("old")
    with pytest.raises(KeyboardInterrupt), whole_file(target) as draft:
        draft.write_text("half of the new")
        raise KeyboardInterrupt
    assert target.read_text() == "old"
    assert [item.name for item in tmp_path.iterdir()] == ["table.csv"]
    with whole_file(target) as draft:
        draft.write_text("new")
        assert (target.read_text(), draft.suffix) == ("old", ".csv")
    assert target.read_text() == "new"
    assert [item.name for item in tmp_path.iterdir()] == ["table.csv"]


def test_its_folder_is_made(tmp_path):
    target = tmp_path / "a" / "b" / "model.yaml"
    kt.write(kt.Model(nodes={"A": (0, 0)}), target)
    assert kt.read(target).dim == 2


def test_a_place_that_cannot_be_written_is_told_with_the_mend(tmp_path):
    (tmp_path / "file").write_text("")
    told = pytest.raises(kt.StoreError, match=r"x\.csv cannot be written: .*\. Name another place\.")
    with told, whole_file(tmp_path / "file" / "x.csv") as draft:
        draft.write_text("never")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the test needs os.mkfifo, which this system lacks")
def test_a_pipe_is_written_to_and_stays_a_pipe(tmp_path):
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    heard = []
    reader = threading.Thread(target=lambda: heard.append(pipe.read_text()))
    reader.start()
    with whole_file(pipe) as draft:
        draft.write_text("rows")
    reader.join(timeout=30)
    assert heard == ["rows"]
    assert pipe.is_fifo()
