from typing import Literal

WorkspaceRequestWorkingModeType0Item = Literal[-1, 1]

WORKSPACE_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES: set[WorkspaceRequestWorkingModeType0Item] = {
    -1,
    1,
}


def check_workspace_request_working_mode_type_0_item(value: int) -> WorkspaceRequestWorkingModeType0Item:
    if value in WORKSPACE_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {WORKSPACE_REQUEST_WORKING_MODE_TYPE_0_ITEM_VALUES!r}"
    )
