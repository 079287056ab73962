from typing import Literal

EffortRequestWorkingModeType0Item = Literal[-1, 1]

EFFORT_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES: set[EffortRequestWorkingModeType0Item] = {
    -1,
    1,
}


def check_effort_request_working_mode_type_0_item(value: int) -> EffortRequestWorkingModeType0Item:
    if value in EFFORT_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {EFFORT_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
