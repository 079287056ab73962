from typing import Literal

FrictionTorqueResultContact = Literal["approach_end", "explicit", "mean", "pitch", "recess_end", "worst"]

FRICTION_TORQUE_RESULT_CONTACT_VALUES: set[FrictionTorqueResultContact] = {
    "approach_end",
    "explicit",
    "mean",
    "pitch",
    "recess_end",
    "worst",
}


def check_friction_torque_result_contact(value: str) -> FrictionTorqueResultContact:
    if value in FRICTION_TORQUE_RESULT_CONTACT_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {FRICTION_TORQUE_RESULT_CONTACT_VALUES!r}")
