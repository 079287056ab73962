"""Contains all the data models used in inputs/outputs"""

from .actuator_limit import ActuatorLimit
from .arc import Arc
from .assembly_mode import AssemblyMode
from .assembly_mode_side_type_0 import AssemblyModeSideType0
from .assembly_mode_working_mode_item import AssemblyModeWorkingModeItem
from .bounds import Bounds
from .component import Component
from .component_centroid import ComponentCentroid
from .constructive import Constructive
from .crank_leg import CrankLeg
from .custom import Custom
from .custom_motion import CustomMotion
from .custom_working_mode_type_0_item import CustomWorkingModeType0Item
from .delta_linear import DeltaLinear
from .delta_linear_4_dof import DeltaLinear4Dof
from .delta_linear_4_dof_working_mode_type_0_item import DeltaLinear4DofWorkingModeType0Item
from .delta_linear_working_mode_type_0_item import DeltaLinearWorkingModeType0Item
from .delta_rotary import DeltaRotary
from .delta_rotary_working_mode_type_0_item import DeltaRotaryWorkingModeType0Item
from .design_mesh import DesignMesh
from .design_mesh_face import DesignMeshFace
from .effective import Effective
from .effort_request import EffortRequest
from .effort_request_working_mode_type_0_item import EffortRequestWorkingModeType0Item
from .effort_result import EffortResult
from .effort_result_working_mode_item import EffortResultWorkingModeItem
from .estimate import Estimate
from .estimate_mode import EstimateMode
from .excluded import Excluded
from .excluded_reason import ExcludedReason
from .explicit_mesh import ExplicitMesh
from .field_fault import FieldFault
from .field_problem import FieldProblem
from .field_summary import FieldSummary
from .field_summary_at_max_type_0 import FieldSummaryAtMaxType0
from .five_bar import FiveBar
from .five_bar_working_mode_type_0_item import FiveBarWorkingModeType0Item
from .forward_kinematics_guess_result import ForwardKinematicsGuessResult
from .forward_kinematics_request import ForwardKinematicsRequest
from .forward_kinematics_result import ForwardKinematicsResult
from .friction_torque_request import FrictionTorqueRequest
from .friction_torque_request_contact import FrictionTorqueRequestContact
from .friction_torque_request_sense import FrictionTorqueRequestSense
from .friction_torque_request_working_mode_type_0_item import FrictionTorqueRequestWorkingModeType0Item
from .friction_torque_result import FrictionTorqueResult
from .friction_torque_result_contact import FrictionTorqueResultContact
from .friction_torque_result_sense import FrictionTorqueResultSense
from .gear_stage import GearStage
from .geared_decoupled import GearedDecoupled
from .geared_decoupled_working_mode_type_0_item import GearedDecoupledWorkingModeType0Item
from .get_figure_format_type_0 import GetFigureFormatType0
from .get_grid_format_type_0 import GetGridFormatType0
from .gough_stewart import GoughStewart
from .gough_stewart_working_mode_type_0_item import GoughStewartWorkingModeType0Item
from .grid_axis import GridAxis
from .health import Health
from .hexa_linear import HexaLinear
from .hexa_linear_working_mode_type_0_item import HexaLinearWorkingModeType0Item
from .hexa_rotary import HexaRotary
from .hexa_rotary_working_mode_type_0_item import HexaRotaryWorkingModeType0Item
from .histogram import Histogram
from .inscribed import Inscribed
from .inscribed_ball import InscribedBall
from .inscribed_ball_centre import InscribedBallCentre
from .inscribed_box import InscribedBox
from .inscribed_box_max import InscribedBoxMax
from .inscribed_box_min import InscribedBoxMin
from .inverse_kinematics_all_modes_result import InverseKinematicsAllModesResult
from .inverse_kinematics_all_modes_result_working_modes_item_item import (
    InverseKinematicsAllModesResultWorkingModesItemItem,
)
from .inverse_kinematics_request import InverseKinematicsRequest
from .inverse_kinematics_request_working_mode_type_0_item import InverseKinematicsRequestWorkingModeType0Item
from .inverse_kinematics_result import InverseKinematicsResult
from .inverse_kinematics_result_working_mode_item import InverseKinematicsResultWorkingModeItem
from .iteration import Iteration
from .job import Job
from .job_error import JobError
from .job_error_kind import JobErrorKind
from .job_page import JobPage
from .job_state import JobState
from .kind import Kind
from .kind_json_schema import KindJsonSchema
from .kind_page import KindPage
from .known_load import KnownLoad
from .links import Links
from .list_jobs_state_type_0 import ListJobsStateType0
from .load_size import LoadSize
from .measure import Measure
from .mechanism_page import MechanismPage
from .mesh_curve import MeshCurve
from .mesh_geometry import MeshGeometry
from .motor_torque_result import MotorTorqueResult
from .motor_torque_result_contact import MotorTorqueResultContact
from .motor_torque_result_sense_item_item_type_0 import MotorTorqueResultSenseItemItemType0
from .motor_torque_result_working_mode_item import MotorTorqueResultWorkingModeItem
from .obstacle import Obstacle
from .obstacle_in_mode import ObstacleInMode
from .obstacle_in_mode_reason import ObstacleInModeReason
from .obstacle_reason import ObstacleReason
from .orientation_axis import OrientationAxis
from .orientations_tried import OrientationsTried
from .planar_3rrr import Planar3RRR
from .planar_3rrr_working_mode_type_0_item import Planar3RRRWorkingModeType0Item
from .platform_body import PlatformBody
from .platform_speed import PlatformSpeed
from .preset import Preset
from .problem import Problem
from .progress import Progress
from .rail_leg import RailLeg
from .readiness import Readiness
from .singularity_request import SingularityRequest
from .singularity_request_working_mode_type_0_item import SingularityRequestWorkingModeType0Item
from .singularity_result import SingularityResult
from .singularity_result_working_mode_item import SingularityResultWorkingModeItem
from .spherical_3rrr import Spherical3RRR
from .spherical_3rrr_working_mode_type_0_item import Spherical3RRRWorkingModeType0Item
from .stored_mechanism import StoredMechanism
from .stored_mechanism_document import StoredMechanismDocument
from .strut_leg import StrutLeg
from .translational_3rrrr import Translational3RRRR
from .translational_3rrrr_working_mode_type_0_item import Translational3RRRRWorkingModeType0Item
from .velocity_request import VelocityRequest
from .velocity_request_working_mode_type_0_item import VelocityRequestWorkingModeType0Item
from .velocity_result import VelocityResult
from .velocity_result_working_mode_item import VelocityResultWorkingModeItem
from .wheel import Wheel
from .workspace_request import WorkspaceRequest
from .workspace_request_class import WorkspaceRequestClass
from .workspace_request_component import WorkspaceRequestComponent
from .workspace_request_fields_item import WorkspaceRequestFieldsItem
from .workspace_request_fixed import WorkspaceRequestFixed
from .workspace_request_method import WorkspaceRequestMethod
from .workspace_request_type import WorkspaceRequestType
from .workspace_request_working_mode_type_0_item import WorkspaceRequestWorkingModeType0Item
from .workspace_result import WorkspaceResult
from .workspace_result_centroid_type_0 import WorkspaceResultCentroidType0
from .workspace_result_class import WorkspaceResultClass
from .workspace_result_fields import WorkspaceResultFields
from .workspace_result_type import WorkspaceResultType
from .workspace_result_working_mode_type_0_item import WorkspaceResultWorkingModeType0Item
from .wrist_gears import WristGears

__all__ = (
    "ActuatorLimit",
    "Arc",
    "AssemblyMode",
    "AssemblyModeSideType0",
    "AssemblyModeWorkingModeItem",
    "Bounds",
    "Component",
    "ComponentCentroid",
    "Constructive",
    "CrankLeg",
    "Custom",
    "CustomMotion",
    "CustomWorkingModeType0Item",
    "DeltaLinear",
    "DeltaLinear4Dof",
    "DeltaLinear4DofWorkingModeType0Item",
    "DeltaLinearWorkingModeType0Item",
    "DeltaRotary",
    "DeltaRotaryWorkingModeType0Item",
    "DesignMesh",
    "DesignMeshFace",
    "Effective",
    "EffortRequest",
    "EffortRequestWorkingModeType0Item",
    "EffortResult",
    "EffortResultWorkingModeItem",
    "Estimate",
    "EstimateMode",
    "Excluded",
    "ExcludedReason",
    "ExplicitMesh",
    "FieldFault",
    "FieldProblem",
    "FieldSummary",
    "FieldSummaryAtMaxType0",
    "FiveBar",
    "FiveBarWorkingModeType0Item",
    "ForwardKinematicsGuessResult",
    "ForwardKinematicsRequest",
    "ForwardKinematicsResult",
    "FrictionTorqueRequest",
    "FrictionTorqueRequestContact",
    "FrictionTorqueRequestSense",
    "FrictionTorqueRequestWorkingModeType0Item",
    "FrictionTorqueResult",
    "FrictionTorqueResultContact",
    "FrictionTorqueResultSense",
    "GearedDecoupled",
    "GearedDecoupledWorkingModeType0Item",
    "GearStage",
    "GetFigureFormatType0",
    "GetGridFormatType0",
    "GoughStewart",
    "GoughStewartWorkingModeType0Item",
    "GridAxis",
    "Health",
    "HexaLinear",
    "HexaLinearWorkingModeType0Item",
    "HexaRotary",
    "HexaRotaryWorkingModeType0Item",
    "Histogram",
    "Inscribed",
    "InscribedBall",
    "InscribedBallCentre",
    "InscribedBox",
    "InscribedBoxMax",
    "InscribedBoxMin",
    "InverseKinematicsAllModesResult",
    "InverseKinematicsAllModesResultWorkingModesItemItem",
    "InverseKinematicsRequest",
    "InverseKinematicsRequestWorkingModeType0Item",
    "InverseKinematicsResult",
    "InverseKinematicsResultWorkingModeItem",
    "Iteration",
    "Job",
    "JobError",
    "JobErrorKind",
    "JobPage",
    "JobState",
    "Kind",
    "KindJsonSchema",
    "KindPage",
    "KnownLoad",
    "Links",
    "ListJobsStateType0",
    "LoadSize",
    "Measure",
    "MechanismPage",
    "MeshCurve",
    "MeshGeometry",
    "MotorTorqueResult",
    "MotorTorqueResultContact",
    "MotorTorqueResultSenseItemItemType0",
    "MotorTorqueResultWorkingModeItem",
    "Obstacle",
    "ObstacleInMode",
    "ObstacleInModeReason",
    "ObstacleReason",
    "OrientationAxis",
    "OrientationsTried",
    "Planar3RRR",
    "Planar3RRRWorkingModeType0Item",
    "PlatformBody",
    "PlatformSpeed",
    "Preset",
    "Problem",
    "Progress",
    "RailLeg",
    "Readiness",
    "SingularityRequest",
    "SingularityRequestWorkingModeType0Item",
    "SingularityResult",
    "SingularityResultWorkingModeItem",
    "Spherical3RRR",
    "Spherical3RRRWorkingModeType0Item",
    "StoredMechanism",
    "StoredMechanismDocument",
    "StrutLeg",
    "Translational3RRRR",
    "Translational3RRRRWorkingModeType0Item",
    "VelocityRequest",
    "VelocityRequestWorkingModeType0Item",
    "VelocityResult",
    "VelocityResultWorkingModeItem",
    "Wheel",
    "WorkspaceRequest",
    "WorkspaceRequestClass",
    "WorkspaceRequestComponent",
    "WorkspaceRequestFieldsItem",
    "WorkspaceRequestFixed",
    "WorkspaceRequestMethod",
    "WorkspaceRequestType",
    "WorkspaceRequestWorkingModeType0Item",
    "WorkspaceResult",
    "WorkspaceResultCentroidType0",
    "WorkspaceResultClass",
    "WorkspaceResultFields",
    "WorkspaceResultType",
    "WorkspaceResultWorkingModeType0Item",
    "WristGears",
)
