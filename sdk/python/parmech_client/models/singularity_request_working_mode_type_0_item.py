from typing import Literal

SingularityRequestWorkingModeType0Item = Literal[-1, 1]

SINGULARITY_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES: set[SingularityRequestWorkingModeType0Item] = {
    -1,
    1,
}


def check_singularity_request_working_mode_type_0_item(value: int) -> SingularityRequestWorkingModeType0Item:
    if value in SINGULARITY_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {SINGULARITY_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES!r}"
    )
