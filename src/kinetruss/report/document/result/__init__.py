"""The result of a run in words: three lines, tiles, warnings, assumptions and what was not checked."""
