from typing import Literal

HexaRotaryWorkingModeType0Item = Literal[-1, 1]

HEXA_ROTARY_WORKING_MODE_TYPE_0_ITEM_VALUES: set[HexaRotaryWorkingModeType0Item] = {
    -1,
    1,
}


def check_hexa_rotary_working_mode_type_0_item(value: int) -> HexaRotaryWorkingModeType0Item:
    if value in HEXA_ROTARY_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {HEXA_ROTARY_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
