from typing import Literal

GetGridFormatType0 = Literal["csv", "npz"]

GET_GRID_FORMAT_TYPE_0_VALUES: set[GetGridFormatType0] = {
    "csv",
    "npz",
}


def check_get_grid_format_type_0(value: str) -> GetGridFormatType0:
    if value in GET_GRID_FORMAT_TYPE_0_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {GET_GRID_FORMAT_TYPE_0_VALUES!r}")
