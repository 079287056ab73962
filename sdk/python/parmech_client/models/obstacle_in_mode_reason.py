from typing import Literal

ObstacleInModeReason = Literal["actuator_limits", "reach", "singularity"]

OBSTACLE_IN_MODE_REASON_VALUES: set[ObstacleInModeReason] = {
    "actuator_limits",
    "reach",
    "singularity",
}


def check_obstacle_in_mode_reason(value: str) -> ObstacleInModeReason:
    if value in OBSTACLE_IN_MODE_REASON_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {OBSTACLE_IN_MODE_REASON_VALUES!r}")
