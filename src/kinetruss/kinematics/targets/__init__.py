"""From wanted poses to the lengths of drives."""
