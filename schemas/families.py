"""Mechanism families on the wire. Lengths in m, angles in rad."""

from typing import Annotated, Literal

from pydantic import Field

from schemas.legged import LeggedMechanism, Vector
from schemas.quantities import Finite, Length, Size


class FiveBar(LeggedMechanism):
    """Two cranks in the plane whose rods meet in the platform's point.

    Base joints at (-base_distance/2, 0) and (base_distance/2, 0); cranks turn about +z from +x.
    """

    drive_count = 2
    default_working_mode = (1, -1)

    kind: Literal["five_bar"]
    base_distance: Length = Field(description="Between the base joints. [m]")
    crank_length: Length = Field(description="[m]")
    rod_length: Length = Field(description="[m]")


class Planar3RRR(LeggedMechanism):
    """A triangular platform in the plane on three cranks and rods.

    The origin is the base triangle's centroid; vertices at 90, 210 and 330 degrees, the
    platform's likewise at phi = 0; cranks turn about +z from +x.
    """

    drive_count = 3

    kind: Literal["planar_3rrr"]
    base_side: Length = Field(description="Side of the base triangle. [m]")
    platform_radius: Length = Field(description="Circumradius of the platform triangle. [m]")
    crank_length: Length = Field(description="[m]")
    rod_length: Length = Field(description="[m]")


class Translational3RRRR(LeggedMechanism):
    """Three translations from three cranks about x, y and z; all rods end in one point.

    The crank about x passes through base_radius (0, 1, 0), that about y through (0, 0, 1) and
    that about z through (1, 0, 0); a crank of angle 0 points along the axis after its own.
    """

    drive_count = 3

    kind: Literal["translational_3rrrr"]
    link_length: Length = Field(description="Of every crank and every rod. [m]")
    base_radius: Length = Field(description="Of the drives from the origin. [m]")


class DeltaRotary(LeggedMechanism):
    """The Delta with cranks: three translations, base plane z = 0, platform below.

    Legs at 90, 210 and 330 degrees; a crank of angle 0 points outward and turns upward; working
    mode 1 has the knees out.
    """

    drive_count = 3

    kind: Literal["delta_rotary"]
    base_radius: Length = Field(description="Of the crank axes. [m]")
    platform_radius: Length = Field(description="Of the platform's joints. [m]")
    crank_length: Length = Field(description="[m]")
    rod_length: Length = Field(description="[m]")


class UprightRails(LeggedMechanism):
    """Three upright rails at 90, 210 and 330 degrees, and rods to one body."""

    rail_radius: Length = Field(description="Circle of the rails. [m]")
    platform_radius: Length = Field(description="Circle of the platform's joints. [m]")
    rod_length: Length = Field(description="[m]")
    carriage_arm: Size = Field(description="From a rail inward to the carriage's joint. [m]")


class DeltaLinear(UprightRails):
    """The Delta on upright rails at 90, 210 and 330 degrees: three translations.

    A drive's coordinate is its carriage's height; working mode 1 has the carriages above.
    """

    drive_count = 3

    kind: Literal["delta_linear"]
    tool_offset: Finite = Field(description="Of the tool's point below the joints. [m]")


class DeltaLinear4Dof(LeggedMechanism):
    """The Delta on upright rails with two parallelograms and two rods; it also turns about y.

    Legs in order: parallelogram at (+rail_x, 0), rod at (+rod_spacing/2, rail_y), rod at
    (-rod_spacing/2, rail_y), parallelogram at (-rail_x, 0).
    """

    drive_count = 4

    kind: Literal["delta_linear_4dof"]
    rail_x: Length = Field(description="Of the parallelograms' rails from the origin. [m]")
    rail_y: Length = Field(description="Of the rods' rails from the plane y = 0. [m]")
    carriage_arm: Size = Field(description="From a rail inward to the carriage's joint. [m]")
    rod_length: Length = Field(description="Of parallelograms and rods. [m]")
    platform_arm: Size = Field(description="From the tool's axis to the parallelograms. [m]")
    rod_arm: Size = Field(description="From the tool's axis to the rods. [m]")
    rod_spacing: Length = Field(description="Between the rods. [m]")
    tool_offset: Finite = Field(description="Of the tool's point below the joints. [m]")


Points6 = Annotated[list[Vector], Field(min_length=6, max_length=6)]


class GoughStewart(LeggedMechanism):
    """The 6-SPS hexapod: six telescopic struts between ball joints; drives are their lengths."""

    drive_count = 6

    kind: Literal["gough_stewart"]
    base_points: Points6 = Field(description="[m]")
    platform_points: Points6 = Field(description="In the platform's frame. [m]")


class HexaLinear(LeggedMechanism):
    """The 6-PUS hexapod: rods of fixed length on carriages along six rails."""

    drive_count = 6

    kind: Literal["hexa_linear"]
    base_points: Points6 = Field(description="The carriages' joints at drive coordinate 0. [m]")
    rail_directions: Points6 = Field(description="Of any length but 0.")
    rod_length: Length = Field(description="[m]")
    platform_points: Points6 = Field(description="In the platform's frame. [m]")


class HexaRotary(LeggedMechanism):
    """The 6-RUS hexapod: rods of fixed length on six cranks."""

    drive_count = 6

    kind: Literal["hexa_rotary"]
    base_points: Points6 = Field(description="On the crank axes. [m]")
    crank_axes: Points6 = Field(description="Of any length but 0.")
    crank_zero_directions: Points6 = Field(description="Perpendicular to the axes.")
    crank_length: Length = Field(description="[m]")
    rod_length: Length = Field(description="[m]")
    platform_points: Points6 = Field(description="In the platform's frame. [m]")


Arc = Annotated[float, Field(ge=1e-6, le=3.14159, strict=True, allow_inf_nan=False)]
Cone = Annotated[float, Field(ge=1e-6, le=3.14159, strict=True, allow_inf_nan=False)]


class Spherical3RRR(LeggedMechanism):
    """Three legs of two arcs each whose axes meet in one point: three rotations.

    Base and platform axes stand at 90, 210 and 330 degrees on cones about z, the platform's in
    its own frame; a crank of angle 0 leads its arc away from +z.
    """

    drive_count = 3

    kind: Literal["spherical_3rrr"]
    proximal_arc: Arc = Field(description="From a base axis to the intermediate one. [rad]")
    distal_arc: Arc = Field(description="From the intermediate to a platform axis. [rad]")
    base_cone: Cone = Field(description="Half-angle of the base axes' cone. [rad]")
    platform_cone: Cone = Field(description="Half-angle of the platform axes' cone. [rad]")
