"""Radau IIA: an implicit method whose stages are solved at once by Newton's method, for stiff runs."""
