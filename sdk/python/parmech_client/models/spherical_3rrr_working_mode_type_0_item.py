from typing import Literal

Spherical3RRRWorkingModeType0Item = Literal[-1, 1]

SPHERICAL_3RRR_WORKING_MODE_TYPE_0_ITEM_VALUES: set[Spherical3RRRWorkingModeType0Item] = {
    -1,
    1,
}


def check_spherical_3rrr_working_mode_type_0_item(value: int) -> Spherical3RRRWorkingModeType0Item:
    if value in SPHERICAL_3RRR_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {SPHERICAL_3RRR_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
