"""Elements of a structure and what they give: masses, loads, stiffness."""
