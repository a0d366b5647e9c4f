"""Drive trains fed with a voltage, a current or a torque."""
