"""The mechanism families that are offered."""

from collections.abc import Sequence
from typing import Any

from analyses.analysis import Analysis
from analyses.mechanisms import build
from analyses.units import coordinate_units
from mechanics.legs import ARC_JOINTS, CRANK, RAIL, STRUT
from mechanics.mechanism import Mechanism
from schemas.kinds import Kind
from schemas.mechanisms import KINDS
from schemas.presets import PRESETS
from schemas.starters import STARTERS

DRIVES = {CRANK: "crank", RAIL: "rail", STRUT: "strut"}


def describe(name: str, analyses: Sequence[Analysis[Any]]) -> Kind:
    """Return one kind, offering those of these analyses that make sense for it.

    Raises
    ------
    KeyError : there is no such kind.
    """
    spec = KINDS[name]
    presets = [preset for preset in PRESETS if preset.mechanism.kind == name]
    example = STARTERS[name]
    mechanism = build(example)
    motion = mechanism.motion
    return Kind(
        kind=name,
        title=(spec.__doc__ or name).split("\n")[0],
        motion=motion.name,
        coordinates=list(motion.coordinates),
        coordinate_units=coordinate_units(motion),
        drives=_drives(mechanism),
        analyses=[a.name for a in analyses if not a.needs_gears or mechanism.wrist is not None],
        json_schema=spec.model_json_schema(),
        example=example,
        presets=presets,
    )


def _drives(mechanism: Mechanism) -> list[str]:
    legs = mechanism.legs
    motors = mechanism.drive_count - mechanism.leg_count
    return [
        *(
            "arc" if joints == ARC_JOINTS else DRIVES[int(drive)]
            for drive, joints in zip(legs.drive, legs.joints, strict=True)
        ),
        *["motor"] * motors,
    ]
