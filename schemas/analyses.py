"""All analyses on the wire, by their discriminator `analysis`."""

from typing import Annotated

from pydantic import Field, TypeAdapter

from schemas.effort import EffortRequest, EffortResult
from schemas.forward_kinematics import (
    ForwardKinematicsGuessResult,
    ForwardKinematicsRequest,
    ForwardKinematicsResult,
)
from schemas.inverse_kinematics import (
    InverseKinematicsAllModesResult,
    InverseKinematicsRequest,
    InverseKinematicsResult,
)
from schemas.singularity import SingularityRequest, SingularityResult
from schemas.velocity import VelocityRequest, VelocityResult
from schemas.workspace import WorkspaceRequest, WorkspaceResult

Request = (
    InverseKinematicsRequest
    | ForwardKinematicsRequest
    | VelocityRequest
    | EffortRequest
    | SingularityRequest
    | WorkspaceRequest
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
)

_REQUESTS: TypeAdapter[Request] = TypeAdapter(AnalysisRequest)


def parse_request(text: str) -> Request:
    """Return the request of a canonical JSON text."""
    return _REQUESTS.validate_json(text)
