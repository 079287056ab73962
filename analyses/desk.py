"""The desk at which requests arrive: each is handed to the analysis that answers it."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from analyses.analysis import Analysis, Arrays, Stretches
from analyses.effort import Effort
from analyses.forward_kinematics import ForwardKinematics
from analyses.friction_torque import FrictionTorque
from analyses.inverse_kinematics import InverseKinematics
from analyses.kinds import describe
from analyses.mechanisms import check_mechanism
from analyses.motor_torques import MotorTorques
from analyses.plan import Plan
from analyses.singularity import Singularity
from analyses.velocity import Velocity
from analyses.workspace import Workspace
from schemas.analyses import Request, mechanism_of, parse_request
from schemas.estimates import Estimate
from schemas.examples import EXAMPLES
from schemas.friction_torque import FrictionTorqueRequest
from schemas.heavy import HEAVY
from schemas.kinds import Kind
from schemas.mechanisms import KINDS, StoredMechanism
from schemas.quantities import Model

ANALYSES: Mapping[str, Analysis[Any]] = MappingProxyType(
    {
        analysis.name: analysis
        for analysis in (
            InverseKinematics(),
            ForwardKinematics(),
            Velocity(),
            Effort(),
            Singularity(),
            Workspace(),
            FrictionTorque(),
        )
    }
)
MOTOR_TORQUES = MotorTorques()


def analysis_of(request: Request) -> Analysis[Any]:
    """Return what answers a request: of gears in a mechanism another than of a train alone."""
    if isinstance(request, FrictionTorqueRequest) and request.mechanism is not None:
        return MOTOR_TORQUES
    return ANALYSES[request.analysis]


def parse(text: str) -> Request:
    """Return the request of a canonical JSON text."""
    return parse_request(text)


def check(request: Request, node_limit: int) -> None:
    """Raise AnalysisError if the request makes no sense; nothing large is allocated."""
    mechanism = mechanism_of(request)
    if mechanism is not None and not isinstance(mechanism, StoredMechanism):
        check_mechanism(mechanism)
    analysis_of(request).check(request, node_limit)


def estimate(request: Request, synchronous_seconds: float) -> Estimate:
    """Return what a checked request would cost, and how it would be answered."""
    analysis = analysis_of(request)
    seconds = analysis.seconds(request)
    return Estimate(
        nodes=analysis.items(request),
        seconds=seconds,
        bytes=analysis.result_bytes(request),
        mode="sync" if seconds <= synchronous_seconds else "job",
    )


def plan(request: Request, tile_seconds: float) -> Plan:
    """Return how a checked request is cut into tiles."""
    return analysis_of(request).plan(request, tile_seconds)


def compute(request: Request, start: int, stop: int) -> Arrays:
    """Return the arrays of the items `start` to `stop` of a checked request."""
    return analysis_of(request).compute(request, start, stop)


def assemble(request: Request, stretches: Stretches) -> Model:
    """Return the result from the arrays of all tiles, in order."""
    return analysis_of(request).assemble(request, stretches)


def answer(request: Request) -> Model:
    """Return the result of a checked request at once."""
    whole = compute(request, 0, analysis_of(request).items(request))
    return assemble(request, lambda: [whole])


def has_grid(analysis: str) -> bool:
    """Return whether an analysis makes arrays over a grid."""
    return analysis == Workspace.name


def offered_kinds() -> list[Kind]:
    """Return the mechanism families with what can be asked of them."""
    return [offered_kind(name) for name in KINDS]


def offered_kind(name: str) -> Kind:
    """Return one mechanism family; raise KeyError if there is none of this name."""
    return describe(name, list(ANALYSES.values()))


def warm(*, backwards: bool = False) -> None:
    """Answer worked examples and what is heavy, so that all kernels are compiled and loaded.

    Of processes that start together some may go backwards: each finds half of it done by others.
    """
    requests = [*(example.request for example in EXAMPLES), *HEAVY]
    for request in requests[:: -1 if backwards else 1]:
        estimate(request, 0.0)
        answer(request)
