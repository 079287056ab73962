"""Units of what is answered, by the drives and coordinates they belong to."""

from mechanics.legs import ARC_JOINTS, CRANK
from mechanics.mechanism import Mechanism
from mechanics.motions import Motion


def drive_units(mechanism: Mechanism) -> list[str]:
    """Return the unit of each drive's coordinate."""
    return ["rad" if turning else "m" for turning in _turning(mechanism)]


def rate_units(mechanism: Mechanism) -> list[str]:
    """Return the unit of each drive's rate."""
    return [f"{unit}/s" for unit in drive_units(mechanism)]


def effort_units(mechanism: Mechanism) -> list[str]:
    """Return the unit of each drive's effort: a crank's or motor's torque, a force of others."""
    return ["N·m" if turning else "N" for turning in _turning(mechanism)]


def _turning(mechanism: Mechanism) -> list[bool]:
    motors = mechanism.drive_count - mechanism.leg_count
    return [*(mechanism.legs.drive == CRANK).tolist(), *[True] * motors]


def coordinate_units(motion: Motion) -> list[str]:
    """Return the unit of each coordinate."""
    return ["m" if c in motion.translations else "rad" for c in motion.coordinates]


def power_unit(bases: list[str]) -> str:
    """Return the product of units, equal ones gathered: m, m, rad give m²·rad."""
    marks = {1: "", 2: "²", 3: "³"}
    gathered = {base: bases.count(base) for base in bases}
    return "·".join(f"{base}{marks.get(n, f'^{n}')}" for base, n in gathered.items()) or "-"


def shared_unit(units: list[str]) -> str:
    """Return the unit that all share, or all units that occur, joined by 'or'."""
    return " or ".join(dict.fromkeys(units))


def determinant_unit(mechanism: Mechanism) -> str:
    """Return the unit of det Jx: m for every turn; an arc's row is a number."""
    turns = (
        0
        if mechanism.motion.name == "spherical" and _only_arcs(mechanism)
        else len(mechanism.motion.turns)
    )
    return {0: "-", 1: "m", 2: "m²", 3: "m³"}[turns]


def _only_arcs(mechanism: Mechanism) -> bool:
    return bool((mechanism.legs.joints == ARC_JOINTS).all())
