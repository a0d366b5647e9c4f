"""Writers of files of other programs, by suffix."""
