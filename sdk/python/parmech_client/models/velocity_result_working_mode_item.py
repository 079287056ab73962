from typing import Literal

VelocityResultWorkingModeItem = Literal[-1, 1]

VELOCITY_RESULT_WORKING_MODE_ITEM_VALUES: set[VelocityResultWorkingModeItem] = {
    -1,
    1,
}


def check_velocity_result_working_mode_item(value: int) -> VelocityResultWorkingModeItem:
    if value in VELOCITY_RESULT_WORKING_MODE_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {VELOCITY_RESULT_WORKING_MODE_ITEM_VALUES!r}")
