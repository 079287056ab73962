from typing import Literal

Translational3RRRRWorkingModeType0Item = Literal[-1, 1]

TRANSLATIONAL_3RRRR_WORKING_MODE_TYPE_0_ITEM_VALUES: set[Translational3RRRRWorkingModeType0Item] = {
    -1,
    1,
}


def check_translational_3rrrr_working_mode_type_0_item(value: int) -> Translational3RRRRWorkingModeType0Item:
    if value in TRANSLATIONAL_3RRRR_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {TRANSLATIONAL_3RRRR_WORKING_MODE_TYPE_0_ITEM_VALUES!r}"
    )
