"""What can be wrong with data that is to be exported."""


class ExportError(Exception):
    """Data cannot be written as asked."""


class ColumnError(ExportError):
    """A column of a grid does not hold what it declares.

    Parameters
    ----------
    column : str
        Name of the column.
    expected, found : object
        What the column declares (a shape, a dtype, a number of nodes) and what it yielded.
    """

    def __init__(self, column: str, expected: object, found: object) -> None:
        super().__init__(f"column {column!r}: expected {expected}, found {found}")
        self.column = column
        self.expected = expected
        self.found = found


class PictureError(ExportError):
    """The parts of a picture do not fit together.

    Parameters
    ----------
    part : str
        The part that does not fit.
    expected, found : object
        What the other parts ask for and what was given.
    """

    def __init__(self, part: str, expected: object, found: object) -> None:
        super().__init__(f"{part} of the picture: expected {expected}, found {found}")
        self.part = part
        self.expected = expected
        self.found = found


class FormatError(ExportError):
    """No figure can be drawn in this format.

    Parameters
    ----------
    format : str
        What was asked for.
    allowed : tuple of str
        What is offered.
    """

    def __init__(self, format: str, allowed: tuple[str, ...]) -> None:
        super().__init__(f"figure format {format!r}: expected one of {', '.join(allowed)}")
        self.format = format
        self.allowed = allowed
