from typing import Literal

FrictionTorqueResultSense = Literal["back_driving", "driving"]

FRICTION_TORQUE_RESULT_SENSE_VALUES: set[FrictionTorqueResultSense] = {
    "back_driving",
    "driving",
}


def check_friction_torque_result_sense(value: str) -> FrictionTorqueResultSense:
    if value in FRICTION_TORQUE_RESULT_SENSE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {FRICTION_TORQUE_RESULT_SENSE_VALUES!r}")
