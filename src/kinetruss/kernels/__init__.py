"""Arrays only: the loops that must be fast. Import kernel modules directly; this package imports none of them."""
