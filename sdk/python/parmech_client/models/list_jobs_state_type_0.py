from typing import Literal

ListJobsStateType0 = Literal["accepted", "cancelled", "failed", "running", "successful"]

LIST_JOBS_STATE_TYPE_0_VALUES: set[ListJobsStateType0] = {
    "accepted",
    "cancelled",
    "failed",
    "running",
    "successful",
}


def check_list_jobs_state_type_0(value: str) -> ListJobsStateType0:
    if value in LIST_JOBS_STATE_TYPE_0_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {LIST_JOBS_STATE_TYPE_0_VALUES!r}")
