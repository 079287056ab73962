from typing import Literal

WorkspaceRequestFieldsItem = Literal[
    "actuators", "condition_number", "determinant", "effort", "effort_max", "free_orientation", "pressure_angle"
]

WORKSPACE_REQUEST_FIELDS_ITEM_VALUES: set[WorkspaceRequestFieldsItem] = {
    "actuators",
    "condition_number",
    "determinant",
    "effort",
    "effort_max",
    "free_orientation",
    "pressure_angle",
}


def check_workspace_request_fields_item(value: str) -> WorkspaceRequestFieldsItem:
    if value in WORKSPACE_REQUEST_FIELDS_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_REQUEST_FIELDS_ITEM_VALUES!r}")
