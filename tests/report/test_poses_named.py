"""Runs of poses: what is said of them names poses, not times."""

import kinetruss as kt


def test_extremes_of_quantities_and_strokes_are_in_poses():
    """A boom on an actuator: its tip rises with the length; of a stroke from 0.9 to 1.7 m, 1.6 m is 75 % from the middle."""
    rod = {"base": kt.Part(length=0.9, mass=1), "tube": kt.Part(length=0.9, mass=1)}
    crane = kt.Model(
        nodes={"O": (0, 0), "P": (0.9, -0.4), "M": (1.2, 0.9), "T": (2.4, 1.8)}, fixed=["O", "P"],
        links={"boom": kt.Link(nodes=("O", "M", "T"), mass=10)},
        active={"lift": kt.Active(ends=("P", "M"), limits=(0.9, 1.7), **rod)}, gravity=(0, -9.81),
        quantities={"tip": "T.y"},
        runs={"hold": kt.Run(analysis="statics.at_poses", poses={"low": {"lift": 1.2}, "high": {"lift": 1.6}})},
    )  # fmt: skip
    run = kt.run(crane, "hold")
    assert run.finding.governing.place == "lift, stroke: 75 %, pose high"
    text = kt.report.summary(run).text
    table = text.partition("Quantities of the model, extremes of the poses\n")[2]
    assert table.split()[:6] == ["quantity", "least", "in", "pose", "largest", "in"]
    assert [word for word in table.splitlines()[1].split() if word in ("low", "high")] == ["low", "high"]
    assert " at 0 s" not in text and " at 1 s" not in text
