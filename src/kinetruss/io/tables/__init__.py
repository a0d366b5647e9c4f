"""Tables in files: histories, strains, exports."""
