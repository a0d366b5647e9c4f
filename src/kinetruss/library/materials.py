"""Materials with the source of every value. `MATERIALS` holds them by the names used in model files."""

from __future__ import annotations

from kinetruss.late import listed
from kinetruss.model import Material

__all__ = [
    "ALUMINIUM_2024_T3",
    "ALUMINIUM_6061_T6",
    "ALUMINIUM_6082_T6",
    "ALUMINIUM_7020_T6",
    "ALUMINIUM_7075_T6",
    "ALUMINIUM_LACY",
    "INVAR_36",
    "MAGNESIUM_AZ31B_H24",
    "MATERIALS",
    "STEEL_1_4301",
    "STEEL_4130",
    "STEEL_S235",
    "STEEL_S275",
    "STEEL_S355",
    "TITANIUM_6AL4V",
]

__dir__ = listed(__name__)

KSI = 6894757.293168361  # Pa
FAHRENHEIT = 1.8  # 1/K of 1/F
POUND_PER_CUBIC_INCH = 27679.904710191  # kg/m^3

_EN_STEEL = "E, Poisson's ratio, thermal expansion: EN 1993-1-1:2005, 3.2.6; density: EN 1991-1-1:2002, table A.4 (78.5 kN/m^3)"
_EN_ALUMINIUM = "E, Poisson's ratio, density, thermal expansion: EN 1999-1-1:2007, 3.2.5"
_MIL = "MIL-HDBK-5J (2003)"
_ALUMINUM = "thermal expansion from 68 to 212 F: The Aluminum Association, Aluminum Standards and Data (2003), table 2.1"

STEEL_S235 = Material(
    E=210e9,
    density=7850.0,
    yield_strength=235e6,
    poisson=0.3,
    thermal_expansion=12e-6,
    source=f"Yield strength: EN 10025-2:2004, table 7, up to 16 mm; {_EN_STEEL}",
)
STEEL_S275 = Material(
    E=210e9,
    density=7850.0,
    yield_strength=275e6,
    poisson=0.3,
    thermal_expansion=12e-6,
    source=f"Yield strength: EN 10025-2:2004, table 7, up to 16 mm; {_EN_STEEL}",
)
STEEL_S355 = Material(
    E=210e9,
    density=7850.0,
    yield_strength=355e6,
    poisson=0.3,
    thermal_expansion=12e-6,
    source=f"Yield strength: EN 10025-2:2004, table 7, up to 16 mm; {_EN_STEEL}",
)
STEEL_1_4301 = Material(
    E=200e9,
    density=7900.0,
    yield_strength=210e6,
    poisson=0.3,
    thermal_expansion=16e-6,
    source="X5CrNi18-10: yield strength, hot-rolled plate up to 75 mm: EN 1993-1-4:2006, table 2.1; E, Poisson's ratio: "
    "2.1.3 there; density: EN 10088-1:2005, table E.1; thermal expansion: there too",
)
STEEL_4130 = Material(
    E=29.0e3 * KSI,
    density=0.283 * POUND_PER_CUBIC_INCH,
    yield_strength=75 * KSI,
    poisson=0.32,
    source=f"{_MIL}, table 2.3.1.0(c1): AISI 4130, normalised sheet and tubing up to 0.187 in, 75 ksi",
)
ALUMINIUM_6061_T6 = Material(
    E=70e9,
    density=2700.0,
    yield_strength=240e6,
    poisson=0.3,
    thermal_expansion=23e-6,
    source=f"Proof strength: EN 1999-1-1:2007, table 3.2b, extruded or drawn up to 20 mm; {_EN_ALUMINIUM}",
)
ALUMINIUM_6082_T6 = Material(
    E=70e9,
    density=2700.0,
    yield_strength=250e6,
    poisson=0.3,
    thermal_expansion=23e-6,
    source=f"Proof strength: EN 1999-1-1:2007, table 3.2b, extruded up to 5 mm; {_EN_ALUMINIUM}",
)
ALUMINIUM_7020_T6 = Material(
    E=70e9,
    density=2700.0,
    yield_strength=290e6,
    poisson=0.3,
    thermal_expansion=23e-6,
    source=f"Proof strength: EN 1999-1-1:2007, table 3.2b, extruded up to 15 mm; {_EN_ALUMINIUM}",
)
ALUMINIUM_2024_T3 = Material(
    E=10.5e3 * KSI,
    density=0.100 * POUND_PER_CUBIC_INCH,
    yield_strength=47 * KSI,
    poisson=0.33,
    thermal_expansion=12.9e-6 * FAHRENHEIT,
    source=f"{_MIL}, table 3.2.3.0(b1): bare sheet 0.010 to 0.128 in, along the grain, A-basis, 47 ksi; {_ALUMINUM}",
)
ALUMINIUM_7075_T6 = Material(
    E=10.3e3 * KSI,
    density=0.101 * POUND_PER_CUBIC_INCH,
    yield_strength=70 * KSI,
    poisson=0.33,
    thermal_expansion=13.1e-6 * FAHRENHEIT,
    source=f"{_MIL}, table 3.7.6.0(b1): bare sheet 0.040 to 0.125 in, along the grain, A-basis, 70 ksi; {_ALUMINUM}",
)
ALUMINIUM_LACY = Material(
    E=71e9,
    density=2711.5,
    poisson=0.33,
    source="E, density: D. T. Lacy, MSc thesis, Virginia Tech (1991), tables 3.1 and 5.1 (which give no yield strength); "
    "Poisson's ratio: MIL-HDBK-5J (2003), table 3.6.2.0, of 6061",
)
TITANIUM_6AL4V = Material(
    E=16.0e3 * KSI,
    density=0.160 * POUND_PER_CUBIC_INCH,
    yield_strength=120 * KSI,
    poisson=0.31,
    source=f"Yield strength: SAE AMS 4928, annealed bar, 120 ksi; E, density, Poisson's ratio: {_MIL}, table 5.4.1.0",
)
MAGNESIUM_AZ31B_H24 = Material(
    E=6.5e3 * KSI,
    density=0.0639 * POUND_PER_CUBIC_INCH,
    yield_strength=29 * KSI,
    poisson=0.35,
    source=f"{_MIL}, table 4.2.1.0(b): sheet 0.016 to 0.249 in, along the grain, 29 ksi",
)
INVAR_36 = Material(
    E=20.5e3 * KSI,
    density=0.291 * POUND_PER_CUBIC_INCH,
    yield_strength=230e6,
    poisson=0.29,
    thermal_expansion=1.3e-6,
    source="Carpenter Technology, CarTech Invar 36 data sheet (2004): 0.291 lb/in^3, 20.5e6 psi; least yield strength of the "
    "annealed range 230 to 350 MPa; thermal expansion from 25 to 93 C, annealed: 1.30e-6 1/K there",
)

MATERIALS: dict[str, Material] = {
    "aluminium_2024_t3": ALUMINIUM_2024_T3,
    "aluminium_6061_t6": ALUMINIUM_6061_T6,
    "aluminium_6082_t6": ALUMINIUM_6082_T6,
    "aluminium_7020_t6": ALUMINIUM_7020_T6,
    "aluminium_7075_t6": ALUMINIUM_7075_T6,
    "aluminium_lacy": ALUMINIUM_LACY,
    "invar_36": INVAR_36,
    "magnesium_az31b_h24": MAGNESIUM_AZ31B_H24,
    "steel_1_4301": STEEL_1_4301,
    "steel_4130": STEEL_4130,
    "steel_s235": STEEL_S235,
    "steel_s275": STEEL_S275,
    "steel_s355": STEEL_S355,
    "titanium_6al4v": TITANIUM_6AL4V,
}
