"""Arrays to bytes and back, bit for bit."""

import zipfile
from collections.abc import Mapping
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

Arrays = dict[str, NDArray[Any]]


def pack_arrays(arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """Return named arrays as one compressed file that `numpy.load` reads.

    Raises
    ------
    ValueError : An array holds Python objects.
    """
    file = BytesIO()
    # Level 1: a third of the default's time for a few per cent more bytes.
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for name, array in arrays.items():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as entry:
                np.lib.format.write_array(entry, np.asanyarray(array), allow_pickle=False)
    return file.getvalue()


def unpack_arrays(packed: bytes) -> Arrays:
    """Return the arrays that `pack_arrays` packed, in their order."""
    with np.load(BytesIO(packed), allow_pickle=False) as archive:
        return {name: archive[name] for name in archive.files}
