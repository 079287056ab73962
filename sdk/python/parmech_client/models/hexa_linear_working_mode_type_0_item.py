from typing import Literal

HexaLinearWorkingModeType0Item = Literal[-1, 1]

HEXA_LINEAR_WORKING_MODE_TYPE_0_ITEM_VALUES: set[HexaLinearWorkingModeType0Item] = {
    -1,
    1,
}


def check_hexa_linear_working_mode_type_0_item(value: int) -> HexaLinearWorkingModeType0Item:
    if value in HEXA_LINEAR_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {HEXA_LINEAR_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
