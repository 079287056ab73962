from typing import Literal

FiveBarWorkingModeType0Item = Literal[-1, 1]

FIVE_BAR_WORKING_MODE_TYPE_0_ITEM_VALUES: set[FiveBarWorkingModeType0Item] = {
    -1,
    1,
}


def check_five_bar_working_mode_type_0_item(value: int) -> FiveBarWorkingModeType0Item:
    if value in FIVE_BAR_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {FIVE_BAR_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
