"""What can be wrong with what `mechanics` is asked; each error carries the offending values."""


class MechanicsError(ValueError):
    """A question about a mechanism that makes no sense."""


class GeometryError(MechanicsError):
    """Dimensions from which no mechanism can be built."""

    def __init__(self, message: str, *, leg: int | None = None) -> None:
        super().__init__(message)
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
