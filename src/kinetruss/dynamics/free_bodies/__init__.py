"""Free bodies, joint reactions and the labelled equations of Newton and Euler."""
