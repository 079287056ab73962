"""Mechanism families: short functions from dimensions to a mechanism, one file each."""
