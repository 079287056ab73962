from typing import Literal

MotorTorqueResultSenseItemItem = Literal["back_driving", "driving"]

MOTOR_TORQUE_RESULT_SENSE_ITEM_ITEM_VALUES: set[MotorTorqueResultSenseItemItem] = {
    "back_driving",
    "driving",
}


def check_motor_torque_result_sense_item_item(value: str) -> MotorTorqueResultSenseItemItem:
    if value in MOTOR_TORQUE_RESULT_SENSE_ITEM_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {MOTOR_TORQUE_RESULT_SENSE_ITEM_ITEM_VALUES!r}")
