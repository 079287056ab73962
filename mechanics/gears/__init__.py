"""Gears with friction: pairs of involute teeth, the force between them, trains of them."""
