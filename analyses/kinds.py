"""The mechanism families that are offered."""

from analyses.mechanisms import build
from analyses.units import coordinate_units
from schemas.kinds import Kind
from schemas.mechanisms import KINDS
from schemas.presets import PRESETS


def kinds(analyses: list[str]) -> list[Kind]:
    """Return all kinds, each offering these analyses."""
    return [_kind(name, analyses) for name in KINDS]


def _kind(name: str, analyses: list[str]) -> Kind:
    spec = KINDS[name]
    presets = [preset for preset in PRESETS if preset.mechanism.kind == name]
    example = presets[0].mechanism
    mechanism = build(example)
    return Kind(
        kind=name,
        title=(spec.__doc__ or name).split("\n")[0],
        motion=mechanism.motion.name,
        coordinates=list(mechanism.motion.coordinates),
        coordinate_units=coordinate_units(mechanism.motion),
        drives=["crank"] * mechanism.leg_count,
        analyses=analyses,
        json_schema=spec.model_json_schema(),
        example=example,
        presets=presets,
    )
