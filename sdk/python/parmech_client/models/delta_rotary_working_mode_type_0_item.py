from typing import Literal

DeltaRotaryWorkingModeType0Item = Literal[-1, 1]

DELTA_ROTARY_WORKING_MODE_TYPE_0_ITEM_VALUES: set[DeltaRotaryWorkingModeType0Item] = {
    -1,
    1,
}


def check_delta_rotary_working_mode_type_0_item(value: int) -> DeltaRotaryWorkingModeType0Item:
    if value in DELTA_ROTARY_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {DELTA_ROTARY_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
