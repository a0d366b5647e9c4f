"""The isolator with its beam: the beam alone in closed form, both by modes of the clamped beam, the feedback."""

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

import kinetruss as kt

BASE, TOP, LEGS = ("N1", "N2", "N3"), ("N7", "N8", "N9"), ("M7", "M9", "M11")
ROOTS = np.array([1.8751040687, 4.6940911330, 7.8547574382])  # cos x cosh x = -1
PAGE = (Path(__file__).parents[2] / "docs" / "examples.md").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def model():
    return kt.read(kt.library.example_files()["isolator_beam"][0])


def strip(model):
    """Length of an arm m, mass per length kg/m, E I N m^2 of vertical bending."""
    section, material = model.sections["strip"], model.materials["aluminium_6082_t6"]
    return 1.2, material.density * section.area, material.E * section.width * section.height**3 / 12


def clamped(model):
    """Angular frequencies of an arm, 1/s, and the masses that take part in the shake of its clamp, kg (Euler-Bernoulli)."""
    long, per_length, EI = strip(model)
    tilt = (np.cosh(ROOTS) + np.cos(ROOTS)) / (np.sinh(ROOTS) + np.sin(ROOTS))
    return ROOTS**2 * np.sqrt(EI / (per_length * long**4)), per_length * long * (2 * tilt / ROOTS) ** 2


def bounce(model):
    """Lowest frequency of a vertical motion of the plate without tilt, Hz."""
    lin = kt.dynamics.linearise(model, kt.statics.equilibrium(model))
    z = lin.mode_shape.sel(node=list(TOP), axis="z").values[:3]
    plain = [k for k in range(3) if np.ptp(z[k]) < 1e-3 * np.abs(z[k]).max()]
    return float(lin.frequency.values[plain[0]])


def weighted(model, mass, gravity):
    """The isolator with a lumped mass in place of the beam."""
    nodes = {name: node for name, node in model.nodes.items() if name[0] == "N"}
    centre = kt.Node(at=model.nodes["C"].at, mass=mass, gravity=(0, 0, gravity))
    legs = {f"C-{name}": kt.Bar(ends=("C", name)) for name in TOP}
    return model.with_(nodes=nodes | {"C": centre}, bars=model.bars | legs, beams={}, bodies={}, clamped={})


def test_the_beam_alone(model):
    """An arm clamped to the ground, two elements: within 5e-4 (docs/beams.md) and the rotary inertia of the section."""
    arm = kt.Model(
        nodes={name: model.nodes[name].at for name in ("C", "right1", "right2")},
        beams={name: model.beams[name] for name in ("right_inner", "right_outer")},
        clamped=["C"],
        sections=model.sections,
        materials=model.materials,
    )
    exact = clamped(model)[0][0] / (2 * np.pi)
    assert kt.dynamics.linearise(arm).frequency.values[0] == pytest.approx(exact, rel=7e-4)


@pytest.mark.slow
def test_beam_and_isolator_by_modes_of_the_clamped_beam(model):
    """Plate and beam: k = w^2 (m0 + m' + sum m_i w_i^2/(w_i^2 - w^2)), m_i, w_i of the clamped beam, m' the rest of its mass.

    k and m0 come from two lumped masses of the weight of the beam, one of them with twice its inertia.
    """
    long, per_length, _ = strip(model)
    mass = 2 * long * per_length
    light, heavy = (2 * np.pi * bounce(weighted(model, m, g)) for m, g in ((mass, 9.81), (2 * mass, 9.81 / 2)))
    m0 = mass * (2 * heavy**2 - light**2) / (light**2 - heavy**2)
    k = light**2 * (m0 + mass)
    w_i, m_i = clamped(model)
    m_i = 2 * m_i

    def balance(w):
        return w**2 * (m0 + mass - m_i.sum() + (m_i * w_i**2 / (w_i**2 - w**2)).sum()) - k

    expected = [brentq(balance, 1.0, w_i[0] * 0.999), brentq(balance, w_i[0] * 1.001, w_i[1] * 0.9)]
    lin = kt.dynamics.linearise(model, kt.statics.equilibrium(model))
    z = lin.mode_shape.sel(node=["left2", "right2"], axis="z").values[:5]
    even = [
        lin.frequency.values[j]
        for j in range(5)
        if z[j, 0] * z[j, 1] > 0 and np.abs(z[j]).max() > 0.1 * np.abs(lin.mode_shape.values[j]).max()
    ]
    assert m_i.sum() < mass
    for f in expected:
        assert min(abs(one * 2 * np.pi / f - 1) for one in even) < 2e-3


@pytest.mark.slow
def test_feedback_of_the_plate_damps_the_beam(model):
    """Each leg acts against the rate of the corner over against it: no pole gets unstable, and the first mode is damped."""
    rest = kt.statics.equilibrium(model)
    lin = kt.dynamics.linearise(model, rest, inputs=LEGS)
    loop = kt.dynamics.feedback(
        lin, inputs=LEGS, gains={leg: {f"{node}.z'": -600.0} for leg, node in zip(LEGS, ("N8", "N9", "N7"), strict=True)}
    )
    open_, closed = (np.asarray(one.poles) for one in (lin, loop))
    sizes = [one[(np.abs(one) > 2 * np.pi * 11) & (np.abs(one) < 2 * np.pi * 12.5)] for one in (open_, closed)]
    ratio = [(-one.real / np.abs(one)).max() for one in sizes]
    assert ratio[1] > 3 * ratio[0]
    assert closed.real.max() < 1e-6 * np.abs(closed).max()


@pytest.mark.slow
def test_the_page_says_what_the_script_finds(model):
    section = PAGE.split("## An isolator with a flexible beam")[1].split("## ")[0]
    bare = model.with_(nodes={n: node for n, node in model.nodes.items() if n[0] == "N"}, beams={}, bodies={}, clamped={})
    for one in (bare, model):
        for f in kt.dynamics.linearise(one, kt.statics.equilibrium(one)).frequency.values[: 3 if one is bare else 5]:
            assert re.search(rf"\b{f:.2f}\b", section), f
