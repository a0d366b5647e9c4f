"""Node histories from elsewhere: with or without the fixed nodes, refused where these stand elsewhere than in the model."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import kinetruss as kt

BAY = kt.library.vgt.double_octahedral()
MOTION = kt.kinematics.follow(BAY, kt.library.vgt.slew(beta=(-0.1, 0.1)), samples=5)
FIXED = ("N1", "N2", "N3")


def table(path, names, motion=MOTION, shift=None, digits="%.17g", kinds=("", "v", "a")):
    head = "t," + ",".join(f"{n}.{p}{a}" for p in kinds for n in names for a in "xyz")
    parts = {"": motion.position, "v": motion.velocity, "a": motion.acceleration}
    columns = [motion.position.time.values]
    for kind in kinds:
        values = parts[kind].sel(node=list(names)).values.copy()
        if kind == "" and shift is not None:
            values[:, names.index(shift[0]), "xyz".index(shift[1])] += shift[2]
        columns.append(values.reshape(len(values), -1))
    np.savetxt(path, np.column_stack(columns), delimiter=",", header=head, comments="", fmt=digits)
    return path


@pytest.mark.slow
@settings(max_examples=12, deadline=None)
@given(st.sets(st.sampled_from(FIXED)), st.randoms(use_true_random=False))
def test_fixed_nodes_may_stand_in_the_table_or_not(tmp_path_factory, left_out, random):
    names = [name for name in BAY.nodes if name not in left_out]
    random.shuffle(names)
    got = kt.kinematics.from_csv(BAY, table(tmp_path_factory.mktemp("t") / "all.csv", names))
    np.testing.assert_allclose(got.position.values, MOTION.position.values, atol=1e-13)
    assert got.message == ""


@pytest.mark.slow
@pytest.mark.parametrize("shift", [("N1", "x", 0.01), ("N3", "z", -1.0)])
def test_a_fixed_node_elsewhere_is_named_everywhere(tmp_path, shift):
    path = table(tmp_path / "all.csv", list(BAY.nodes), shift=shift)
    said = rf"{shift[0]}\.{shift[1]} is .* the model holds it at"
    with pytest.raises(kt.ModelError, match=said):
        kt.kinematics.from_csv(BAY, path)
    model = BAY.with_(runs={"given": kt.Run(analysis="dynamics.inverse", motion=str(path))})
    (fault,) = kt.check(model)
    assert f"{shift[0]}.{shift[1]} is " in str(fault) and fault.path == ("runs", "given", "motion")
    with pytest.raises(kt.ModelError, match=said):
        kt.run(model, "given")


def test_rounded_tables_agree(tmp_path):
    got = kt.kinematics.from_csv(BAY, table(tmp_path / "all.csv", list(BAY.nodes), digits="%.5f"))
    assert "Rigid bars change" in got.message and "is fixed at" in got.message


def test_missing_columns_are_said_at_once(tmp_path):
    path = table(tmp_path / "some.csv", ["N4", "N5"], kinds=("", "v"))
    with pytest.raises(kt.ModelError) as caught:
        kt.kinematics.from_csv(BAY, path)
    assert (
        len(caught.value.faults) == 2 and "no accelerations" in str(caught.value) and "no columns for N6" in str(caught.value)
    )
    model = BAY.with_(runs={"given": kt.Run(analysis="dynamics.inverse", motion=str(path))})
    assert len(kt.check(model)) == 2
