from typing import Literal

JobErrorKind = Literal["lost", "memory", "system", "timeout", "user"]

JOB_ERROR_KIND_VALUES: set[JobErrorKind] = {
    "lost",
    "memory",
    "system",
    "timeout",
    "user",
}


def check_job_error_kind(value: str) -> JobErrorKind:
    if value in JOB_ERROR_KIND_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {JOB_ERROR_KIND_VALUES!r}")
