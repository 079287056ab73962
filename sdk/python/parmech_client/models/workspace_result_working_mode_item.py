from typing import Literal

WorkspaceResultWorkingModeItem = Literal[-1, 1]

WORKSPACE_RESULT_WORKING_MODE_ITEM_VALUES: set[WorkspaceResultWorkingModeItem] = {
    -1,
    1,
}


def check_workspace_result_working_mode_item(value: int) -> WorkspaceResultWorkingModeItem:
    if value in WORKSPACE_RESULT_WORKING_MODE_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_RESULT_WORKING_MODE_ITEM_VALUES!r}")
