from typing import Literal

VelocityRequestWorkingModeType0Item = Literal[-1, 1]

VELOCITY_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES: set[VelocityRequestWorkingModeType0Item] = {
    -1,
    1,
}


def check_velocity_request_working_mode_type_0_item(value: int) -> VelocityRequestWorkingModeType0Item:
    if value in VELOCITY_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {VELOCITY_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
