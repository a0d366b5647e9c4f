"""The parts of a report, each from the results of a run."""
