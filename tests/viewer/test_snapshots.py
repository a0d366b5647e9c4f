"""Scenes of a few samples, which drawings on paper are made of: the loads and the gravity of their instant and load case."""

from __future__ import annotations

import numpy as np
import pytest

import kinetruss as kt
from kinetruss import report, viewer
from kinetruss.errors import InputError
from kinetruss.report.document.figure import loaded
from kinetruss.viewer.scenes import snapshots


def swing(**more) -> kt.Model:
    """A braced square under a force that grows with time; in one load case it is twice as large, and without gravity."""
    return kt.Model(
        nodes={"A": (0, 0), "B": (1, 0), "C": (1, 1), "D": (0, 1)},
        fixed={"A": "xy", "D": "xy"},
        gravity=(0, -9.81),
        bars={"arm": kt.Bar(ends=("A", "B"), mass=2.0), "post": ("B", "C"), "top": ("D", "C"), "brace": ("D", "B")},
        loads={"gust": kt.NodalForce(node="C", times=(0.0, 10.0), forces=((0.0, 0.0), (100.0, 0.0)))},
        load_cases={"still": kt.LoadCase(loads={}), "orbit": kt.LoadCase(loads={"gust": 2.0}, gravity=(0.0, 0.0))},
        **more,
    )


def test_poses_at_rest_have_the_loads_of_their_instant_not_of_their_number():
    model = swing(section=kt.Tube(outer=0.03, inner=0.026), material=kt.library.materials.STEEL_S235)
    forces = kt.statics.at_poses(model, {"one": {}, "two": {}, "three": {}}, load_case="orbit", time=5.0)
    one = snapshots(forces, model=model, samples=[2])
    np.testing.assert_allclose(one.arrays["load_force"], [[[100.0, 0.0]]])
    assert one.header["largest_load"] == pytest.approx(100.0)
    page = viewer.scene(forces, model=model)
    np.testing.assert_allclose(page.arrays["load_force"], np.full((3, 1, 2), [100.0, 0.0]))


def test_an_equilibrium_has_the_loads_of_its_case_and_time():
    model = swing(section=kt.Tube(outer=0.03, inner=0.026), material=kt.library.materials.STEEL_S235)
    rest = kt.statics.equilibrium(model, load_case="orbit", time=4.0)
    for one in (snapshots(rest, model=model), viewer.scene(rest, model=model)):
        np.testing.assert_allclose(one.arrays["load_force"], [[[80.0, 0.0]]])
        assert one.header["gravity"] == [0.0, 0.0]


@pytest.mark.slow
def test_the_figure_of_a_report_has_the_gravity_of_its_load_case():
    section = {"section": kt.Tube(outer=0.03, inner=0.026), "material": kt.library.materials.STEEL_S235}
    run = kt.run(swing(**section, runs={"r": kt.Run(analysis="statics.at_poses", poses={"it": {}}, load_cases=["orbit"])}))
    figure, caption = loaded(run, report.document_page(run).record)
    assert "gravity" not in caption
    assert figure.axes is not None
    assert figure.axes[1] is None


def test_what_cannot_be_coloured_is_refused():
    model = swing()
    with pytest.raises(InputError, match="no forces to colour by"):
        snapshots(model, colour="force")
    rest = kt.statics.equilibrium(swing(material=kt.library.materials.STEEL_S235, section=kt.Tube(outer=0.03, inner=0.026)))
    with pytest.raises(InputError, match="no stress of a state at rest"):
        snapshots(rest, model=model, colour="stress")
