"""Numbers for people: the rules, and the same text from Python and from the page's JavaScript."""

import json
import math
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, strategies as st

from kinetruss.display import instant, margin, number, palettes, quantity, round_up, scale, ticks
from kinetruss.display.numbers import DIGITS, FLOORS, UNITS, column
from kinetruss.display.palettes import script
from kinetruss.units import EITHER, QUANTITIES, parse, unit_of

PAGE = Path(__file__).parents[2] / "viewer-src" / "src"
CALLS = """
import {{ column, instant, margin, number, quantity, roundUp, scale, ticks }} from "{page}/format.js";
import {{ colourOf, limitsOf }} from "{page}/colour.js";
import {{ readFileSync }} from "node:fs";
const given = JSON.parse(readFileSync(0, "utf8"));
const found = {{
  numbers: given.numbers.map(([value, digits]) => number(value, digits)),
  quantities: given.quantities.map(([value, unit]) => quantity(value, unit)),
  scales: given.quantities.map(([value, unit]) => scale(value, unit)),
  instants: given.quantities.map(([value]) => instant(value)),
  margins: given.quantities.map(([value]) => margin(value)),
  ends: given.quantities.map(([value]) => roundUp(Math.abs(value))),
  ticks: given.quantities.map(([value], k) => (value > 0 ? ticks(k % 2 ? -0.37 * value : 0, value) : [0])),
  columns: given.columns.map(([values, unit]) => column(values, unit)),
  limits: given.colours.map(([kind, values]) => limitsOf(kind, [[Math.min(...values), Math.max(...values)]])),
  colours: given.colours.map(([kind, values, limits]) => values.map((value) => colourOf(kind, value, limits))),
}};
process.stdout.write(JSON.stringify(found));
"""


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (0.0284, "A", "28.4 mA"),
        (0.012, "m/s", "12 mm/s"),
        (0.5, "V", "500 mV"),
        (2500.0, "kg", "2.5 t"),
        (0.0284, "kg", "28.4 g"),
        (999.99999999999, "N", "1 kN"),
        (1234.0, "m", "1234 m"),
        (-12.5e6, "Pa", "-12.5 MPa"),
        (-0.0, "N", "0 N"),
        (-3e-14, "N", "0 N"),
        (4.9e-14, "m^4", "4.9e-14 m⁴"),
        (0.8749, "%", "87.5 %"),
        (12.3, "%", "1230 %"),
        (math.pi / 6, "rad", "30 deg"),
        (2.0, "rad/s", "2 rad/s"),
        (9.81, "m/s^2", "9.81 m/s²"),
        (math.nan, "N", "-"),
        (math.inf, "%", "∞"),
    ],
)
def test_units_are_those_that_engineers_write(value, unit, text):
    assert quantity(value, unit) == text


@pytest.mark.parametrize("unit", UNITS)
def test_a_shown_value_is_the_value_to_its_last_digit(unit):
    for value in np.geomspace(1e-3, 1e7, 301) * np.resize([1, -1], 301):
        factor, name = scale(value, unit)
        shown, _, rest = quantity(value, unit, 4).partition(" ")
        assert rest == name
        assert float(shown) / factor == pytest.approx(value, rel=5.1e-4)
        assert name in {one for _, one in UNITS[unit]}
        if unit not in ("rad", "%"):
            assert abs(float(shown)) < 1000.5 or name == UNITS[unit][-1][1]


def units_of(name):
    """SI units in which the values of a quantity are shown."""
    texts = [one for one in EITHER.get(name, unit_of(name)).split(", or ") if "what is measured" not in one]
    return [*texts, "%"] if texts == [""] else texts


@pytest.mark.parametrize("name", QUANTITIES)
@given(value=st.floats(1e-15, 1e15), sign=st.sampled_from([1, -1]), digits=st.sampled_from([0, 4, 6, 9]))
def test_what_is_shown_is_read_back(name, value, sign, digits):
    for unit in units_of(name):
        text = quantity(sign * value, unit, digits)
        read = parse(text.replace("µ", "u"), name)
        assert read == parse(text, name) == parse(text.replace("µ", "μ"), name)
        if text.startswith("0 ") or text == "0":
            assert unit in UNITS
            assert value < FLOORS.get(unit, FLOORS[""])
        else:
            assert read == pytest.approx(sign * value, rel=0.51 * 10.0 ** (1 - (digits or DIGITS.get(unit, DIGITS[""]))))


@pytest.mark.parametrize("unit", UNITS)
def test_every_name_of_a_unit_is_read(unit):
    for factor, name in UNITS[unit]:
        assert parse(f"2 {name}", "measure") == pytest.approx(2 / factor, rel=1e-15)
    texts, name = column([0.0, 2.5], unit)
    assert parse(f"{texts[0]} {name}", "measure") == 0.0


def test_ties_go_away_from_zero_and_times_stay_in_seconds():
    assert [number(one, 3) for one in (12.25, -12.25, 0.125, 9.9996)] == ["12.3", "-12.3", "0.125", "10"]
    assert [instant(one) for one in (0.0005, 12.3456, None, math.inf)] == ["0.0005 s", "12.35 s", "-", "-"]


def test_the_page_has_the_tables_of_the_package():
    assert (PAGE / "display.js").read_text("utf-8") == script(), "make viewer writes the file anew"


@pytest.mark.skipif(shutil.which("node") is None, reason="no node to run the page's functions")
def test_the_page_writes_and_colours_as_python_does(tmp_path):
    rng = np.random.default_rng(4)
    values = [float(one) for one in 10.0 ** rng.uniform(-16, 13, 4000) * rng.choice([-1, 1], 4000)]
    values += [k / 2**n for k in range(-65, 66) for n in range(8)]  # ties in binary
    values += [
        sign * part * 10.0**power for power in range(-15, 13) for part in (1, 9.9996, 99.995, 0.99999) for sign in (1, -1)
    ]
    names = [*UNITS, "rad/s", "kg m²", ""]
    given = {
        "numbers": [(value, digits) for digits in (2, 3, 4, 6, 9) for value in values],
        "quantities": [(value, names[k % len(names)]) for k, value in enumerate(values * 3)],
        "columns": [
            ([float(one) for one in rng.normal(size=7) * 10.0 ** rng.uniform(-14, 9) * np.resize([1, 1e-3, 1e-14], 7)], unit)
            for unit in names
            for _ in range(40)
        ],
        "colours": [
            (kind, shown, [-high if kind == "diverging" else 0.0, high])
            for kind in ("diverging", "sequential", "capacity", "margin")
            for high in (0.3, 1.0, 250.0)
            for shown in [[float(one) for one in np.linspace(-high if kind == "diverging" else 0.0, 1.2 * high, 41)]]
        ],
    }
    program = tmp_path / "calls.mjs"
    program.write_text(CALLS.format(page=PAGE.as_posix()))
    (tmp_path / "package.json").write_text('{"type": "module"}')
    done = subprocess.run(["node", str(program)], input=json.dumps(given), capture_output=True, text=True, check=True)
    found = json.loads(done.stdout)
    assert found["numbers"] == [number(value, digits) for value, digits in given["numbers"]]
    assert found["quantities"] == [quantity(value, unit) for value, unit in given["quantities"]]
    assert found["scales"] == [list(scale(value, unit)) for value, unit in given["quantities"]]
    assert found["margins"] == [margin(value) for value, _ in given["quantities"]]
    assert found["ends"] == [round_up(abs(value)) for value, _ in given["quantities"]]
    assert found["ticks"] == [
        ticks(-0.37 * value if k % 2 else 0.0, value) if value > 0 else [0.0]
        for k, (value, _) in enumerate(given["quantities"])
    ]
    assert found["columns"] == [list(column(values, unit)) for values, unit in given["columns"]]
    assert found["instants"] == [instant(value) for value, _ in given["quantities"]]
    for (kind, shown, limits), page, ends in zip(given["colours"], found["colours"], found["limits"], strict=True):
        assert ends == list(palettes.limits_of(kind, np.array(shown)))
        assert np.abs(np.array(page) - palettes.colours_of(kind, np.array(shown), limits)).max() <= 0.5 + 1e-9
