from typing import Literal

WorkspaceResultWorkingModeType0Item = Literal[-1, 1]

WORKSPACE_RESULT_WORKING_MODE_TYPE_0_ITEM_VALUES: set[WorkspaceResultWorkingModeType0Item] = {
    -1,
    1,
}


def check_workspace_result_working_mode_type_0_item(value: int) -> WorkspaceResultWorkingModeType0Item:
    if value in WORKSPACE_RESULT_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_RESULT_WORKING_MODE_TYPE_0_ITEM_VALUES!r}")
