from typing import Literal

GearedDecoupledWorkingModeType0Item = Literal[-1, 1]

GEARED_DECOUPLED_WORKING_MODE_TYPE_0_ITEM_VALUES: set[GearedDecoupledWorkingModeType0Item] = {
    -1,
    1,
}


def check_geared_decoupled_working_mode_type_0_item(value: int) -> GearedDecoupledWorkingModeType0Item:
    if value in GEARED_DECOUPLED_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {GEARED_DECOUPLED_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
