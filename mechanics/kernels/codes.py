"""Codes of grid nodes that are no reason's: reasons are counted from 1 on."""

INSIDE = 0
"""The code of a node at which every condition holds."""

UNSEEN = 255
"""The code of a node, or of a box, of which nothing is known yet: no reason's is as high."""
