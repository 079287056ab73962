from typing import Literal

FrictionTorqueRequestContact = Literal["approach_end", "explicit", "mean", "pitch", "recess_end", "worst"]

FRICTION_TORQUE_REQUEST_CONTACT_VALUES: set[FrictionTorqueRequestContact] = {
    "approach_end",
    "explicit",
    "mean",
    "pitch",
    "recess_end",
    "worst",
}


def check_friction_torque_request_contact(value: str) -> FrictionTorqueRequestContact:
    if value in FRICTION_TORQUE_REQUEST_CONTACT_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {FRICTION_TORQUE_REQUEST_CONTACT_VALUES!r}")
