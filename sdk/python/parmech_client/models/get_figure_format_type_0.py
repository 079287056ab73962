from typing import Literal

GetFigureFormatType0 = Literal["png", "svg"]

GET_FIGURE_FORMAT_TYPE_0_VALUES: set[GetFigureFormatType0] = {
    "png",
    "svg",
}


def check_get_figure_format_type_0(value: str) -> GetFigureFormatType0:
    if value in GET_FIGURE_FORMAT_TYPE_0_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {GET_FIGURE_FORMAT_TYPE_0_VALUES!r}")
