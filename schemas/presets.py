"""Machines with published dimensions."""

import math
from collections.abc import Sequence

from schemas.custom import Custom, CustomLeg, RailLeg, StrutLeg
from schemas.families import (
    DeltaLinear,
    DeltaLinear4Dof,
    DeltaRotary,
    FiveBar,
    GoughStewart,
    Planar3RRR,
    Spherical3RRR,
)
from schemas.hexapods import HEXAPODS
from schemas.kinds import Preset
from schemas.legged import ActuatorLimit

PAPER_2016 = (
    "Laryushkin P.A., Glazunov V.A., Erastova K.G. Computation of the maximal actuation efforts "
    "in parallel manipulators at a specified value of external load. Mechanical Engineering and "
    "Engineering Education, 2016, no. 2(47), pp. 40-46."
)
PAPER_2017 = (
    "Erastova K.G., Laryushkin P.A. Workspaces of parallel mechanisms and methods of determining "
    "their shape and size. 2017, no. 8, pp. 78-87, doi:10.18698/0536-1044-2017-8-78-87."
)

PAPER_2019 = (
    "Laryushkin P.A., Erastova K.G., Filippov G.S., Kheilo S.V. On Delta-type mechanisms with "
    "linear drives and various numbers of degrees of freedom. Journal of Machinery Manufacture and "
    "Reliability, 2019, doi:10.1134/S0235711919030106."
)

# The limit switches stand at (-+0.11, -0.05) m and are 5 mm in size: seen from the base joint,
# sqrt(0.05^2 + 0.05^2) m away, a crank stops this much before 45 degrees below the base line.
# The other end is the stand's, whose place is not printed: the switch's mirror image is taken.
_SWITCH = math.asin(0.005 / math.hypot(0.05, 0.05))


def _orthoglide() -> Custom:
    """Return three rails along x, y and z, each with a parallelogram of unit length."""
    axes: Sequence[list[float]] = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])
    legs: list[CustomLeg] = [
        RailLeg(
            drive="rail",
            base_point=[0.0, 0.0, 0.0],
            direction=axis,
            rod_length=1.0,
            platform_point=[0.0, 0.0, 0.0],
        )
        for axis in axes
    ]
    return Custom(kind="custom", name="Orthoglide, rods of 1 m", motion="translation", legs=legs)


def _hannover_3rpr() -> Custom:
    """Return three struts between equilateral triangles; the pose is that of the platform's apex.

    Its base joints can be shifted before work; here they stand unshifted.
    """
    apex, low = 0.2 * math.sqrt(27.0), -0.125 * math.sqrt(3.0)
    corners = (
        ([0.6, apex, 0.0], [0.0, 0.0, 0.0]),
        ([0.0, 0.0, 0.0], [-0.125, low, 0.0]),
        ([1.2, 0.0, 0.0], [0.125, low, 0.0]),
    )
    legs: list[CustomLeg] = [
        StrutLeg(drive="strut", base_point=base, platform_point=platform)
        for base, platform in corners
    ]
    return Custom(
        kind="custom",
        name="Planar 3-RPR of Hannover, base joints unshifted",
        motion="planar",
        legs=legs,
        actuator_limits=ActuatorLimit(min=0.1, max=1.2),
    )


PRESETS = (
    Preset(
        name="five_bar_printer_2017",
        title="Five-bar of a 3-D printer with limit switches",
        source=PAPER_2017
        + " The stand's stops are not printed: the mirror images of the limit switches are taken.",
        mechanism=FiveBar(
            kind="five_bar",
            name="Five-bar of Erastova and Laryushkin, 2017",
            base_distance=0.12,
            crank_length=0.16,
            rod_length=0.22,
            actuator_limits=[
                ActuatorLimit(min=-0.25 * math.pi + _SWITCH, max=1.25 * math.pi - _SWITCH),
                ActuatorLimit(min=-0.25 * math.pi + _SWITCH, max=1.25 * math.pi - _SWITCH),
            ],
        ),
    ),
    Preset(
        name="planar_3rrr_2016",
        title="Planar 3-RRR of an effort study",
        source=PAPER_2016,
        mechanism=Planar3RRR(
            kind="planar_3rrr",
            name="3-RRR of Laryushkin et al., 2016",
            base_side=0.4,
            platform_radius=0.08,
            crank_length=0.18,
            rod_length=0.18,
        ),
    ),
    Preset(
        name="kossel_mini",
        title="Kossel mini, a 3-D printer's linear Delta",
        source="Rocholl J.C., Kossel; dimensions from the data set data_Kossel_mini.scad of "
        "Rouzeau P., OpenSCAD-Delta-Simulator, 2015: columns' inner radius 144 mm, carriage offset "
        "19.5 mm, effector offset 20 mm, arms 213.5 mm, nozzle 40 mm below.",
        mechanism=DeltaLinear(
            kind="delta_linear",
            name="Kossel mini",
            rail_radius=0.144,
            platform_radius=0.02,
            rod_length=0.2135,
            carriage_arm=0.0195,
            tool_offset=0.04,
        ),
    ),
    Preset(
        name="flexpicker",
        title="ABB FlexPicker IRB 360-1/1600, a pick-and-place Delta",
        source="Williams R.L. II. The Delta Parallel Robot: Kinematics Solutions. Ohio University, "
        "2016. Its example's base triangle of side 567 mm, platform triangle of side 76 mm, upper "
        "links 524 mm and lower links 1244 mm as given in the repository "
        "Pieces98/Deltarobot_Kinematics.",
        mechanism=DeltaRotary(
            kind="delta_rotary",
            name="ABB FlexPicker IRB 360-1/1600",
            # Cranks at the middles of the base triangle's sides, rods at the platform's corners.
            base_radius=0.567 / (2.0 * math.sqrt(3.0)),
            platform_radius=0.076 / math.sqrt(3.0),
            crank_length=0.524,
            rod_length=1.244,
        ),
    ),
    Preset(
        name="delta_linear_4dof_2019",
        title="Delta with linear drives and four degrees of freedom",
        source=PAPER_2019,
        mechanism=DeltaLinear4Dof(
            kind="delta_linear_4dof",
            name="4-DOF Delta of Laryushkin et al., 2019",
            rail_x=0.2,
            rail_y=0.24,
            carriage_arm=0.05,
            rod_length=0.3,
            platform_arm=0.08,
            rod_arm=0.04,
            rod_spacing=0.08,
            tool_offset=0.05,
            actuator_limits=ActuatorLimit(min=0.3, max=0.75),
        ),
    ),
    Preset(
        name="dietmaier_platform",
        title="Gough-Stewart platform with 40 real assembly modes",
        source="Dietmaier P. The Stewart-Gough Platform of General Geometry can have 40 Real "
        "Postures. Advances in Robot Kinematics, 1998.",
        mechanism=GoughStewart(
            kind="gough_stewart",
            name="Dietmaier's platform",
            base_points=[
                [0.0, 0.0, 0.0],
                [1.107915, 0.0, 0.0],
                [0.549094, 0.756063, 0.0],
                [0.735077, -0.223935, 0.525991],
                [0.514188, -0.526063, -0.368418],
                [0.590473, 0.094733, -0.205018],
            ],
            platform_points=[
                [0.0, 0.0, 0.0],
                [0.542805, 0.0, 0.0],
                [0.956919, -0.528915, 0.0],
                [0.665885, -0.353482, 1.402538],
                [0.478359, 1.158742, 0.107672],
                [-0.137087, -0.235121, 0.353913],
            ],
        ),
    ),
    Preset(
        name="agile_eye",
        title="Agile eye, a camera-orienting spherical 3-RRR",
        source="Gosselin C.M., Hamel J.-F. The agile eye: a high-performance "
        "three-degree-of-freedom camera-orienting device. IEEE International Conference on "
        "Robotics and Automation, 1994. Both arcs are right angles, the axes of base and platform "
        "stand at right angles to each other.",
        mechanism=Spherical3RRR(
            kind="spherical_3rrr",
            name="Agile eye",
            proximal_arc=0.5 * math.pi,
            distal_arc=0.5 * math.pi,
            base_cone=math.acos(1.0 / math.sqrt(3.0)),
            platform_cone=math.acos(1.0 / math.sqrt(3.0)),
        ),
    ),
    Preset(
        name="orthoglide",
        title="Orthoglide, three rails at right angles",
        source="Wenger P., Chablat D. Kinematic Analysis of a New Parallel Machine Tool: the "
        "Orthoglide. Advances in Robot Kinematics, 2000. Its kinematics scale with the rods, here "
        "1 m.",
        mechanism=_orthoglide(),
    ),
    Preset(
        name="planar_3rpr_hannover",
        title="Planar 3-RPR of a study of kinematic redundancy",
        source="Influence of kinematic redundancy on the singularity-free workspace of parallel "
        "kinematic machines. 2012, doi:10.1007/s11465-012-0321-8. Dimensions after the Institute "
        "of Mechatronic Systems in Hannover as given in the repository rshuka/PASS, "
        "parallel_kinematic_machine_3PRPR.",
        mechanism=_hannover_3rpr(),
    ),
    *HEXAPODS,
)
