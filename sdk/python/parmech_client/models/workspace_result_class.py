from typing import Literal

WorkspaceResultClass = Literal["constructive", "effective", "theoretical"]

WORKSPACE_RESULT_CLASS_VALUES: set[WorkspaceResultClass] = {
    "constructive",
    "effective",
    "theoretical",
}


def check_workspace_result_class(value: str) -> WorkspaceResultClass:
    if value in WORKSPACE_RESULT_CLASS_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WORKSPACE_RESULT_CLASS_VALUES!r}")
