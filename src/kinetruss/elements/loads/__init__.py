"""Loads on bodies and members, one file each: what a kind puts on nodes, and on which members it acts between their ends."""
