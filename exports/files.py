"""Files that are there whole or not at all."""

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO


@contextmanager
def whole_file(path: Path) -> Iterator[BinaryIO]:
    """Yield a binary file that takes its place at `path` only when all went well.

    Readers see the old file or the new one, never a part, and two writers of the same
    path do not mix. A failure leaves nothing behind.

    Parameters
    ----------
    path : pathlib.Path
        Where the file is to stand; its folder must exist.
    """
    # Not of the module `tempfile`, whose files nobody else may read.
    part = path.with_name(f".{path.name}.{secrets.token_hex(8)}.part")
    try:
        with part.open("xb") as file:
            yield file
        os.replace(part, path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def write_whole(path: Path, content: bytes) -> None:
    """Write a file that is there whole or not at all."""
    with whole_file(path) as file:
        file.write(content)
