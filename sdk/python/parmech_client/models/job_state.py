from typing import Literal

JobState = Literal["accepted", "cancelled", "failed", "running", "successful"]

JOB_STATE_VALUES: set[JobState] = {
    "accepted",
    "cancelled",
    "failed",
    "running",
    "successful",
}


def check_job_state(value: str) -> JobState:
    if value in JOB_STATE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {JOB_STATE_VALUES!r}")
