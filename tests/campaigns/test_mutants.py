"""The faults of the table have their places, and a campaign tells which of them the tests find."""

import re
import shlex

import pytest

from campaigns.mutants import ROOT, Campaign, Mutant, PlaceError, Source, read

TABLE = read()
PROJECT = {
    "pyproject.toml": "",
    "src/kinetruss/__init__.py": "def area(a, b):\n    return (a\n        * b)\n\n\ndef edge(a, b):\n    return 2 * (a + b)",
    "src/kinetruss/unit.py": "def unit():\n    return 1.0\n\n\nONE = 1.0 / unit()\n",
    "tests/test_area.py": "from kinetruss import area, unit\n\n\ndef test_area():\n    assert area(2, 3) == 6 * unit.ONE\n",
    "tests/test_wrong.py": "def test_wrong():\n    assert False\n",
}


@pytest.fixture
def project(tmp_path):
    for name, text in PROJECT.items():
        (file := tmp_path / "project" / name).parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path / "project"


def fault(function, before, after, tests="tests/test_area.py"):
    return Mutant(f"{function}: {before}", "sign", function, before, after, tests)


@pytest.mark.slow
def test_every_fault_has_one_place_and_tests():
    source = Source(ROOT / "src/kinetruss")
    for one in TABLE:
        file, text = source.mutated(one)
        assert text != source.texts[file], one.name
        places = [word for word in shlex.split(one.tests) if word.startswith("tests/")]
        assert places and all((ROOT / place).exists() for place in places), one.name
    assert len(TABLE) == 69


def test_a_place_is_found_however_it_is_laid_out(project):
    file, text = Source(project / "src/kinetruss").mutated(fault("area", "a * b", "a - b"))
    assert text.decode().splitlines() == ["def area(a, b):", "    return ((a - b", "))", *text.decode().splitlines()[3:]]
    assert text.count(b"\n") == PROJECT[f"src/kinetruss/{file}"].count("\n")


@pytest.mark.parametrize("function, before, times", [("area", "a + b", 0), ("volume", "a * b", 0), ("same", "a", 2)])
def test_a_place_that_is_gone_or_one_of_two_is_told(project, function, before, times):
    (project / "src/kinetruss/same.py").write_text("def same(a):\n    return a * a\n")
    with pytest.raises(PlaceError, match=f"the place is gone: {function} has '{re.escape(before)}' {times} times"):
        Source(project / "src/kinetruss").mutated(fault(function, before, "b"))


@pytest.mark.slow
def test_what_becomes_of_faults(project, tmp_path):
    faults = {
        "found": fault("area", "a * b", "a + b"),
        "survived": fault("edge", "a + b", "a - b"),
        "error": fault("unit", "1.0", "0.0"),  # at import, so that no test runs
        "no place": fault("edge", "a * b", "a"),
    }
    wrong = fault("edge", "2 * (a + b)", "a", "tests/test_wrong.py")

    def become(*chosen):
        return Campaign(chosen, project, tmp_path / "work", workers=2, again=False).outcomes()

    outcomes = become(*faults.values(), wrong)
    for verdict, one in faults.items():
        assert outcomes[one.name]["verdict"] == verdict, outcomes
    assert outcomes[wrong.name]["said"] == "the tests fail without the fault, too"
    log = tmp_path / "work/found.jsonl"
    lines = log.read_text().splitlines()
    assert len(lines) == 5  # two selections of tests, three faults that have a place
    assert become(*faults.values(), wrong) == outcomes and log.read_text().splitlines() == lines
    assert (project / "src/kinetruss/__init__.py").read_text() == PROJECT["src/kinetruss/__init__.py"]
    (project / "tests/test_area.py").write_text("def test_area():\n    assert True\n")  # finds nothing
    assert become(faults["found"])[faults["found"].name]["verdict"] == "survived"
