"""Models, missions and catalogues from files and into files."""
