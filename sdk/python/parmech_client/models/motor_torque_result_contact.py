from typing import Literal

MotorTorqueResultContact = Literal["approach_end", "explicit", "mean", "pitch", "recess_end", "worst"]

MOTOR_TORQUE_RESULT_CONTACT_VALUES: set[MotorTorqueResultContact] = {
    "approach_end",
    "explicit",
    "mean",
    "pitch",
    "recess_end",
    "worst",
}


def check_motor_torque_result_contact(value: str) -> MotorTorqueResultContact:
    if value in MOTOR_TORQUE_RESULT_CONTACT_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {MOTOR_TORQUE_RESULT_CONTACT_VALUES!r}")
