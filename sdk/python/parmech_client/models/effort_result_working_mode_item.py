from typing import Literal

EffortResultWorkingModeItem = Literal[-1, 1]

EFFORT_RESULT_WORKING_MODE_ITEM_VALUES: set[EffortResultWorkingModeItem] = {
    -1,
    1,
}


def check_effort_result_working_mode_item(value: int) -> EffortResultWorkingModeItem:
    if value in EFFORT_RESULT_WORKING_MODE_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {EFFORT_RESULT_WORKING_MODE_ITEM_VALUES!r}")
