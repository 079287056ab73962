"""What the service itself refuses; each is answered as a problem of its own type."""


class Refusal(Exception):  # noqa: N818  (names say what is the case)
    """Something that is asked for and cannot be had.

    Parameters
    ----------
    kind : the problem's type, such as `result-not-ready`.
    status : the HTTP status.
    title, detail : what is the case, in general and here.
    errors : pairs of a JSON pointer and what is wrong there.
    headers : HTTP headers to go with it.
    """

    def __init__(
        self,
        kind: str,
        status: int,
        title: str,
        detail: str,
        errors: tuple[tuple[str, str], ...] = (),
        headers: dict[str, str] | None = None,
    ) -> None:
        super().__init__(detail)
        self.kind = kind
        self.status = status
        self.title = title
        self.detail = detail
        self.errors = errors
        self.headers = headers or {}


def not_found(what: str, identifier: str) -> Refusal:
    """Return the refusal of an unknown id."""
    return Refusal("not-found", 404, "Not found", f"there is no {what} {identifier!r}")


def invalid(pointer: str, detail: str) -> Refusal:
    """Return the refusal of a parameter or field that makes no sense."""
    return Refusal(
        "invalid-request",
        422,
        "The request makes no sense",
        f"{pointer}: {detail}",
        ((pointer, detail),),
    )
