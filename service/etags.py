"""Conditional requests."""


def is_known(etag: str, if_none_match: str | None) -> bool:
    """Return whether an If-None-Match header names this entity, strong or weak, or any."""
    if if_none_match is None:
        return False
    given = [tag.strip().removeprefix("W/") for tag in if_none_match.split(",")]
    return "*" in given or etag in given
