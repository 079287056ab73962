from typing import Literal

DeltaLinear4DofWorkingModeType0Item = Literal[-1, 1]

DELTA_LINEAR_4_DOF_WORKING_MODE_TYPE_0_ITEM_VALUES: set[DeltaLinear4DofWorkingModeType0Item] = {
    -1,
    1,
}


def check_delta_linear_4_dof_working_mode_type_0_item(value: int) -> DeltaLinear4DofWorkingModeType0Item:
    if value in DELTA_LINEAR_4_DOF_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {DELTA_LINEAR_4_DOF_WORKING_MODE_TYPE_0_ITEM_VALUES!r}"
    )
