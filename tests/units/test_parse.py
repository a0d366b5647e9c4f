"""Text with units: a strict grammar, and messages that say the mend."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from kinetruss.errors import UnitError
from kinetruss.limits import LARGEST
from kinetruss.units import QUANTITIES, Tagged, parse, unit_of

# text, quantity, value; conversions from NIST SP 811 (2008), appendix B
GOOD = [
    ("36 in", "length", 0.9144),
    ("1 ft", "length", 0.3048),
    ("254 mm", "length", 0.254),
    ("5mm", "length", 0.005),
    (" 5  mm ", "length", 0.005),
    ("+.5 m", "length", 0.5),
    ("5. m", "length", 5.0),
    ("1e3", "length", 1000.0),
    ("1E-3 km", "length", 1.0),
    ("10 lb", "mass", 4.5359237),
    ("1 t", "mass", 1000.0),
    ("1 lbf", "force", 4.4482216152605),
    ("2.5 kN", "force", 2500.0),
    ("1 kg m/s^2", "force", 1.0),
    ("1 kg*m/s**2", "force", 1.0),
    ("1 kg·m·s^-2", "force", 1.0),
    ("1 psi", "stress", 6894.757293168361),
    ("71 GPa", "stress", 71e9),
    ("1 lbf/in^2", "stress", 6894.757293168361),
    ("0.1 lb/in^3", "density", 2767.990471),
    ("10 deg", "angle", math.pi / 18),
    ("1 rev", "angle", 2 * math.pi),
    ("60 rpm", "angular rate", 2 * math.pi),
    ("1 rev/min", "angular rate", 2 * math.pi / 60),
    ("0.0625 in/rev", "lead", 0.0625 * 0.0254 / (2 * math.pi)),
    ("1 N m", "torque", 1.0),
    ("40 mN m/A", "torque constant", 0.04),
    ("1 V s/rad", "back-emf constant", 1.0),
    ("1 V s", "back-emf constant", 1.0),
    ("2 ohm", "resistance", 2.0),
    ("3 mH", "inductance", 0.003),
    ("3 cm^2", "area", 3e-4),
    ("3 cm²", "area", 3e-4),
    ("87.3 %", "factor", 0.873),
    ("5 uN", "force", 5e-6),
    ("5 µN", "force", 5e-6),  # U+00B5
    ("5 μN", "force", 5e-6),  # U+03BC
    ("5 µm/s²", "acceleration", 5e-6),
    ("1 cm^4", "second moment of area", 1e-8),
    ("1 min", "time", 60.0),
    ("0.5", "number", 0.5),
    (7, "number", 7.0),
    (np.float32(0.5), "length", 0.5),
    (np.int64(3), "length", 3.0),
]


@pytest.mark.parametrize(("text", "quantity", "value"), GOOD, ids=repr)
def test_good(text, quantity, value):
    assert parse(text, quantity) == pytest.approx(value, rel=1e-9, abs=0)


def si(unit):
    """The mend that most messages end with."""
    return f"Write for example '1.5 {unit}', or a bare number in SI."


# text, quantity, message (all of it)
BAD = [
    ("no", "length", f"'no' is not a length: no number in front. {si('m')}"),
    (
        "12:30",
        "time",
        f"'12:30' is not a time: ':30' is not a unit known here. {si('s')}",
    ),
    ("", "mass", f"'' is not a mass: no number in front. {si('kg')}"),
    ("m", "length", f"'m' is not a length: no number in front. {si('m')}"),
    ("- 5 m", "length", f"'- 5 m' is not a length: no number in front. {si('m')}"),
    ("nan", "length", "'nan' is not a finite length. Give a finite number."),
    (".inf", "force", "'.inf' is not a finite force. Give a finite number."),
    ("-Infinity m", "length", "'-Infinity m' is not a finite length. Give a finite number."),
    (math.nan, "length", "nan is not a finite length. Give a finite number."),
    ("1e999 m", "length", "'1e999 m' is not a finite length. Give a finite number."),
    ("1e308 km", "length", "'1e308 km' is not a finite length. Give a finite number."),
    ("1,5 m", "length", "'1,5 m' is not a length: a comma in the number. Write a decimal point: '1.5 m'."),
    (
        "1,000.5 m",
        "length",
        "'1,000.5 m' is not a length: a comma in the number. Write a decimal point, and no commas between thousands.",
    ),
    ("5 lb", "force", "'5 lb' is not a force (N). Write lbf for a force: lb is a mass."),
    ("5 lbf", "mass", "'5 lbf' is not a mass (kg). Write lb for a mass: lbf is a force."),
    ("5 lb/in^2", "stress", "'5 lb/in^2' is not a stress (Pa). Write lbf/in^2 for a stress: lb is a mass."),
    ("0.1 lbf/in^3", "density", "'0.1 lbf/in^3' is not a density (kg/m^3). Write lb/in^3 for a density: lbf is a force."),
    ("5 kg", "area", f"'5 kg' is not an area (m^2). {si('m^2')}"),
    ("300 mm", "factor", "'300 mm' is not a factor without unit. Write it in SI units (m), as a bare number: '0.3'."),
    (
        "5 mm/rev",
        "factor",
        "'5 mm/rev' is not a factor without unit. Write it in SI units (m/rad), as a bare number: '0.000795774715459'.",
    ),
    ("5 m", "number", "'5 m' is not a number without unit. Write a bare number, e.g. 1.5."),
    ("10 deg", "length", f"'10 deg' is not a length (m). {si('m')}"),
    ("10 kg", "coordinate", f"'10 kg' is not a coordinate (m, or rad). {si('m')}"),
    ("10 Hz", "angular rate", "'10 Hz' is not an angular rate (rad/s). Write rad/s, deg/s, rev/s or rpm."),
    ("1 mm", "lead", "'1 mm' is not a lead (m/rad). Write for example '5 mm/rev'; a bare number is in m/rad."),
    ("5 inches", "length", "'5 inches' is not a length: 'inches' is not a unit known here. Write 'in'."),
    ("5 Nm", "torque", "'5 Nm' is not a torque: 'Nm' is not a unit known here. Write 'N m'."),
    ("5 KN", "force", "'5 KN' is not a force: 'KN' is not a unit known here. Write 'kN'."),
    ("90°", "angle", "'90°' is not an angle: '°' is not a unit known here. Write 'deg'."),
    ("5 Mm", "length", "'5 Mm' is not a length: 'Mm' is not a unit known here. Write 'mm'."),
    ("5 NM", "torque", "'5 NM' is not a torque: 'NM' is not a unit known here. Write 'N m'."),
    ("5 µl", "length", f"'5 µl' is not a length: 'µl' is not a unit known here. {si('m')}"),
    ("5 m²²", "length", f"'5 m²²' is not a length: 'm²²' is not a unit known here. {si('m')}"),
    ("5 %", "length", f"'5 %' is not a length (m). {si('m')}"),
    (
        "5 foo",
        "force",
        f"'5 foo' is not a force: 'foo' is not a unit known here. {si('N')}",
    ),
    ("5 m/", "length", f"'5 m/' is not a length: a unit is due at its end. {si('m')}"),
    (
        "5 m//s",
        "speed",
        f"'5 m//s' is not a speed: '/' stands where a unit is due. {si('m/s')}",
    ),
    (
        "1/2 in",
        "length",
        f"'1/2 in' is not a length: '/' stands where a unit is due. {si('m')}",
    ),
    (
        "5 ft 3 in",
        "length",
        f"'5 ft 3 in' is not a length: '3' is not a unit known here. {si('m')}",
    ),
    ("1_000", "number", "'1_000' is not a number: '_000' is not a unit known here. Write a bare number, e.g. 1.5."),
    ("٣ m", "length", f"'٣ m' is not a length: no number in front. {si('m')}"),
    (True, "length", f"True is not a length. {si('m')}"),
    (None, "mass", f"None is not a mass. {si('kg')}"),
    ([1], "length", f"[1] is not a length. {si('m')}"),
]


@pytest.mark.parametrize(("text", "quantity", "message"), BAD, ids=repr)
def test_bad(text, quantity, message):
    with pytest.raises(UnitError) as caught:
        parse(text, quantity)
    assert str(caught.value) == message


def test_number_too_long_to_show():
    with pytest.raises(UnitError, match=r"^int too long to show is not a finite mass\. Give a finite number\.$"):
        parse(10**5000, "mass")


def test_long_text_is_cut_and_costs_nothing():
    with pytest.raises(UnitError) as caught:
        parse("1 " + " " * 1_000_000 + "m", "length")
    assert len(str(caught.value)) < 200


@given(st.text(), st.sampled_from(sorted(QUANTITIES)))
def test_any_text_is_read_or_refused(text, quantity):
    try:
        assert math.isfinite(parse(text, quantity))
    except UnitError as error:
        assert str(error).endswith(".")


@given(st.floats(-LARGEST, LARGEST), st.sampled_from(sorted(QUANTITIES)))
def test_si_text_is_exact(value, quantity):
    assert parse(f"{value!r} {unit_of(quantity)}", quantity) == value
    assert parse(value, quantity) == value


@given(
    st.floats(LARGEST, exclude_min=True, allow_infinity=False), st.sampled_from([1, -1]), st.sampled_from(sorted(QUANTITIES))
)
def test_numbers_whose_powers_overflow_are_refused(size, sign, quantity):
    for value in (sign * size, f"{sign * size!r} {unit_of(quantity)}", Tagged(sign * size, "length")):
        with pytest.raises(UnitError, match="beyond what is computed with"):
            parse(value, quantity)


def test_coordinates_remember_what_they_are():
    assert parse("10 deg", "coordinate").quantity == "angle"
    assert parse("1 mm", "coordinate").quantity == "length"
    assert parse("1 mm/s", "rate").quantity == "length"
    assert parse(0.5, "coordinate").quantity is None
    assert parse(Tagged(0.5, "angle"), "coordinate").quantity == "angle"
