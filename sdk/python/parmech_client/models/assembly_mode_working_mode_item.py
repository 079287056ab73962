from typing import Literal

AssemblyModeWorkingModeItem = Literal[-1, 1]

ASSEMBLY_MODE_WORKING_MODE_ITEM_VALUES: set[AssemblyModeWorkingModeItem] = {
    -1,
    1,
}


def check_assembly_mode_working_mode_item(value: int) -> AssemblyModeWorkingModeItem:
    if value in ASSEMBLY_MODE_WORKING_MODE_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {ASSEMBLY_MODE_WORKING_MODE_ITEM_VALUES!r}")
