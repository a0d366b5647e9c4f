"""Text formats: YAML, JSON and TOML with the place of every value."""
