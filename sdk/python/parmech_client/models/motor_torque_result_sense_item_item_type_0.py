from typing import Literal

MotorTorqueResultSenseItemItemType0 = Literal["back_driving", "driving"]

MOTOR_TORQUE_RESULT_SENSE_ITEM_ITEM_TYPE_0_VALUES: set[MotorTorqueResultSenseItemItemType0] = {
    "back_driving",
    "driving",
}


def check_motor_torque_result_sense_item_item_type_0(value: str) -> MotorTorqueResultSenseItemItemType0:
    if value in MOTOR_TORQUE_RESULT_SENSE_ITEM_ITEM_TYPE_0_VALUES:
        return value
    raise TypeError(
        f"Unexpected value {value!r}. Expected one of {MOTOR_TORQUE_RESULT_SENSE_ITEM_ITEM_TYPE_0_VALUES!r}"
    )
