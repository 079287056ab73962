from typing import Literal

MotorTorqueResultWorkingModeItem = Literal[-1, 1]

MOTOR_TORQUE_RESULT_WORKING_MODE_ITEM_VALUES: set[MotorTorqueResultWorkingModeItem] = {
    -1,
    1,
}


def check_motor_torque_result_working_mode_item(value: int) -> MotorTorqueResultWorkingModeItem:
    if value in MOTOR_TORQUE_RESULT_WORKING_MODE_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {MOTOR_TORQUE_RESULT_WORKING_MODE_ITEM_VALUES!r}")
