"""Closed forms behind the stored numbers of the verification: a dictionary of expected values by id for each subject, SI."""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Callable

import numpy as np
from scipy.special import ellipj

from reference.beam_forms import beams, conditions
from reference.joint_forms import joints
from reference.spring_forms import springs
from reference.task_forms import tasks
from reference.textbook_forms import textbooks

__all__ = ["ALL"]

Numbers = dict[str, float]
G = 9.81


def planar_body() -> Numbers:
    """M of a body of 2 kg with its centre at (e, f) = (0.2, 0.1) m and I = 0.03 kg m^2 about it on a bar of 0.5 m.

    (a, b) = m (e, f)/l, c = (I + m (e^2 + f^2))/l^2; det M = (m I/l^2)^2.
    """
    m, e, f, inertia, l = 2.0, 0.2, 0.1, 0.03, 0.5
    c = (inertia + m * (e * e + f * f)) / l**2
    near, far, side = m - 2 * m * e / l + c, m * e / l - c, m * f / l
    M = [[near, 0, far, -side], [0, near, side, far], [far, side, c, 0], [-side, far, 0, c]]
    found = {}
    for turned in ("0", "0.7", "2.5"):
        found |= {f"bodies.mass.{turned}.{i}{j}": M[i][j] for i in range(4) for j in range(4)}
        found[f"bodies.mass.{turned}.det"] = (m * inertia / l**2) ** 2
    return found


def barycentric() -> Numbers:
    """m_ij = int L_i L_j dm: a uniform tetrahedron, a cuboid from its corner and from alternate corners, a general body."""
    edges = ("01", "02", "03", "12", "13", "23")
    # of 1 kg: int L_i L_j = 1/20, as bars m/6: 6/20; the lumps are what is left of int L_i^2 = 1/10
    found = {f"bodies.tetrahedron.bar.{pair}": 6 / 20 for pair in edges} | {
        f"bodies.tetrahedron.lump.{i}": -0.2 for i in range(4)
    }
    found |= {f"bodies.cuboid.bar.{pair}": -2.0 if pair[0] == "0" else 1.5 for pair in edges} | {"bodies.cuboid.lump.0": 2.5}
    found |= {f"bodies.alternate.bar.{pair}": 0.25 for pair in edges} | {f"bodies.alternate.lump.{i}": -0.125 for i in range(4)}
    m, c = 3.0, np.array([0.2, -0.1, 0.4])
    inertia = np.array([[0.5, 0.03, -0.02], [0.03, 0.6, 0.01], [-0.02, 0.01, 0.7]])
    edge = np.array([0.5, 0.8, 1.25])
    # L_x = x/a and so on, L_0 = 1 - L_x - L_y - L_z
    J = (0.5 * np.trace(inertia) * np.eye(3) - inertia + m * np.outer(c, c)) / np.outer(edge, edge)
    first = m * c / edge
    found |= {f"bodies.entry.{i + 1}{j + 1}": J[i, j] for i in range(3) for j in range(i, 3)}
    found |= {f"bodies.entry.0{i + 1}": first[i] - J[i].sum() for i in range(3)}
    return found | {"bodies.entry.00": m - 2 * first.sum() + J.sum()}


def twists() -> Numbers:
    """T = m v.v/2 + w.I w/2, p = m v, L = I w of the random bodies."""
    from kinetruss.verification.solids import random_body

    found = {}
    for seed in (1, 2, 3):
        _, shape, v, w = random_body(seed)
        L = shape.inertia @ w
        energy = 0.5 * (shape.mass * v @ v + w @ L)
        found |= {f"bodies.twist.{seed}.T": energy, f"bodies.twist.{seed}.p": shape.mass * v[0], f"bodies.twist.{seed}.L": L[2]}
    return found


def euler_top() -> Numbers:
    """w1 = a1 cn, w2 = a2 sn, w3 = a3 dn for I1 < I2 < I3 and M^2 > 2 E I2, after 10 s (Landau & Lifshitz, section 37)."""
    m, (a, b, c), (w1, w3) = 2.0, (1.0, 0.6, 0.3), (0.4, 3.0)
    I1, I2, I3 = m / 12 * (b * b + c * c), m / 12 * (a * a + c * c), m / 12 * (a * a + b * b)
    energy, square = I1 * w1**2 + I3 * w3**2, (I1 * w1) ** 2 + (I3 * w3) ** 2  # twice the energy
    rate = math.sqrt((I3 - I2) * (square - energy * I1) / (I1 * I2 * I3))
    sn, cn, dn, _ = ellipj(10.0 * rate, (I2 - I1) * (energy * I3 - square) / ((I3 - I2) * (square - energy * I1)))
    w2 = math.sqrt((energy * I3 - square) / (I2 * (I3 - I2)))
    found = {}
    for change in ("0", "0.05"):
        found |= {f"bodies.euler.{change}.x": w1 * cn, f"bodies.euler.{change}.y": w2 * sn, f"bodies.euler.{change}.z": w3 * dn}
        found[f"bodies.euler.{change}.T"] = energy / 2
    return found


def rigid_bodies() -> Numbers:
    """A top in steady precession; a box under a couple and a force; a rod pulled along by a follower and by a dead load."""
    inertia = 2.0 / 12 * (1.0**2 + 0.6**2)
    return {
        "bodies.top.azimuth": 2.0,
        "bodies.top.tilt": 0.5,
        "bodies.top.force": 0.5 * G,
        "bodies.couple": 0.5 / inertia,
        "bodies.force": 0.3 / 2.0,
        # m l^2/3 w^2 = m g l/2, and P l of a dead load: 3 kg, 2 m, 20 N
        "bodies.follower.stiffness": 3 * G / 4,
        "bodies.dead.stiffness": (3 * G + 20.0 * 2.0) / 4,
    }


def continua() -> Numbers:
    """A cantilever (Timoshenko & Goodier, art. 21) and the lowest frequencies of a bar held at one end."""
    E, nu, force, length, depth = 210e9, 0.3, 1e6, 4.0, 1.0
    sag = force / (6 * E * depth**3 / 12) * (2 * length**3 + (4 + 5 * nu) * depth**2 * length / 4)
    speed = math.sqrt(70e9 / 2700.0)
    return {
        "solids.cantilever.constant.deflection": sag,
        "solids.cantilever.linear.deflection": sag,
        "solids.bar.first": speed / 4,
        "solids.bar.second": 3 * speed / 4,
    }


def pendulum() -> Numbers:
    """From horizontal at rest at x = -1 m: sin(a/2) = -k sn(K - t sqrt(g/l) | k^2) = -k cd(t sqrt(g/l) | k^2), k^2 = 1/2."""
    found = {}
    for t in range(1, 11):
        _, cn, dn, _ = ellipj(t * math.sqrt(G), 0.5)
        angle = -2 * math.asin(math.sqrt(0.5) * cn / dn)
        for where in ("forward", "forward.taylor"):
            found[f"{where}.pendulum.x_at_{t}s"] = math.sin(angle)
            found[f"{where}.pendulum.y_at_{t}s"] = -math.cos(angle)
    return found


def laws() -> Numbers:
    """A mass on a linear, a damped and a Green spring from 1.3 m, and one that a cable catches."""
    k, m, start = 100.0, 2.0, 1.3
    found = {}
    for t in (0.5, 1.0, 2.5, 5.0):
        found[f"forward.law.engineering.{t:g}s"] = 1 + 0.3 * math.cos(math.sqrt(k / (m + 0.5)) * t)
        d = 3.0 / (2 * m)
        w = math.sqrt(k / m - d * d)
        found[f"forward.law.damped.{t:g}s"] = 1 + 0.3 * math.exp(-d * t) * (math.cos(w * t) + d / w * math.sin(w * t))
        dn = ellipj(start * math.sqrt(k / (4 * m)) * t, 2 - 2 / start**2)[2]
        found[f"forward.law.green.{t:g}s"] = start * float(dn)
    k, m, drop = 2000.0, 2.0, 0.6
    w, tight = math.sqrt(k / m), math.sqrt(2 * drop / G)
    v = G * tight
    # stretch s = g/w^2 (1 - cos) + v/w sin is zero again at tan(w tau/2) = -v w/g
    slack = tight + 2 * (math.pi - math.atan(v * w / G)) / w
    lowest = G / w**2 + math.hypot(G / w**2, v / w)
    return found | {
        "forward.law.cable.tight": tight,
        "forward.law.cable.slack": slack,
        "forward.law.cable.falling": -0.4 - G / 2 * 0.3**2,
        "forward.law.cable.lowest": -1 - lowest,
        "forward.law.cable.tension": k * lowest,
        "forward.law.cable.thrown": -1 + v * 0.2 - G / 2 * 0.2**2,
        "forward.drive.given_force": 1 + 50.0 / 12.5 / 2,
    }


def afloat() -> Numbers:
    """Turns without angular momentum, as integrals over the shapes; a mass that a spring and a damper pull along."""
    reduced = 3.0 * 2.0 / 5.0
    near, far, both = 0.2 + reduced * 0.4**2, 0.5 + reduced * 0.6**2, reduced * 0.4 * 0.6
    q = np.linspace(0, 2 * math.pi, 201)[:-1]  # the trapezoidal rule of a periodic function
    share = (far - both * np.cos(q)) / (near + far - 2 * both * np.cos(q))
    out, back = (3.0 * r**2 / (0.9 + 3.0 * r**2) for r in (1.4, 0.5))
    found = {"forward.afloat.hinge": -2 * math.pi * float(share.mean()), "forward.afloat.cycle": 1.2 * (back - out)}
    s = cmath.sqrt((4.0 / 4.0) ** 2 - 50.0 / 2.0)
    for t in (0.5, 1.0, 2.0):
        found[f"forward.tracked.error_at_{t:g}s"] = (-0.2 * math.exp(-t) * cmath.sinh(s * t) / s).real
    return found | {"forward.tracked.limited": 1 + 0.5 * 0.3 / 2.0}


def rows() -> Numbers:
    """A nut on a thread, geared arms, masses on a rod that turns steadily."""
    pitch, t = 0.02, 3.0
    fall = -3.5 * G / (3.5 + 0.5 * 0.3**2 * (2 * math.pi / pitch) ** 2) * t * t / 2
    angle = 2 * math.pi / pitch * fall
    centre, w = 1.4 / 3.0, 3.0
    away, rate = centre * math.cosh(w * 0.8), centre * w * math.sinh(w * 0.8)
    return {
        "joints.screw.fall": fall,
        "joints.screw.rim.x": 0.3 * math.cos(angle),
        "joints.screw.rim.y": 0.3 * math.sin(angle),
        "rows.gears.angle": 4.0 / (2.0 * 0.5**2 + 0.25 * 1.0 * 0.3**2) * t * t / 2,
        "rows.slider.away": away,
        "rows.slider.torque": 2 * 3.0 * away * rate * w,
        "joints.prismatic.fall": -0.64 * G * 0.2**2 / 2,
        "joints.cylindrical.fall": -G * 0.2**2 / 2,
        "joints.planar.fall": -G * 0.2**2 / 2,
    }


def loops() -> Numbers:
    """Straight lines of Peaucellier and Hart, the half angles of Bennett's loop."""
    peaucellier = (0.5**2 - 0.3**2) / (2 * 0.15)
    hart = -0.25 * (1 - 0.25) * (0.5**2 - 0.25**2) / (2 * 0.08) / (1 - 0.25)
    return {
        **{f"loops.peaucellier.{which}": peaucellier for which in ("most", "least")},
        **{f"loops.hart.{which}": hart for which in ("most", "least")},
        "loops.bennett.turn": math.sin((1.3 + 0.7) / 2) / math.sin((1.3 - 0.7) / 2),
    }


def tilts() -> Numbers:
    """The quintic, and the axis about which the top plane turns: +x with beta, -y with gamma."""
    tilt, found = math.radians(10), {}
    for angle, axis, sign in (("beta", "x", 1.0), ("gamma", "y", -1.0)):
        for s in (0.25, 0.5, 0.8):
            value = -tilt + 2 * tilt * (10 * s**3 - 15 * s**4 + 6 * s**5)
            rate = 2 * tilt * (30 * s**2 - 60 * s**3 + 30 * s**4)
            second = 2 * tilt * (60 * s - 180 * s**2 + 120 * s**3)
            where = f"rates.{angle}.t={s:g}"
            found |= {f"{where}.{angle}": value, f"{where}.{angle}_rate": rate, f"{where}.{angle}_acceleration": second}
            for name, size in (("angular_velocity", rate), ("angular_acceleration", second)):
                found |= {f"{where}.{name}.{k}": sign * size if k == axis else 0.0 for k in "xyz"}
    return found


def robots() -> Numbers:
    """Legs of a platform, l = |p + R b - a|, R = Rz(yaw) Ry(pitch) Rx(roll)."""
    from kinetruss.library import mechanisms

    model = mechanisms.stewart()
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(a), math.sin(a)) for a in (0.1, -0.15, 0.25))
    Rx, Ry = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]]), np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    R, home, found = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]]) @ Ry @ Rx, np.array([0.0, 0.0, 0.6]), {}
    for k in range(1, 7):
        foot, head = (np.array(model.nodes[end].at) for end in model.bars[f"leg{k}"].ends)
        found[f"stewart.leg{k}"] = float(np.linalg.norm(home + (0.05, -0.04, 0.08) + R @ (head - home) - foot))
    return found


def drive_trains() -> Numbers:
    """A geared crank by hand, and a loop with placed poles after a step."""
    found, (mass, arm, start, way, duration) = {}, (1.7, 0.4, 0.2, 2.4, 1.5)
    ratio, efficiency, gear_inertia = 12.0, 0.85, 3e-6
    motor_inertia, resistance, constant, friction = 2e-5, 1.3, 0.06, 0.004
    for place, s in (("driving", 0.3), ("driven", 0.8)):
        q = start + way * (10 * s**3 - 15 * s**4 + 6 * s**5)
        rate = way / duration * 30 * s**2 * (1 - s) ** 2
        second = way / duration**2 * (60 * s - 180 * s**2 + 120 * s**3)
        torque = mass * arm**2 * second + mass * G * arm * math.cos(q)
        loss = 1 / efficiency if torque * rate > 0 else efficiency
        at_motor = torque * loss / ratio + (motor_inertia + gear_inertia) * ratio * second + friction
        current, speed = at_motor / constant, ratio * rate
        voltage = resistance * current + constant * speed
        numbers = {
            "drive_torque": torque,
            "motor_speed": speed,
            "motor_torque": at_motor,
            "current": current,
            "voltage": voltage,
        }
        numbers["electrical_power"] = voltage * current
        found |= {f"actuators.rotary.{place}.{name}": value for name, value in numbers.items()}
    zeta = 0.8
    pole = 4 / (zeta * 0.5) * complex(-zeta, math.sqrt(1 - zeta**2))
    for t in (0.05, 0.1, 0.2, 0.3, 0.5):
        # 1 - Re((1 + i zeta w/w_d ...) e^(pole t)), written with the conjugate pair of poles
        step = 1 + (pole.conjugate() / (pole - pole.conjugate()) * cmath.exp(pole * t)).real * 2
        found |= {f"drive_train.poles.{name}_at_{t:g}s": step for name in ("current", "voltage")}
    return found


def statics() -> Numbers:
    """Three bars, a level bar with gauges, struts in a triangle."""
    middle = 1 / (1 + 2 * math.cos(math.pi / 4) ** 3)
    outer, inner, E = 0.025, 0.021, 71e9
    area, moment = math.pi / 4 * (outer**2 - inner**2), math.pi / 64 * (outer**4 - inner**4)
    axial = 1e6 * 250.0 / (E * area)
    bending = 1e6 * 1.5 * G * 2.0 / 8 * outer / 2 / (E * moment)
    change = 2.1e-6 * (axial + bending)
    thrust = 3000.0 / 2 / math.sin(math.pi / 3)
    used = {d: 2 * thrust / (math.pi**3 * 70e9 / 64 * ((d / 1e3) ** 4 - ((d - 2) / 1e3) ** 4)) for d in range(8, 31)}
    least = min(d for d, share in used.items() if share <= 1)
    return {
        "statics.three_bars.middle": middle,
        "statics.three_bars.side": middle / 2,
        "statics.three_bars.sag": middle,
        "statics.three_bars.shared_middle": middle,
        "gauges.level_bar.top": axial - bending,
        "gauges.level_bar.side": axial,
        "gauges.level_bar.low": axial + bending,
        "gauges.level_bar.axial": axial,
        "gauges.level_bar.bending_3": bending,
        "gauges.level_bar.bridge": (1 + change) / (2 + change) - 0.5,
        "budget.two_bars.x": 1.25 / 1.5,
        "budget.two_bars.y": -1.25 / 2,
        "budget.two_bars.worst_case": 2e-4 * 1.25 / 2,
        "budget.two_bars.root_sum_square": math.sqrt(2) * 1e-4 * 1.25 / 2,
        "gauges.rosette.largest": 200 + math.hypot(300, 150),
        "gauges.rosette.least": 200 - math.hypot(300, 150),
        "gauges.rosette.tangent": 300 / 600,
        "gauges.shunt.strain": -120 / (2 * (120 + 59880)),
        "sizing.bracket.outer": float(least),
        "sizing.bracket.utilisation": used[least],
        "sizing.bracket.one_size_smaller": used[least - 1],
    }


def von_mises() -> Numbers:
    """The truss of two bars: the path above its limit, the limit, leaning over, snapped through."""
    found, rise, rest = {}, 0.3, math.hypot(1.0, 0.3)
    for strain, y0, load in (
        ("engineering", math.sqrt(rest ** (2 / 3) - 1), 2 * (rest ** (2 / 3) - 1) ** 1.5),
        ("green", rise / math.sqrt(3), 2 * rise**3 / (3 * math.sqrt(3) * rest**2)),
    ):
        where = f"equilibrium.von_mises.{strain}"
        found |= {f"{where}.limit_height": y0, f"{where}.limit_load": load}
        for share in (0.9, 0.5, 0.1, 0.01):
            y = y0 + share * (rise - y0)
            k = (3 * y**2 - rise**2) / rest**2 if strain == "green" else 2 * (1 - rest / math.hypot(1.0, y) ** 3)
            found |= {f"{where}.{share:g}.height": y, f"{where}.{share:g}.stiffness": k}
    # no stiffness sideways: l^3 = l0 y^2 = l0 (l^2 - 1)
    rest = math.hypot(1.0, 3.0)
    length = max(root.real for root in np.roots([1.0, -rest, 0.0, rest]) if abs(root.imag) < 1e-12)
    y = math.sqrt(length**2 - 1)
    found |= {"equilibrium.von_mises.steep.bifurcation_height": y}
    found |= {"equilibrium.von_mises.steep.bifurcation_load": 2 * (rest - length) * y / length}
    return found | {"equilibrium.von_mises.snapped.height": -0.35}


def equal_turns() -> Numbers:
    """A third of the tilt to 30 and 30 degrees: the unit vector a third of the way along the great circle from z (slerp)."""
    a = math.radians(30)
    normal = (-math.sin(a), -math.sin(a) * math.cos(a), math.cos(a) ** 2)
    tilt = math.acos(normal[2])
    x, y, z = (
        (math.sin(2 * tilt / 3) * up + math.sin(tilt / 3) * n) / math.sin(tilt)
        for up, n in zip((0.0, 0.0, 1.0), normal, strict=True)
    )
    name = "cells.share.three_bays"
    return {f"{name}.beta": math.degrees(math.atan2(-y, z)), f"{name}.gamma": math.degrees(math.asin(-x))}


def small_motions() -> Numbers:
    """Hanging pendulums, an oscillator on a moving base, links that buckle, a prism, feedback of least cost."""
    r, z = 2.0, 0.1
    return {
        "frequencies.hanging.rod": math.sqrt(1.5 * G),
        "frequencies.hanging.slow": math.sqrt((2 - math.sqrt(2)) * G),
        "frequencies.hanging.fast": math.sqrt((2 + math.sqrt(2)) * G),
        "linearise.oscillator.transmissibility": math.sqrt((1 + (2 * z * r) ** 2) / ((1 - r**2) ** 2 + (2 * z * r) ** 2)),
        "buckling.links_2.mode_1": 6.0,
        "buckling.links_3.mode_1": 4.0,
        "buckling.links_3.mode_2": 12.0,
        "feedback.least_cost.pole_real": -math.sqrt(16.0 / 2),
        "feedback.least_cost.pole_imag": math.sqrt(16.0 / 2),
        "equilibrium.prism.twist": 150.0,
        "equilibrium.prism.strut": -1.0,
        "equilibrium.prism.horizontal": 1 / math.sqrt(3),
    }


def flexible() -> Numbers:
    """A mass on a spring whose end moves by a quintic; a clamped chain of consistent masses; one mode with feedback."""
    k, m, D, T = 3.5e6, 3.0, 0.1, 0.05
    w = math.sqrt(k / m)

    def forced(t: float) -> tuple[float, float]:
        """Of u'' + w^2 u = -a(t), a of the quintic: -(a - a''/w^2)/w^2 and its rate."""
        s = t / T
        a, second = D / T**2 * (60 * s - 180 * s**2 + 120 * s**3), D / T**4 * (-360 + 720 * s)
        rate, third = D / T**3 * (60 - 360 * s + 360 * s**2), D / T**5 * 720
        return -(a - second / w**2) / w**2, -(rate - third / w**2) / w**2

    def free(t: float, u: float, v: float) -> tuple[float, float]:
        return u * math.cos(w * t) + v / w * math.sin(w * t), v * math.cos(w * t) - u * w * math.sin(w * t)

    def u(t: float) -> float:
        moved = min(t, T)
        own, given = free(moved, *(-one for one in forced(0.0))), forced(moved)
        return free(t - moved, own[0] + given[0], own[1] + given[1])[0]

    found = {"flexible.one_bar.frequency": w / (2 * math.pi)}
    found |= {f"flexible.one_bar.vibration_{t}ms": u(t / 1000) for t in (20, 50, 75)}
    found |= {f"flexible.one_bar.simulation_{t}ms": u(t / 1000) for t in (20, 50)}
    bars, of, mass = 5, 70e9 * 1e-4, 2700 * 1e-4
    for j in range(1, bars + 1):
        turn = (2 * j - 1) * math.pi / (2 * bars)
        squared = 6 * of / mass * (1 - math.cos(turn)) / (2 + math.cos(turn))
        found[f"flexible.chain.mode_{j}"] = math.sqrt(squared) / (2 * math.pi)
    # s (s^2 + w^2) + g (s^2 + z^2) = 0: w^2 = 4e6/2, z^2 = 1e6/2
    roots = np.roots([1.0, 100.0, 2e6, 100.0 * 0.5e6])
    root = roots[roots.imag > 0][0]
    found["flexible.damped.force_100"] = float(-root.real / abs(root))
    found["flexible.damped.force_best"] = (math.sqrt(2e6) - math.sqrt(0.5e6)) / (2 * math.sqrt(0.5e6))
    found["flexible.damped.rate_1000"] = 1000.0 / (2 * 2.0 * math.sqrt(2e6))
    return found


def supports() -> Numbers:
    """Values over their closed forms are 1; Euler's factors are 1/4, 1, (z/pi)^2 with tan z = z, and 4."""
    z = 4.5
    for _ in range(20):  # Newton's method on sin z - z cos z
        z -= (math.sin(z) - z * math.cos(z)) / (z * math.sin(z))
    names = ("settled.prop", "settled.clamp", "settled.turned", "yielding.deflection", "yielding.prop", "foot.foot")
    found = dict.fromkeys((*names, "one_sided.gap", "one_sided.lifted", "one_sided.slope", "euler.pinned"), 1.0)
    found |= {"euler.clamped_free": 0.25, "euler.clamped_pinned": (z / math.pi) ** 2, "euler.clamped": 4.0}
    return {f"supports.{name}": value for name, value in found.items()}


def loads() -> Numbers:
    """A force and a couple at a = L/4 of a beam; rafters with three hinges under snow; combinations, one by one."""
    a, b = 0.25, 0.75
    found = {"force": a**2 * (3 - a) / 6, "force.clamp.near": a * b**2, "force.clamp.far": a**2 * b, "force.jump": 1.0}
    found |= {"couple": a * (1 - a / 2), "couple.clamp.near": abs(b * (2 * a - b)), "couple.clamp.far": a * (2 * b - a)}
    found = {f"beams.at_a_place.{name}": value for name, value in (found | {"couple.jump": 1.0}).items()}
    # half of s l down on each rafter at l/4 from the ridge: H f = (s l/2) l/2 - (s l/2) l/4; (s cos) (l/2 / cos)^2/8 cos
    found |= {"bars.snow.reaction": 0.5, "bars.snow.thrust": 0.25 - 0.125, "bars.snow.moment": 0.5**2 / 8}
    down, across = {"Q": 6.0, "S": 4.0, "W": 0.0}, {"Q": 0.0, "S": 0.0, "W": 5.0}
    later = {"Q": 0.7, "S": 0.5, "W": 0.6}  # psi_0 of category B, of snow up to 1000 m, of wind
    en = []
    for dead in (1.35, 1.0):
        en.append((10 * dead, 0.0))
        for several in range(1, 4):
            for chosen in itertools.combinations("QSW", several):
                for leading in chosen:
                    factor = {one: 1.5 if one == leading else 1.5 * later[one] for one in chosen}
                    en.append(
                        (10 * dead + sum(f * down[c] for c, f in factor.items()), sum(f * across[c] for c, f in factor.items()))
                    )
    # 1: 1.4 D; 2: 1.2 D + 1.6 L (+ 0.5 S); 3: 1.2 D + 1.6 S (+ L or 0.5 W); 4: 1.2 D + W (+ L) (+ 0.5 S); 5: 0.9 D + W
    asce = [(14.0, 0.0), (12 + 9.6, 0.0), (12 + 9.6 + 2, 0.0), (12 + 6.4, 0.0), (12 + 6.4 + 6, 0.0), (12 + 6.4, 2.5)]
    asce += [(12 + live + snow, 5.0) for live in (0.0, 6.0) for snow in (0.0, 2.0)] + [(9.0, 5.0)]
    for name, rows in (("en", en), ("asce", asce)):
        most, wide = (max(row[k] for row in rows) for k in (0, 1))
        own = {"count": len(rows), "most": most, "least": min(row[0] for row in rows), "across": wide}
        found |= {f"loads.combinations.{name}.{key}": float(value) for key, value in own.items()}
    return found


def links() -> Numbers:
    """Values over their closed forms are 1; the bell crank turns a force of 0.3 m into one of 0.2 m."""
    names = ("push", "pin_moment", "overhang", "pendulum.period")
    return {f"links.{name}": 1.0 for name in names} | {"links.bell_crank": 0.3 / 0.2}


ALL: tuple[Callable[[], Numbers], ...] = (
    planar_body,
    supports,
    loads,
    links,
    barycentric,
    twists,
    euler_top,
    rigid_bodies,
    continua,
    pendulum,
    laws,
    afloat,
    rows,
    loops,
    tilts,
    robots,
    drive_trains,
    statics,
    von_mises,
    equal_turns,
    small_motions,
    flexible,
    joints,
    springs,
    beams,
    conditions,
    tasks,
    textbooks,
)
