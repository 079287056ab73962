"""All analyses on the wire, by their discriminator `analysis`."""

from typing import Annotated

from pydantic import Field, TypeAdapter

from schemas.effort import EffortRequest, EffortResult
from schemas.forward_kinematics import (
    ForwardKinematicsGuessResult,
    ForwardKinematicsRequest,
    ForwardKinematicsResult,
)
from schemas.friction_torque import FrictionTorqueRequest, FrictionTorqueResult, MotorTorqueResult
from schemas.inverse_kinematics import (
    InverseKinematicsAllModesResult,
    InverseKinematicsRequest,
    InverseKinematicsResult,
)
from schemas.mechanisms import InlineMechanism, StoredMechanism
from schemas.singularity import SingularityRequest, SingularityResult
from schemas.velocity import VelocityRequest, VelocityResult
from schemas.workspace import WorkspaceRequest
from schemas.workspace_result import WorkspaceResult

Request = (
    InverseKinematicsRequest
    | ForwardKinematicsRequest
    | VelocityRequest
    | EffortRequest
    | SingularityRequest
    | WorkspaceRequest
    | FrictionTorqueRequest
)
AnalysisRequest = Annotated[Request, Field(discriminator="analysis")]
AnalysisResult = (
    InverseKinematicsResult
    | InverseKinematicsAllModesResult
    | ForwardKinematicsResult
    | ForwardKinematicsGuessResult
    | VelocityResult
    | EffortResult
    | SingularityResult
    | WorkspaceResult
    | FrictionTorqueResult
    | MotorTorqueResult
)

_REQUESTS: TypeAdapter[Request] = TypeAdapter(AnalysisRequest)


def mechanism_of(request: Request) -> InlineMechanism | StoredMechanism | None:
    """Return the mechanism that a request is about; None if it is about none."""
    mechanism: InlineMechanism | StoredMechanism | None = getattr(request, "mechanism", None)
    return mechanism


def parse_request(text: str) -> Request:
    """Return the request of a canonical JSON text."""
    return _REQUESTS.validate_json(text)
