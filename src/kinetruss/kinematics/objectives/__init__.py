"""Objectives of redundant drives without a closed form: what they cost, their least values, and a curve through knots."""
