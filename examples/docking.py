"""A manipulator of six bays docks: eighteen drives for six coordinates, and one drive that jams."""

import numpy as np

import kinetruss as kt

model = kt.read(kt.library.example_files()["docking"][0])
run = model.runs["dock"]
task = run.targets

jammed = task.with_(hold=("B3.M9",))  # the others do its work
for word, each in (("all drives", task), ("B3.M9 jammed", jammed)):
    motion = kt.kinematics.inverse(model, each, samples=run.samples)
    lengths = motion.drive_position
    print(
        f"{word}: lengths from {lengths.min().item():.3f} to {lengths.max().item():.3f} m, {motion.message or 'within strokes'}"
    )
    docked = kt.kinematics.pose(model, motion, task.platform)  # measured from the nodes alone
    place, turns = docked.position.values, np.degrees(docked.euler.values[-1])
    print(f"  docked at {place[-1].round(9)} m, yaw, pitch, roll {turns.round(7)} degrees")
    assert np.allclose(place[-1], [0.2, -0.8, 5.75], rtol=0, atol=1e-9)
    assert np.allclose(turns, [12, 23.8335, -11.3344], rtol=0, atol=1e-7)
    assert abs(place[45:, :2] - place[-1, :2]).max() < 1e-9  # the last 15 s go straight to the port
    for case in model.load_cases:
        forces = kt.dynamics.inverse(model, motion, load_case=case)
        worst = kt.strength.check(model, forces).table()[0]
        demand = kt.actuators.evaluate(model, motion, forces)
        drawn = demand.drawn_energy.sum().item()
        print(f"  {case}: {worst.part} governs, {100 * worst.utilisation:.2f} % of {worst.rule}; motors draw {drawn:.0f} J")
        assert worst.utilisation < 1
        assert not kt.actuators.exceeded(demand)
        assert demand.self_locking.all()  # it stays docked without current
