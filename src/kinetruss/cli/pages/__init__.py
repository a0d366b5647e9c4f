"""Commands for pages and pictures."""
