"""Compiled formulas on plain arrays: one formula, one place; SI units; never raise."""
