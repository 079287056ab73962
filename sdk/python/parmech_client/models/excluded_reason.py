from typing import Literal

ExcludedReason = Literal[
    "actuator_limits",
    "actuator_speed",
    "base_joint_angle",
    "component",
    "condition_number",
    "crank_rod_angle",
    "determinant",
    "effort",
    "platform_joint_angle",
    "pressure_angle",
    "reach",
    "rod_distance",
    "rod_rod_angle",
]

EXCLUDED_REASON_VALUES: set[ExcludedReason] = {
    "actuator_limits",
    "actuator_speed",
    "base_joint_angle",
    "component",
    "condition_number",
    "crank_rod_angle",
    "determinant",
    "effort",
    "platform_joint_angle",
    "pressure_angle",
    "reach",
    "rod_distance",
    "rod_rod_angle",
}


def check_excluded_reason(value: str) -> ExcludedReason:
    if value in EXCLUDED_REASON_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {EXCLUDED_REASON_VALUES!r}")
