"""Integration in time: single steps, the machine that asks for them, looks for events and fills samples."""
