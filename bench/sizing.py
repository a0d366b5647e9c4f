"""Time of sizing a double-octahedral truss (``--json`` for one object).

`kt.design.size` on a bay and on a chain of ten: five member groups a bay, a catalogue of 60 tubes, 500 samples of a slew about
both axes; the drives of every bay as well. The second of two calls counts (the first compiles or loads the kernels).
"""

from __future__ import annotations

import argparse
import json
import sys
import time

import kinetruss as kt

CASES = {"bay": 1, "chain of 10 bays": 10}
SAMPLES = 500
GROUPS = {
    "lower_longerons": ["M[1-6]"], "upper_longerons": ["M1[3-8]"], "battens": ["M19", "M2[01]"], "actuator_M7": ["M7"],
    "actuators_M9_M11": ["M9", "M11"],
}  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES), help="default: all")
    options = parser.parse_args()
    rows = [row(case, CASES[case]) for case in options.cases]
    if options.json:
        json.dump({"rows": rows}, sys.stdout, indent=2)
        sys.stdout.write("\n")
        return
    for one in rows:
        print(
            f"{one['case']:>18}: {one['seconds']:.2f} s, {one['iterations']} passes, "
            f"{one['mass_before']:.2f} kg -> {one['mass_after']:.2f} kg"
        )


def row(case: str, bays: int) -> dict[str, object]:
    """One sizing, timed."""
    model, mission = task(bays)
    for _ in range(2):
        start = time.perf_counter()
        sizing = kt.design.size(model, mission)
        seconds = time.perf_counter() - start
    return {
        "case": case, "seconds": seconds, "iterations": sizing.iterations, "mass_before": sizing.mass_before,
        "mass_after": sizing.mass_after,
    }  # fmt: skip


def task(bays: int) -> tuple[kt.Model, kt.Mission]:
    """A standing truss with 2 kg at every top node, before sizing all of one tube, and what it must carry."""
    model = kt.library.vgt.double_octahedral(
        bays=bays, payload_mass=2.0, material="aluminium_6061_t6", base_mass=1.0, screw="screw_lacy_spatial", gear="gear_lacy",
        motor="motor_lacy",
    )  # fmt: skip
    slew = kt.library.vgt.slew(bays, beta=("0 deg", f"{10 / bays} deg"), gamma=("0 deg", f"{10 / bays} deg"), duration=6.0)
    model = model.with_(runs={"slew": kt.Run(trajectory=slew, samples=SAMPLES)})
    groups = {
        f"{pose}.{name}" if bays > 1 else name: [f"{pose}.{member}" if bays > 1 else member for member in members]
        for pose in model.poses
        for name, members in GROUPS.items()
    }
    catalogues = {
        "tubes": "aluminium_tubes_inch", "screws": "trapezoidal_screws", "gears": "planetary_gears", "motors": "dc_motors_25v",
    }  # fmt: skip
    safety = {"yielding": 1.5, "buckling": 2.0}
    return model, kt.Mission(groups=groups, catalogues=catalogues, safety=safety, margin=1.2, self_locking=True)


if __name__ == "__main__":
    main()
