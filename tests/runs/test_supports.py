"""Runs, free bodies and reports of structures on springs: of the user's own, and of supports, which are told as such."""

import pytest

import kinetruss as kt

TRUSS = {
    "nodes": {"A": (0, 0), "B": (2, 0), "C": (1, 1)},
    "bars": {"b": ("A", "B"), "c": ("A", "C"), "d": ("B", "C")},
    "section": kt.Rectangle(width=0.1, height=0.1),
    "material": "steel_s235",
    "loads": {"P": kt.NodalForce(node="C", force=(0, -1e3))},
    "runs": {"rest": kt.Run(analysis="statics.linear")},
}
COORDINATE = kt.CoordinateDrive(node="B", axis="y")
ON = {
    "spring": {"fixed": ["A"], "springs": {"s": kt.Spring(coordinate=COORDINATE, stiffness=1e6)}},
    "support": {"supports": {"A": kt.Support(x="held", y="held"), "B": kt.Support(y=1e6)}},
    "coupling": {"fixed": ["A"], "couplings": {"s": kt.Coupling(terms=((COORDINATE, 1.0),))}},
    "turned": {"fixed": ["A"], "supports": {"B": kt.Support(y="held", along="C")}},
}


@pytest.mark.parametrize("kind", ON)
def test_free_body_of_a_node_in_a_run_of_linear_statics(kind):
    """All forces on the node are there, and add up to nil; no inner name is in their sources."""
    model = kt.Model(**TRUSS, **ON[kind])
    run = kt.run(model)
    (forces,) = run.forces.values()
    body = kt.dynamics.free_body(model, run.motion, forces, node="B")
    total = sum(term.force for term in body.bodies[0].terms)
    assert total == pytest.approx([0.0, 0.0], abs=1e-9)
    sources = {term.source for term in body.bodies[0].terms}
    word = {"spring": "spring s", "coupling": "coupling s"}.get(kind, "support B")
    assert word in sources
    assert not any("support." in source for source in sources)


def test_a_summary_and_a_report_list_supports_once():
    """Of springs those of the user; supports with what they hold, and their reaction."""
    model = kt.Model(**TRUSS, **ON["support"])
    run = kt.run(model)
    assert "Springs" not in str(kt.report.summary(run))
    (forces,) = run.forces.values()
    assert list(forces.reaction.support.values) == ["A", "B"]
    assert forces.reaction.sel(support="B").values[0] == pytest.approx([0.0, 500.0], abs=1e-9)
    assert kt.model.support_words(model.supports["B"]) == "y 1 MN/m"
