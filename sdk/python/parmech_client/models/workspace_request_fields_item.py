from typing import Literal

WorkspaceRequestFieldsItem = Literal["actuators", "determinant", "effort", "effort_max"]

WORKSPACE_REQUEST_FIELDS_ITEM_VALUES: set[WorkspaceRequestFieldsItem] = {
    "actuators",
    "determinant",
    "effort",
    "effort_max",
}


def check_workspace_request_fields_item(value: str) -> WorkspaceRequestFieldsItem:
    if value in WORKSPACE_REQUEST_FIELDS_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_REQUEST_FIELDS_ITEM_VALUES!r}")
