from typing import Literal

Planar3RRRWorkingModeType0Item = Literal[-1, 1]

PLANAR_3RRR_WORKING_MODE_TYPE_0_ITEM_VALUES: set[Planar3RRRWorkingModeType0Item] = {
    -1,
    1,
}


def check_planar_3rrr_working_mode_type_0_item(value: int) -> Planar3RRRWorkingModeType0Item:
    if value in PLANAR_3RRR_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {PLANAR_3RRR_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
