"""Integration in time: the machine that steps, looks for events and fills samples."""
