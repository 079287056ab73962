from typing import Literal

SingularityResultWorkingModeItem = Literal[-1, 1]

SINGULARITY_RESULT_WORKING_MODE_ITEM_VALUES: set[SingularityResultWorkingModeItem] = {
    -1,
    1,
}


def check_singularity_result_working_mode_item(value: int) -> SingularityResultWorkingModeItem:
    if value in SINGULARITY_RESULT_WORKING_MODE_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {SINGULARITY_RESULT_WORKING_MODE_ITEM_VALUES!r}")
