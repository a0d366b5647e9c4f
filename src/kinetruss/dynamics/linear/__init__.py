"""Small motions: linearisation, reduction to chosen degrees of freedom, feedback."""
