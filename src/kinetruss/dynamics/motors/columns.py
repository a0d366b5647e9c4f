"""What is recorded of each motor of a simulation, one column each."""

from __future__ import annotations

__all__ = ["COLUMNS"]

COLUMNS = {
    "motor_command": ("", "input, as given (V or A)"),
    "motor_voltage": ("V", "motor voltage"),
    "motor_current": ("A", "motor current"),
    "motor_torque": ("N m", "motor torque (torque constant x current)"),
    "motor_angle": ("rad", "turned by the motor since the start"),
    "motor_speed": ("rad/s", "speed of the motor"),
    "motor_direction": ("", "direction of the motion: 1 longer or turning on, -1 shorter or back, 0 sticks"),
    "screw_torque": ("N m", "torque on the screw, positive towards longer; 0 at standstill, none of an angle"),
    "electrical_energy": ("J", "taken from the source so far"),
    "copper_energy": ("J", "heat in the winding so far"),
    "motor_loss": ("J", "friction of the motor so far"),
    "gear_loss": ("J", "lost in the gear so far"),
    "screw_loss": ("J", "friction of the screw so far"),
    "actuator_work": ("J", "work of the thrust or torque on the structure so far"),
    "motor_stored_energy": ("J", "in rotor and winding"),
}
"""In the order in which they come."""
