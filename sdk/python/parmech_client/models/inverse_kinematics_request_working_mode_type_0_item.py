from typing import Literal

InverseKinematicsRequestWorkingModeType0Item = Literal[-1, 1]

INVERSE_KINEMATICS_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES: set[InverseKinematicsRequestWorkingModeType0Item] = {
    -1,
    1,
}


def check_inverse_kinematics_request_working_mode_type_0_item(
    value: int,
) -> InverseKinematicsRequestWorkingModeType0Item:
    if value in INVERSE_KINEMATICS_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {INVERSE_KINEMATICS_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES!r}"
    )
