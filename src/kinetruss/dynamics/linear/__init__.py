"""Small motions: linearisation, reduction to chosen freedoms, feedback."""
