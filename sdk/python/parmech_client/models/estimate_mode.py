from typing import Literal

EstimateMode = Literal["job", "sync"]

ESTIMATE_MODE_VALUES: set[EstimateMode] = {
    "job",
    "sync",
}


def check_estimate_mode(value: str) -> EstimateMode:
    if value in ESTIMATE_MODE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {ESTIMATE_MODE_VALUES!r}")
