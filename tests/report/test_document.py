"""The report of a run as a page."""

import base64
import hashlib
import html
import json
import re
from html.parser import HTMLParser

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt
from kinetruss import report
from kinetruss.display import Table, element
from kinetruss.display.tables import bar, span_bar
from kinetruss.report.document.checks import mobility_record
from kinetruss.report.document.inputs import worded
from kinetruss.report.document.run_pictures import FINE, thinned
from kinetruss.report.pictures.specs import Histories, Panel
from kinetruss.report.run_data import closure
from kinetruss.report.tables import is_over, margin_of, share_of, used_columns
from kinetruss.runs import RunResult, load, run
from samples import fourbar, tripod

VOID = {"meta", "link", "img", "br", "input"}


class Page(HTMLParser):
    """A page taken apart; what is not closed properly is a fault."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.addresses: list[str] = []
        self.tags: set[str] = set()
        self.headings: list[str] = []
        self.cells: list[str] = []
        self.words = ""
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        given = dict(attrs)
        if "id" in given:
            self.ids.append(given["id"])
        self.addresses += [value for key, value in attrs if key in ("href", "src", "xlink:href", "action")]
        if tag not in VOID:
            self.open.append(tag)
        if tag in ("h2", "td"):
            (self.headings if tag == "h2" else self.cells).append("")

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if not {"script", "style"} & set(self.open):
            self.words += data
        if "h2" in self.open and "span" not in self.open:  # without its number
            self.headings[-1] += data
        if "td" in self.open:
            self.cells[-1] += data


def embedded(text: str) -> dict:
    return json.loads(re.search(r'<script type="application/json" id="kinetruss-report">(.*?)</script>', text, re.DOTALL)[1])


@pytest.fixture(scope="module")
def lift_text(lift) -> str:
    return report.document_page(lift).html


PENDULUM = {
    "title": "let go", "nodes": {"O": (0, 0), "A": kt.Node(at=(0.4, 0), mass=0.5)}, "fixed": ("O",),
    "bars": {"arm": ("O", "A")},
    "gravity": (0, -9.81),
    "runs": {"fall": kt.Run(analysis="dynamics.simulate", t_end=1.0, samples=51,
                            events={"under": kt.Event(coordinate="A.x", value=0.0, stop=False)})},
}  # fmt: skip
MOVES = kt.ConstantRate(rates={"motor": 10.0}, duration=0.6283)
ALWAYS = ["Result", "Assumptions, and what was not checked", "Structure and loads", "Basis of the analysis", "Mobility",
          "Motion", "Checks", "Method and sources"]  # fmt: skip
KINDS = {
    "given motion": (lambda: tripod(), ["Member forces", "Strength", "Actuators", "Worked calculations"], ["Simulation"]),
    "motion only": (lambda: fourbar(runs={"turn": kt.Run(analysis="kinematics.follow", trajectory=MOVES)}), [],
                    ["Member forces", "Strength", "Actuators", "Simulation"]),
    "planar, no motors": (lambda: fourbar(), ["Member forces", "Strength"], ["Actuators", "Simulation"]),
    "let go": (lambda: kt.Model(**PENDULUM), ["Simulation", "Member forces", "Motion"], ["Actuators"]),
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_each_kind_of_run_has_its_parts(kind):
    make, there, absent = KINDS[kind]
    done = run(make())
    text = report.document_page(done).html
    page = Page(text)
    for name in (*(one for one in ALWAYS if one not in absent), *there):
        assert name in page.headings
    for name in absent:
        assert name not in page.headings
    assert "not complete" not in text
    assert len(page.ids) == len(set(page.ids))
    for address in page.addresses:
        assert address.startswith(("#", "data:")), address
        assert not address.startswith("#") or address[1:] in page.ids, address
    assert "url(http" not in text
    assert embedded(text) == report.document_page(done).record


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_what_happened_in_a_simulation_is_told():
    done = run(kt.Model(**PENDULUM))
    record = report.document_page(done).record
    cells = Page(report.document_page(done).html).cells
    assert f"{done.simulation.events[0].time:.9g} s" in cells
    assert [one["time"] for one in record["simulation"]["events"]] == [one.time for one in done.simulation.events]
    assert any("relative tolerance 1·10⁻¹⁰" in cell for cell in cells)


@pytest.mark.slow
def test_embedded_numbers_are_those_of_the_results(lift, lift_text):
    record = embedded(lift_text)
    for case, forces in lift.forces.items():
        values, time = forces.data["member_force"].values, forces.data["time"].values
        names = list(forces.data["member"].values)
        assert {one["member"] for one in record["envelopes"][case]} == set(names)
        for one in record["envelopes"][case]:
            column = values[:, names.index(one["member"])]
            assert (one["least"], one["largest"]) == (column.min(), column.max())
            assert (one["least_time"], one["largest_time"]) == (time[column.argmin()], time[column.argmax()])
            at = np.abs(column).argmax()
            assert one["at_rest"] == forces.static.data["member_force"].values[at, names.index(one["member"])]
    rows = lift.verdict.table()
    assert len(record["strength"]) == len(rows)
    for one, row in zip(record["strength"], rows, strict=True):
        for key in row.__slots__:
            assert one[key] == (None if getattr(row, key) != getattr(row, key) else getattr(row, key)), key
    demands = {(case, row.part, row.rule): row for case, demand in lift.demand.items() for row in demand.table()}
    assert len(record["limits"]) == len(demands)
    for one in record["limits"]:
        row = demands[one["load_case"], one["part"], one["rule"]]
        assert one["value"] == row.value
        assert one["utilisation"] == (None if np.isnan(row.utilisation) else row.utilisation)
    for one in record["reactions"]:
        data = lift.forces[one["load_case"]].data["reaction"].sel(support=one["support"])
        assert list(one["force"].values()) == data.sel(time=one["time"]).values.tolist()
        assert one["magnitude"] == np.linalg.norm(data.values, axis=1).max()
    drive = lift.motion.data["drive_position"].values
    assert [one["largest"] for one in record["drives"]] == drive.max(axis=0).tolist()
    assert record["drives"][0]["travel"] == [0.8, 1.3]


def tables(text: str) -> list[tuple[str, list[str], list[list[str]]]]:
    """Caption, heads and rows of every table with a head, as a reader sees them."""
    found = []
    for figure in re.findall(r'<figure class="table[^>]*>(.*?)</figure>', text, re.DOTALL):
        rows = [
            [html.unescape(re.sub(r"<[^>]*>", "", cell)) for cell in re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.DOTALL)]
            for row in re.findall(r"<tr>(.*?)</tr>", figure, re.DOTALL)
        ]
        caption = html.unescape(re.sub(r"<[^>]*>", "", re.search(r"<figcaption>(.*?)</figcaption>", figure, re.DOTALL)[1]))
        if "<thead>" in figure:
            found.append((caption, rows[0], rows[1:]))
    return found


@pytest.mark.slow
def test_tables_show_what_is_embedded_in_one_unit(lift_text):
    record = embedded(lift_text)
    shown = tables(lift_text)
    for case, envelope in record["envelopes"].items():
        name = "all loads" if case == "all" else f"load case {case}"
        _, heads, rows = next(one for one in shown if f"Envelope of member forces, {name}" in one[0])
        unit = re.search(r"\((k?N)\)", heads[2])[1]
        assert [re.search(r"\((k?N)\)", head)[1] for head in heads[2:5]] == [unit] * 3
        factor = {"N": 1.0, "kN": 1e-3}[unit]
        for row, one in zip(rows, envelope, strict=True):
            assert row[0] == one["member"]
            for cell, key in zip(row[2:5], ("least", "largest", "at_rest"), strict=True):
                decimals = len(cell.partition(".")[2])
                assert float(cell.replace("−", "-")) == pytest.approx(factor * one[key], abs=0.500001 * 10**-decimals)
    words = Page(lift_text).words
    assert "that were checked are exceeded" in words
    assert "185.8 V" in words  # beyond the 25 V of the motor
    assert "voltage too high" in words


@pytest.mark.slow
def test_a_reviewer_computes_the_same_again(lift, lift_text, tmp_path):
    """From nothing but the page: the saved model gives the same forces to the last bit, and its hash is the one told."""
    kept = re.search(r'href="data:application/json;base64,([^"]+)" download="model.json"', lift_text)[1]
    data = base64.b64decode(kept)
    record = embedded(lift_text)
    assert hashlib.sha256(data).hexdigest() == record["model_sha256"]
    assert record["model_sha256"].startswith(record["provenance"]["model"])
    assert data.decode() == record["model"]
    (tmp_path / "model.json").write_bytes(data)
    again = run(kt.read(tmp_path / "model.json"), record["run"])
    for case, forces in lift.forces.items():
        np.testing.assert_array_equal(again.forces[case].member_force, forces.member_force)
    listed = re.search(r'<pre class="model[^"]*"[^>]*><code>(.*?)</code></pre>', lift_text, re.DOTALL)[1]
    (tmp_path / "model.yaml").write_text(html.unescape(listed))
    assert kt.read(tmp_path / "model.yaml") == lift.model


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_model_changed_behind_the_run_is_found(tmp_path):
    run(fourbar(), out=tmp_path / "run")
    found = report.document_page(load(tmp_path / "run")).html
    assert "unchanged" in Page(found).cells
    text = (tmp_path / "run" / "model.json").read_text()
    (tmp_path / "run" / "model.json").write_text(text.replace("0.02", "0.03", 1))
    found = report.document_page(load(tmp_path / "run")).html
    assert "not the one that was run" in Page(found).cells


EVIL = "<script>alert(1)</script><img src=x onerror=alert(2)>\"'&</title></style>\\"


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_names_and_titles_stay_text():
    model = fourbar(title=EVIL)
    bars = {f"<b>{name}&'\"": bar for name, bar in model.bars.items()}
    evil = model.with_(bars=bars, drives={"motor": kt.AngleDrive("<b>crank&'\"")})
    text = report.document_page(run(evil), date=EVIL, view=EVIL).html
    page = Page(text)
    assert EVIL in page.words
    assert "<b>crank&'\"" in page.cells
    assert not {"img", "i"} & page.tags
    assert len(re.findall(r"<script", text)) == 1
    assert embedded(text)["title"] == EVIL
    style = re.search(r"<style>(.*?)</style>", text, re.DOTALL)[1]
    assert "<" not in style.replace("max-width: 40rem", "")


def stopped(tmp_path) -> RunResult:
    def stop(done: int, total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(tripod(), out=tmp_path / "half", block=10, progress=stop)
    return load(tmp_path / "half")


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_an_interrupted_run_says_so_on_top(tmp_path):
    page = Page(text := report.document_page(stopped(tmp_path)).html)
    top = page.words[: page.words.index("Result")]
    assert "This run is not complete. It was interrupted. 10 of 41 samples are good" in top
    assert "kinetruss run --resume half" in top
    assert "(not complete)" in re.search(r"<title>(.*?)</title>", text)[1]
    assert "No limit was checked" in page.words  # utilisation is known at the end only
    assert "Not complete (10 of 41 samples)" in page.words
    assert "Strength was not checked" in page.words
    assert embedded(text)["whole"] is False
    assert str(tmp_path) not in text  # reports are mailed


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_a_run_that_ended_early_says_so_on_top():
    moves = kt.Quintic(moves={"LA": (1.0295630, 2.6)}, duration=1.0)
    done = run(tripod(runs={"lift": kt.Run(trajectory=moves, samples=41)}))
    assert not done.whole
    page = Page(text := report.document_page(done).html)
    top = page.words[: page.words.index("Result")]
    assert f"This run is not complete. {done.status.value} {done.good} of 41 samples are good" in top
    assert done.message in top
    assert "exceeded in the part that was computed" in page.words
    assert "∞" not in page.cells  # past Euler's load: the number is that of buckling, and words say why
    assert "exceeds Euler's load" in page.words
    assert "Infinity" in {one["utilisation"] for one in embedded(text)["strength"]}
    assert re.search(
        r"NOT COMPLETE", re.sub(r"\\([0-9a-f]+) ", lambda found: chr(int(found[1], 16)), text)
    )  # the foot of each page


def test_a_run_without_a_good_sample_can_be_told_of(lift):
    empty = {name: getattr(lift, name).with_(data=getattr(lift, name).data.isel(time=slice(0, 0))) for name in ("motion",)}
    none = RunResult(model=lift.model, name="lift", samples=41, status=kt.results.Status.NOT_CONVERGED, **empty)
    page = Page(report.document_page(none).html)
    assert "0 of 41 samples are good" in page.words
    assert "no good sample" in page.words
    assert "No limit was checked" in page.words


def test_lengths_are_measured_anew(lift):
    assert closure(lift)["error"] < 1e-12
    data = lift.motion.data.copy(deep=True)
    data["position"].loc[{"node": "T", "time": data.time[7]}] += np.array([0, 0, 1e-3])
    found = closure(RunResult(model=lift.model, name="lift", motion=lift.motion.with_(data=data), samples=41))
    leg = data["position"].isel(time=7).sel(node="T").values - np.array([0.5, 0, 0])
    assert found["time"] == data.time[7]
    assert found["error"] == pytest.approx(1e-3 * leg[2] / np.linalg.norm(leg), rel=0.1)


def test_mobility_is_decided_while_it_is_cheap():
    found = mobility_record(fourbar())
    assert (found["degrees_of_freedom"], found["drives"], found["undriven"]) == (1, 1, 0)
    many = {f"N{k}": (float(k), 0.0) for k in range(301)}
    assert mobility_record(kt.Model(nodes=many, fixed=tuple(many))) is None


@pytest.mark.slow
def test_the_same_run_gives_the_same_text(lift, lift_text):
    assert report.document_page(lift).html == lift_text


@pytest.mark.slow
@pytest.mark.usefixtures("undrawn")
def test_the_view_is_a_frame_of_its_own_and_paper_has_a_picture(lift):
    view = '<!doctype html><title>x</title><p>"quoted"</p>'
    text = report.document_page(lift, view=view).html
    page = Page(text)
    assert 'sandbox="allow-scripts"' in text
    assert element("i", x=view)[4:-5].replace("x=", "srcdoc=", 1) in text
    assert "iframe" in page.tags
    assert re.search(r'</iframe>.*<figure class="picture" id="picture-1">', text, re.DOTALL)


@pytest.mark.parametrize(
    ("record", "words"),
    [
        (kt.Material(E=71e9, density=2711.5, yield_strength=240e6), "E 71 GPa, density 2711.5 kg/m³, yield strength 240 MPa"),
        (kt.NodalForce(node="T", force=(30.0, 0, 0)), "node T, force [30, 0, 0] N"),
        (kt.Quintic(moves={"LA": (1.0, 1.25)}, duration=2.0), "quintic, moves LA: [1, 1.25], duration 2 s"),
        (kt.LoadCase(loads={"push": 2.0}), "loads push: 2"),
    ],
)
def test_records_in_words_have_units(record, words):
    assert worded(record) == words


def widths(text: str) -> dict[str, tuple[float, float]]:
    found = re.findall(r'<rect class="(\w+)" x="([\d.]+)" y="\d" width="([\d.]+)"', text)
    return {kind: (float(x), float(width)) for kind, x, width in found}


@given(low=st.floats(-1e4, 1e4), reach=st.floats(0, 1e4))
def test_span_bars_lie_where_the_numbers_are(low, reach):
    high = low + reach
    found = widths(span_bar(low, high, -2e4, 2e4))
    place = {key: 100 * (value + 2e4) / 4e4 for key, value in (("low", low), ("high", high))}
    assert ("compression" in found, "tension" in found) == (low < 0, high > 0)
    for kind, begin, end in (
        ("compression", place["low"], min(place["high"], 50)),
        ("tension", max(place["low"], 50), place["high"]),
    ):
        if kind in found:
            x, width = found[kind]
            assert x == pytest.approx(begin, abs=0.61)
            assert x + width == pytest.approx(end, abs=0.61)
    assert all(0 <= x <= 100 for x, _ in found.values())


def test_bars_of_utilisation():
    assert widths(bar(0.25))["used"] == (0, 25)
    assert "over" not in widths(bar(1.0))
    beyond = widths(bar(float("inf"), 1.5))
    assert beyond["over"] == (0, 100)
    assert beyond["limit"][0] == pytest.approx(100 / 1.5 - 1, abs=0.01)
    rows = [{"utilisation": 0.3}, {"utilisation": 1.2}]
    one, other = (widths(drawn) for drawn in used_columns(rows)[0].values(rows))
    assert one["limit"] == other["limit"]  # one scale in one table
    assert other["over"][1] == pytest.approx(4 * one["used"][1], abs=0.02)


def test_round_off_is_no_utilisation():
    row = {"utilisation": 4.7e-17, "margin": 2.1e16}
    assert (share_of(row["utilisation"]), margin_of(row)) == ("0 %", "-")
    assert (share_of("Infinity"), share_of(None), share_of(0.25)) == ("∞", "-", "25 %")
    assert margin_of({"utilisation": 0.25, "margin": 3.0}) == "3.00"
    at_limit = {"utilisation": 1 + 8e-15, "margin": -8e-15}  # held there by an amplifier
    assert (is_over(at_limit), margin_of(at_limit), is_over({"utilisation": 1 + 1e-6})) == (False, "0.00", True)


def test_tables_hold_numbers_to_the_right():
    text = Table(("name", "force"), [("<M1>", "3 N")], "t", "note").html()
    assert '<td class="word">&lt;M1&gt;</td><td class="number">3 N</td>' in text
    assert '<p class="note">note</p>' in text


@pytest.mark.slow
@settings(max_examples=25)
@given(st.integers(0, 2**32 - 1))
def test_long_curves_keep_every_peak(seed):
    rng = np.random.default_rng(seed)
    time = np.linspace(0.0, 1.0, FINE + 1 + int(rng.integers(5000)))
    curve, rest = rng.normal(size=(2, len(time)))
    peak = int(rng.integers(len(time)))
    curve[peak] = 99.0
    panel = Panel(quantity="force", unit="N", lines={"M": curve}, dashed={"M": rest}, band=(curve - 1, curve + 1))
    found = thinned(Histories(name="f", title="", time=time, panels=(panel,)))
    (one,) = found.panels
    assert len(one.lines["M"]) == len(one.dashed["M"]) == len(one.times["M"]) < len(time)
    assert len(found.time) == len(one.band[0]) == len(one.band[1])
    assert one.times["M"][one.lines["M"].argmax()] == time[peak]
    assert (one.dashed["M"].min(), one.dashed["M"].max()) == (rest.min(), rest.max())
    assert one.band[1].max() == 100.0
    assert set(zip(one.times["M"], one.lines["M"], strict=True)) <= set(zip(time, curve, strict=True))
