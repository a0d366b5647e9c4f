"""What files may look like, and what is refused before it is parsed."""

import json
from pathlib import Path

import pytest
from hypothesis import given, strategies as st

import kinetruss as kt
from kinetruss.io.yaml_text import parse_json, parse_yaml, plain

BAR = """
kinetruss: 1
nodes: {no: [0, 0], 12:30: [1e0, 0], "null": [0, 100 mm]}
fixed: [no]
bars: {on: [no, 12:30], y: [no, "null"]}
"""


@pytest.fixture
def put(tmp_path):
    """Write a text or bytes to a file and name it."""

    def write(text, name="model.yaml"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return write


def faults(path, **options):
    return [str(fault) for fault in kt.check(path, **options)]


def test_words_that_look_like_values_are_names(put):
    model = kt.read(put(BAR))
    assert list(model.nodes) == ["no", "12:30", "null"]
    assert list(model.bars) == ["on", "y"]
    assert model.nodes["12:30"].at == (1.0, 0.0)
    assert model.nodes["null"].at == (0.0, 0.1)


def test_yaml_and_json_of_one_model(put):
    data = {
        "kinetruss": 1,
        "nodes": {"A": [0, 0], "B": ["36 in", 0]},
        "fixed": {"A": "xy"},
        "bars": {"ab": {"ends": ["A", "B"]}},
    }
    assert kt.read(put(json.dumps(data), "a.json")) == kt.read(put(json.dumps(data), "a.yaml"))


def test_byte_order_mark_and_windows_lines(put):
    assert kt.read(put(b"\xef\xbb\xbf" + BAR.replace("\n", "\r\n").encode())) == kt.read(put(BAR, "b.yaml"))


def test_aliases(put):
    text = "kinetruss: 1\nsection: &tube {kind: rod, diameter: 1 cm}\nsections: {a: *tube, b: *tube}\nnodes: {A: [0, 0]}\n"
    model = kt.read(put(text))
    assert model.section == model.sections["a"] == model.sections["b"]


def test_missing_file_offers_a_near_name(put):
    path = put(BAR, "bridge.yaml")
    assert faults(path.with_name("brigde.yaml")) == [f"model: there is no such file. Did you mean {str(path)!r}?"]
    assert "There is no folder" in faults(path.parent / "nowhere" / "bridge.yaml")[0]


def test_folder(tmp_path):
    assert faults(tmp_path) == ["model: is a folder. Name a model file in it, e.g. model.yaml."]


def test_large_file_is_refused_unread(tmp_path):
    path = tmp_path / "large.yaml"
    with path.open("wb") as file:
        file.truncate(100_000_000)  # takes no room on the disk; reading it would
    assert faults(path) == [
        "model: has 100,000,000 bytes, more than the limit of 64,000,000 bytes. "
        "Raise it with --max-size (max_size=...) if the file is meant."
    ]


def test_limit_is_an_option(put):
    path = put(BAR)
    assert "more than the limit of 10 bytes" in faults(path, max_size=10)[0]
    assert faults(path, max_size=path.stat().st_size) == []


def test_endless_file():
    assert "more than the limit" in faults("/dev/zero", max_size=1000)[0]


@pytest.mark.parametrize("suffix", [".yaml", ".json"])
def test_deep_nesting_is_refused_and_not_followed(put, suffix):
    assert "nested more than 50 levels" in faults(put("[" * 1_000_000, f"deep{suffix}"))[0]


@pytest.mark.parametrize("suffix", [".yaml", ".json"])
def test_values_beyond_any_model(put, suffix, monkeypatch):
    monkeypatch.setattr("kinetruss.io.yaml_text.LARGEST", 1000)
    assert "more than 1,000 values" in faults(put("[" + "1, " * 2000, f"many{suffix}"))[0]


def test_faults_of_files_do_not_hide_each_other(put):
    text = """
kinetruss: 1
nodes: {A: [0, 0], A: [1, 0], B: [1, 0]}
bars: {ab: [A, B], aa: [A, A]}
library: {name: vgt.triangulr}
drives: {d: {kind: length, bar: ab, speed: 3}}
runs:
  up: {trajectory: {kind: spline, file: none.csv}}
  down: {trajectory: {kind: quintic, moves: {ab: [1, 2 kg]}, duration: 1}}
"""
    told = faults(put(text))
    for part in ("'A' is given twice", "no library model", "'speed' is not known", "there is no such file", "'2 kg' is not"):
        assert sum(part in line for line in told) == 1


def test_a_name_that_is_faulty_itself_is_not_said_to_be_missing(put):
    text = """
kinetruss: 1
nodes: {A: [0, 0], B: [1 kg, 0]}
bars: {ab: [A, B]}
sections: {s: {kind: tube, outer: 1, inner: 2}}
section: s
trajectories: {t: {kind: quintic, moves: {ab: [1, 2]}, duration: 0}}
runs: {r: {trajectory: t}}
"""
    places = [line.split(": ")[0] for line in faults(put(text))]
    assert places == ["nodes.B.at.0", "sections.s", "trajectories.t.moves.ab", "trajectories.t.duration"]


def test_faults_come_in_the_order_of_the_file(put):
    text = "bars: {b: [A, B]}\nnodes: {A: [0, x], D: [0, 0]}\nfixed: [C]\nkinetruss: 1\n"
    places = [(fault.line, fault.column) for fault in kt.check(put(text))]
    assert places == sorted(places) == [(1, 15), (2, 16), (3, 9)]


numbers = st.integers(-(10**20), 10**20) | st.floats(allow_nan=False, allow_infinity=False)
scalars = st.none() | st.booleans() | numbers | st.text()
names = st.text(max_size=80)  # escaped at most 960 characters long; longer ones are refused
trees = st.recursive(scalars, lambda inner: st.lists(inner, max_size=4) | st.dictionaries(names, inner, max_size=4))


@given(trees, st.sampled_from([None, 1, "\t"]))
def test_json_is_read_as_the_standard_library_reads_it(tree, indent):
    text = json.dumps(tree, indent=indent)
    found, told = parse_json(text)
    assert plain(found) == json.loads(text)
    assert told == []


@pytest.mark.parametrize("name", ["n" * 1100, "\u0301" * 200, '\\"' * 600])
def test_names_in_json_that_are_too_long_are_refused(name):
    with pytest.raises(kt.ModelError, match="has a name of .* characters. Write at most 1000"):
        parse_json(json.dumps({"nodes": {name: [0, 0]}}))
    assert plain(parse_json(json.dumps({"text": name, "more": [name]}))[0]) == {"text": name, "more": [name]}


def test_long_rows_between_texts_in_json_are_no_names():
    tree = {"a": [0.125] * 400, ":b": [1], "c": [*range(500), ": text"]}
    assert plain(parse_json(json.dumps(tree))[0]) == tree


def test_what_json_forbids_and_yaml_has():
    found, told = parse_json('{"a": [1, 2.50,], # a remark\n "b": "\\ud83d\\ude00 \\\\ud83d", "c": null}')
    assert (plain(found), told) == ({"a": [1, 2.5], "b": "\U0001f600 \\ud83d", "c": None}, [])
    for text in ("{a: 1}", '{"a": yes}', "{'a': 'b'}", '{"a": 0x1F}', '{"a": Infinity}', "a: 1", '{"a": 1} 2'):
        with pytest.raises(kt.ModelError, match="is not JSON"):
            parse_json(text)


@given(st.text(alphabet="{}[],:\" \n\t1e-.truefalsn'&*!|>#ab", max_size=40))
def test_any_text_is_parsed_or_refused(text):
    for parse in (parse_json, parse_yaml):
        try:
            parse(text)
        except kt.ModelError as error:
            assert all(fault.line >= 1 and fault.column >= 1 for fault in error.faults)


@given(st.binary(max_size=60))
def test_any_bytes_are_refused(tmp_path_factory, data):
    path = tmp_path_factory.getbasetemp() / "any.yaml"
    path.write_bytes(data)
    assert kt.check(path)


def test_thousands_of_members(put):
    nodes = "".join(f"  n{i}: [{i * 0.1}, {i % 2}]\n" for i in range(2502))
    bars = "".join(f"  a{i}: [n{i}, n{i + 1}]\n  b{i}: {{ends: [n{i}, n{i + 2}], mass: 3 kg}}\n" for i in range(2500))
    assert len(kt.read(put(f"nodes:\n{nodes}bars:\n{bars}fixed: [n0]\n")).bars) == 5000


def test_path_may_be_text():
    assert kt.read(str(Path(kt.library.example_files()["four_bar"][0]))).title == "Four-bar linkage"
