from typing import Literal

ObstacleReason = Literal["actuator_limits", "reach", "singularity"]

OBSTACLE_REASON_VALUES: set[ObstacleReason] = {
    "actuator_limits",
    "reach",
    "singularity",
}


def check_obstacle_reason(value: str) -> ObstacleReason:
    if value in OBSTACLE_REASON_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {OBSTACLE_REASON_VALUES!r}")
