from typing import Literal

AssemblyModeSideType0 = Literal[-1, 1]

ASSEMBLY_MODE_SIDE_TYPE_0_VALUES: set[AssemblyModeSideType0] = {
    -1,
    1,
}


def check_assembly_mode_side_type_0(value: int) -> AssemblyModeSideType0:
    if value in ASSEMBLY_MODE_SIDE_TYPE_0_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {ASSEMBLY_MODE_SIDE_TYPE_0_VALUES!r}")
