"""Units of what is answered, by the drives and coordinates they belong to."""

from mechanics.mechanism import Mechanism
from mechanics.motions import Motion


def drive_units(mechanism: Mechanism) -> list[str]:
    """Return the unit of each leg's drive coordinate."""
    return ["rad"] * mechanism.leg_count


def effort_units(mechanism: Mechanism) -> list[str]:
    """Return the unit of each drive's effort."""
    return ["N·m"] * mechanism.leg_count


def coordinate_units(motion: Motion) -> list[str]:
    """Return the unit of each coordinate."""
    return ["m" if c in motion.translations else "rad" for c in motion.coordinates]


def power_unit(bases: list[str]) -> str:
    """Return the product of units, equal ones gathered: m, m, rad give m²·rad."""
    marks = {1: "", 2: "²", 3: "³"}
    gathered = {base: bases.count(base) for base in bases}
    return "·".join(f"{base}{marks.get(n, f'^{n}')}" for base, n in gathered.items()) or "-"
