"""The archive of a run: a ZIP file that grows, is whole when it is sealed, and is good up to a length after a kill."""

import shutil
import zipfile
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from kinetruss.results.archive import Archive, content_of, header, listed, walked

NAMES = st.text("abz/._0", min_size=1, max_size=6)
BATCHES = st.lists(st.dictionaries(NAMES, st.binary(max_size=9), max_size=3), max_size=3)


def found(path: Path, length: int | None = None) -> dict[str, bytes]:
    """Contents by the directory, or of the first bytes."""
    with path.open("rb") as file:
        members = listed(file) if length is None else walked(file, length)
        return {name: content_of(file, name, one) for name, one in members.items()}


def written(path: Path, *batches: dict[str, bytes]) -> int:
    """A sealed archive of some batches, and its length."""
    archive = Archive(path)
    for batch in batches:
        archive.append(batch, durable=False)
    archive.seal(durable=False)
    archive.close()
    return archive.length


@settings(deadline=None, max_examples=15, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(before=BATCHES, last=st.dictionaries(NAMES, st.binary(max_size=9), min_size=1, max_size=2), sealed=st.booleans())
def test_a_kill_at_any_byte_of_an_append_leaves_what_was_whole(tmp_path, before, last, sealed):
    """The last batch is written over the directory up to any of its bytes; the rest of the directory stands behind."""
    shutil.rmtree(tmp_path)
    tmp_path.mkdir()
    length = written(tmp_path / "before", *before)
    good = (tmp_path / "before").read_bytes() if sealed else (tmp_path / "before").read_bytes()[:length]
    whole = {name: content for batch in before for name, content in batch.items()}
    end = written(tmp_path / "after", *before, last)
    after = (tmp_path / "after").read_bytes()
    assert after[:length] == good[:length]
    killed = tmp_path / "killed"
    for count in range(end - length + 1):
        killed.write_bytes(after[: length + count] + good[length + count :])
        assert found(killed, length) == whole
        archive = Archive(killed, length)
        assert killed.stat().st_size == length
        assert {name: archive.read(name) for name in archive.members} == whole
        archive.append(last, durable=False)
        archive.seal(durable=False)
        archive.close()
        assert killed.read_bytes() == after
    assert found(killed) == found(killed, end) == whole | last


@settings(deadline=None, max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(batches=BATCHES)
def test_it_is_a_zip_file_with_each_name_once(tmp_path, batches):
    path = tmp_path / "a.zip"
    path.unlink(missing_ok=True)
    written(path, *batches)
    whole = {name: content for batch in batches for name, content in batch.items()}
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        assert sorted(archive.namelist()) == sorted(whole)
        assert {name: archive.read(name) for name in archive.namelist()} == whole


def test_one_that_the_zipfile_module_wrote_is_read(tmp_path):
    """Short variants before format 2 were written by it; its headers and its directory are ours to the last byte."""
    contents = {"zarr.json": b"{}", "motion/time/0": bytes(100), "empty": b""}
    with zipfile.ZipFile(tmp_path / "theirs", "w") as archive:
        for name, content in contents.items():
            archive.writestr(zipfile.ZipInfo(name), content)
    written(tmp_path / "ours", contents)
    assert (tmp_path / "ours").read_bytes() == (tmp_path / "theirs").read_bytes()
    assert found(tmp_path / "theirs") == contents


def test_every_byte_of_a_member_and_its_header_is_looked_at(tmp_path):
    path = tmp_path / "a"
    length = written(path, {"motion/time/0": b"some values", "b": b"more"})
    good, right = path.read_bytes(), found(path)
    for at in range(len(good)):
        path.write_bytes(good[:at] + bytes([good[at] ^ 16]) + good[at + 1 :])
        for until in (None, length):
            try:
                seen = found(path, until)
            except (OSError, ValueError):
                continue
            # a name that differs is a member that is missing; the fields of the directory that say nothing may differ
            assert at >= length or seen.keys() != right.keys()
            assert all(right[name] == seen[name] for name in right.keys() & seen.keys())


@pytest.mark.parametrize("less", [1, 20, 60])
def test_one_that_is_shorter_than_its_length_is_refused(tmp_path, less):
    length = written(tmp_path / "a", {"a": b"some values", "b": b"more"})
    path = tmp_path / "cut"
    path.write_bytes((tmp_path / "a").read_bytes()[: length - less])
    with pytest.raises(ValueError, match="its archive"):
        found(path, length)
    with pytest.raises(ValueError, match="its archive"):
        Archive(path, length)
    assert path.stat().st_size == length - less  # nothing is cut off from what is damaged
    with pytest.raises(ValueError, match="no directory"):
        found(path)


def test_what_did_not_change_is_not_written_again(tmp_path):
    archive = Archive(tmp_path / "a")
    archive.append({"a": b"1", "b": b"2"})
    length = archive.length
    archive.append({"a": b"1", "b": b"2"})
    assert archive.length == length
    archive.append({"a": b"3"})
    assert archive.length == length + len(header("a", archive.members["a"])) + 1
    archive.close()
    assert found(tmp_path / "a", archive.length) == {"a": b"3", "b": b"2"}


def test_a_disk_that_refuses_leaves_the_archive_as_it_was(tmp_path, monkeypatch):
    archive = Archive(tmp_path / "a")
    archive.append({"a": b"1"})
    with monkeypatch.context() as patch:
        patch.setattr("os.fsync", lambda _handle: (_ for _ in ()).throw(OSError(28, "No space left on device")))
        with pytest.raises(OSError, match="No space"):
            archive.append({"b": bytes(1000)})
    assert list(archive.members) == ["a"]
    archive.append({"c": b"3"})
    archive.seal()
    archive.close()
    assert found(tmp_path / "a") == {"a": b"1", "c": b"3"}


def test_places_beyond_four_gigabytes_are_listed(tmp_path):
    """The hole between the members takes no room on the disk."""
    archive = Archive(tmp_path / "a")
    archive.append({"a": b"1"})
    archive.length = 5 << 30
    archive.append({"b": b"2"})
    archive.seal()
    archive.close()
    assert found(tmp_path / "a") == {"a": b"1", "b": b"2"}
    with zipfile.ZipFile(tmp_path / "a") as opened:
        assert opened.testzip() is None
        assert opened.infolist()[1].header_offset == 5 << 30


@pytest.mark.parametrize("count", [65_534, 65_535, 70_000])
def test_any_number_of_members_is_listed(tmp_path, count):
    contents = {f"m{k}": b"" for k in range(count)}
    length = written(tmp_path / "a", contents)
    assert found(tmp_path / "a") == contents
    with zipfile.ZipFile(tmp_path / "a") as opened:
        assert opened.start_dir == length
    data = (tmp_path / "a").read_bytes()[length:]
    assert (b"PK\6\6" in data) == (count >= 65_535)
