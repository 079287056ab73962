from typing import Literal

InverseKinematicsResultWorkingModeItem = Literal[-1, 1]

INVERSE_KINEMATICS_RESULT_WORKING_MODE_ITEM_VALUES: set[InverseKinematicsResultWorkingModeItem] = {
    -1,
    1,
}


def check_inverse_kinematics_result_working_mode_item(value: int) -> InverseKinematicsResultWorkingModeItem:
    if value in INVERSE_KINEMATICS_RESULT_WORKING_MODE_ITEM_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {INVERSE_KINEMATICS_RESULT_WORKING_MODE_ITEM_VALUES!r}"
    )
