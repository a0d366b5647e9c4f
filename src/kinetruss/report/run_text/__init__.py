"""The result of a run in words and records: the whole, and its drives, springs, trains, statics, simulation."""
