"""Conditions of a workspace, one file each."""
