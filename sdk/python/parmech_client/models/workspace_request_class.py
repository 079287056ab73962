from typing import Literal

WorkspaceRequestClass = Literal["constructive", "effective", "theoretical"]

WORKSPACE_REQUEST_CLASS_VALUES: set[WorkspaceRequestClass] = {
    "constructive",
    "effective",
    "theoretical",
}


def check_workspace_request_class(value: str) -> WorkspaceRequestClass:
    if value in WORKSPACE_REQUEST_CLASS_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_REQUEST_CLASS_VALUES!r}")
