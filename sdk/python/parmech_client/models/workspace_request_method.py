from typing import Literal

WorkspaceRequestMethod = Literal["geometric", "grid"]

WORKSPACE_REQUEST_METHOD_VALUES: set[WorkspaceRequestMethod] = {
    "geometric",
    "grid",
}


def check_workspace_request_method(value: str) -> WorkspaceRequestMethod:
    if value in WORKSPACE_REQUEST_METHOD_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_REQUEST_METHOD_VALUES!r}")
