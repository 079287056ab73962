"""What does not make sense to ask."""


class AnalysisError(ValueError):
    """A well-formed request that makes no sense for its mechanism.

    Parameters
    ----------
    errors : pairs of a JSON pointer into the request and what is wrong there.
    """

    def __init__(self, *errors: tuple[str, str]) -> None:
        super().__init__("; ".join(f"{pointer}: {detail}" for pointer, detail in errors))
        self.errors = errors

    @property
    def detail(self) -> str:
        """All that is wrong, in one line."""
        return str(self)


def pointer(*steps: object) -> str:
    """Return the JSON pointer of these steps, RFC 6901."""
    return "".join("/" + str(step).replace("~", "~0").replace("/", "~1") for step in steps)
