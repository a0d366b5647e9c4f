"""One run of many variants of a model."""
