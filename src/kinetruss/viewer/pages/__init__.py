"""The page that shows scenes."""
