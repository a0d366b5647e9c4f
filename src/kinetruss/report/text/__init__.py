"""Results as text, tables and plain data."""
