from typing import Literal

WorkspaceRequestComponent = Literal["all", "home"]

WORKSPACE_REQUEST_COMPONENT_VALUES: set[WorkspaceRequestComponent] = {
    "all",
    "home",
}


def check_workspace_request_component(value: str) -> WorkspaceRequestComponent:
    if value in WORKSPACE_REQUEST_COMPONENT_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_REQUEST_COMPONENT_VALUES!r}")
