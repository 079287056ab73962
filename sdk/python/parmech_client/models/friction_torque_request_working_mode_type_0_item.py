from typing import Literal

FrictionTorqueRequestWorkingModeType0Item = Literal[-1, 1]

FRICTION_TORQUE_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES: set[FrictionTorqueRequestWorkingModeType0Item] = {
    -1,
    1,
}


def check_friction_torque_request_working_mode_type_0_item(value: int) -> FrictionTorqueRequestWorkingModeType0Item:
    if value in FRICTION_TORQUE_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {FRICTION_TORQUE_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES!r}"
    )
