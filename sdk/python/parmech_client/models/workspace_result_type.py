from typing import Literal

WorkspaceResultType = Literal[
    "constant_orientation", "full", "inclusive_orientation", "maximal", "orientation", "orientation_range"
]

WORKSPACE_RESULT_TYPE_VALUES: set[WorkspaceResultType] = {
    "constant_orientation",
    "full",
    "inclusive_orientation",
    "maximal",
    "orientation",
    "orientation_range",
}


def check_workspace_result_type(value: str) -> WorkspaceResultType:
    if value in WORKSPACE_RESULT_TYPE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_RESULT_TYPE_VALUES!r}")
