from typing import Literal

DesignMeshFace = Literal["bevel", "spur"]

DESIGN_MESH_FACE_VALUES: set[DesignMeshFace] = {
    "bevel",
    "spur",
}


def check_design_mesh_face(value: str) -> DesignMeshFace:
    if value in DESIGN_MESH_FACE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {DESIGN_MESH_FACE_VALUES!r}")
