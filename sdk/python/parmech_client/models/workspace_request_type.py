from typing import Literal

WorkspaceRequestType = Literal[
    "constant_orientation", "full", "inclusive_orientation", "maximal", "orientation", "orientation_range"
]

WORKSPACE_REQUEST_TYPE_VALUES: set[WorkspaceRequestType] = {
    "constant_orientation",
    "full",
    "inclusive_orientation",
    "maximal",
    "orientation",
    "orientation_range",
}


def check_workspace_request_type(value: str) -> WorkspaceRequestType:
    if value in WORKSPACE_REQUEST_TYPE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_REQUEST_TYPE_VALUES!r}")
