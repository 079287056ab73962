from typing import Literal

FrictionTorqueRequestSense = Literal["back_driving", "driving"]

FRICTION_TORQUE_REQUEST_SENSE_VALUES: set[FrictionTorqueRequestSense] = {
    "back_driving",
    "driving",
}


def check_friction_torque_request_sense(value: str) -> FrictionTorqueRequestSense:
    if value in FRICTION_TORQUE_REQUEST_SENSE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {FRICTION_TORQUE_REQUEST_SENSE_VALUES!r}")
