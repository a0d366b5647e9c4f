"""A short campaign of files put wrong at random, and faults that are planted; `.ci/run` has a longer one."""

import io
import json

import pytest

import kinetruss as kt
from campaigns import fuzz
from campaigns.mutations import places

pytestmark = pytest.mark.slow

SEED = 7


@pytest.fixture(scope="module")
def mill(tmp_path_factory):
    return fuzz.Mill(tmp_path_factory.mktemp("mill"))


def test_a_short_campaign_finds_nothing(tmp_path):
    told = io.StringIO()
    counts, bad = fuzz.campaign(tmp_path, 100, 5, SEED, told)
    assert not bad, [(one.case.name, one.what, one.details) for one in bad]
    assert sum(counts.values()) >= 105
    assert "refused" in told.getvalue()
    assert {path.suffix for path in tmp_path.iterdir()} <= {".csv"}


def test_a_case_is_always_the_same_file(tmp_path, mill):
    other = fuzz.Mill(tmp_path)
    for number in range(40):
        case = fuzz.Case(number, number % 2 == 0)
        assert mill.file(case).read_bytes() == other.file(case).read_bytes()


def test_its_models_pass_as_they_are(mill):
    for tree in mill.trees.values():
        (mill.folder / "model.json").write_text(json.dumps(tree))
        assert kt.check(mill.folder / "model.json") == []
        assert len(list(places(tree))) > 5


def endless():
    while True:
        pass


@pytest.mark.parametrize(
    ("planted", "what"),
    [
        (lambda *_: 1 / 0, "traceback: ZeroDivisionError"),
        (lambda *_: [0] * (1 << 40), "takes too much memory"),
        (endless, "takes too long"),
        (lambda *_: fuzz.os.kill(fuzz.os.getpid(), 9), "process died"),
        (lambda *_: fuzz.np.float64(1e308) * 10, "warning of NumPy"),
    ],
    ids=["traceback", "memory", "hang", "death", "warning"],
)
def test_planted_faults_are_found(mill, monkeypatch, planted, what):
    monkeypatch.setattr(fuzz, "LONGEST", 0.1)

    def judged(case, path):
        planted()
        return fuzz.Outcome(case, "refused")

    monkeypatch.setattr(fuzz, "judged", judged)
    found = list(fuzz.batch([fuzz.Case(1, False), fuzz.Case(2, False)], mill))
    assert [one.what for one in found] == [what, what]
    assert all(one.bad for one in found)


def test_too_few_runs_are_told(tmp_path, monkeypatch, mill):
    monkeypatch.setattr(mill, "warm", lambda: None)
    monkeypatch.setattr(fuzz, "Mill", lambda _: mill)
    monkeypatch.setattr(fuzz, "judged", lambda case, path: fuzz.Outcome(case, "refused"))
    _, bad = fuzz.campaign(tmp_path, 0, 1, SEED, io.StringIO())
    assert [one.what for one in bad] == ["unfinished"]
