from typing import Literal

GoughStewartWorkingModeType0Item = Literal[-1, 1]

GOUGH_STEWART_WORKING_MODE_TYPE_0_ITEM_VALUES: set[GoughStewartWorkingModeType0Item] = {
    -1,
    1,
}


def check_gough_stewart_working_mode_type_0_item(value: int) -> GoughStewartWorkingModeType0Item:
    if value in GOUGH_STEWART_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {GOUGH_STEWART_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
