"""What can be wrong with a pair of wheels."""

from mechanics.errors import MechanicsError


class GearError(MechanicsError):
    """Wheels that cannot mesh as described.

    Parameters
    ----------
    message : what was given, what is allowed and by how much it is missed.
    field : names that lead to what is at fault, such as ("input", "profile_shift").
    """

    def __init__(self, message: str, *field: str) -> None:
        super().__init__(message)
        self.field = field
