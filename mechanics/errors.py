"""What can be wrong with what `mechanics` is asked; each error carries the offending values."""


class MechanicsError(ValueError):
    """A question about a mechanism that makes no sense."""


class GeometryError(MechanicsError):
    """Dimensions from which no mechanism can be built; `leg` is the leg at fault, if it is one."""

    def __init__(self, message: str, *, leg: int | None = None) -> None:
        super().__init__(message if leg is None else f"leg {leg}: {message}")
        self.leg = leg


class NotOfferedError(MechanicsError):
    """A workspace that the geometric method cannot describe; `leg` is the leg at fault, if any."""

    def __init__(self, message: str, *, leg: int | None = None) -> None:
        super().__init__(message if leg is None else f"leg {leg}: {message}")
        self.leg = leg


class PoseError(MechanicsError):
    """Poses whose shape does not fit the mechanism's coordinates."""

    def __init__(self, given: tuple[int, ...], coordinates: tuple[str, ...]) -> None:
        super().__init__(
            f"poses must have shape (poses, {len(coordinates)}), one column each for "
            f"{', '.join(coordinates)}; given {given}"
        )
        self.given = given
        self.coordinates = coordinates


class ActuatorsError(MechanicsError):
    """Drive coordinates whose shape does not fit the mechanism's drives, or the guesses beside."""

    def __init__(self, given: tuple[int, ...], drives: int, *, rows: int | None = None) -> None:
        count = "rows" if rows is None else str(rows)
        super().__init__(
            f"actuators must have shape ({count}, {drives}), one column per drive; given {given}"
        )
        self.given = given
        self.drives = drives


class WorkingModeError(MechanicsError):
    """Signs that are no working mode of the mechanism."""

    def __init__(self, given: tuple[int, ...], drives: int) -> None:
        super().__init__(
            f"must have {drives} signs, one per drive, 1 or -1, and 1 for a strut or a motor; "
            f"given {list(given)}"
        )
        self.given = given
        self.drives = drives


def require_positive(**lengths: float) -> None:
    """Raise GeometryError naming the first length that is not above 0."""
    for name, length in lengths.items():
        if not length > 0.0:
            raise GeometryError(f"{name} must be above 0 m; given {length}")
