"""Elastic members and actuators: frequencies, vibration, corrected drive lengths, active damping."""
