from typing import Literal

CustomWorkingModeType0Item = Literal[-1, 1]

CUSTOM_WORKING_MODE_TYPE_0_ITEM_VALUES: set[CustomWorkingModeType0Item] = {
    -1,
    1,
}


def check_custom_working_mode_type_0_item(value: int) -> CustomWorkingModeType0Item:
    if value in CUSTOM_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {CUSTOM_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
