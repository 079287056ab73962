from typing import Literal

InverseKinematicsAllModesResultWorkingModesItemItem = Literal[-1, 1]

INVERSE_KINEMATICS_ALL_MODES_RESULT_WORKING_MODES_ITEM_ITEM_VALUES: set[
    InverseKinematicsAllModesResultWorkingModesItemItem
] = {
    -1,
    1,
}


def check_inverse_kinematics_all_modes_result_working_modes_item_item(
    value: int,
) -> InverseKinematicsAllModesResultWorkingModesItemItem:
    if value in INVERSE_KINEMATICS_ALL_MODES_RESULT_WORKING_MODES_ITEM_ITEM_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {INVERSE_KINEMATICS_ALL_MODES_RESULT_WORKING_MODES_ITEM_ITEM_VALUES!r}"
    )
