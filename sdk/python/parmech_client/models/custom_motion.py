from typing import Literal

CustomMotion = Literal["planar", "planar_translation", "schoenflies", "spatial", "spherical", "translation"]

CUSTOM_MOTION_VALUES: set[CustomMotion] = {
    "planar",
    "planar_translation",
    "schoenflies",
    "spatial",
    "spherical",
    "translation",
}


def check_custom_motion(value: str) -> CustomMotion:
    if value in CUSTOM_MOTION_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {CUSTOM_MOTION_VALUES!r}")
