"""Motions given from elsewhere: arrays, tables, supports; whether a model can make them."""
