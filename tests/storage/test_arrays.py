import numpy as np
import pytest

from storage import pack_arrays, unpack_arrays


@pytest.mark.parametrize(
    "array",
    [
        np.array([0.1, -0.0, np.inf, np.nan, 5e-324]),
        np.frombuffer(b"\x01\x00\x00\x00\x00\x00\xf8\xff", np.float64),
        np.array([True, False]),
        np.arange(6, dtype=np.uint8).reshape(2, 3),
        np.asfortranarray(np.arange(6.0).reshape(2, 3)),
        np.empty((0, 3)),
        np.array(7, dtype=np.int32),
        np.array([1.5], dtype=">f4"),
    ],
)
def test_an_array_comes_back_bit_for_bit(array: np.ndarray) -> None:
    back = unpack_arrays(pack_arrays({"a": array}))["a"]
    assert (back.dtype, back.shape, back.tobytes()) == (array.dtype, array.shape, array.tobytes())


def test_arrays_keep_their_names_and_order() -> None:
    arrays = {"file": np.zeros(1), "z": np.zeros(2), "a": np.zeros(3)}
    assert list(unpack_arrays(pack_arrays(arrays))) == ["file", "z", "a"]


def test_python_objects_are_refused() -> None:
    with pytest.raises(ValueError, match="Object arrays"):
        pack_arrays({"a": np.array([{}], dtype=object)})
