from http import HTTPStatus
from typing import Any

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.effort_request import EffortRequest
from ...models.forward_kinematics_request import ForwardKinematicsRequest
from ...models.friction_torque_request import FrictionTorqueRequest
from ...models.inverse_kinematics_request import InverseKinematicsRequest
from ...models.job import Job
from ...models.problem import Problem
from ...models.singularity_request import SingularityRequest
from ...models.velocity_request import VelocityRequest
from ...models.workspace_request import WorkspaceRequest
from ...types import UNSET, Response, Unset


def _get_kwargs(
    *,
    body: EffortRequest
    | ForwardKinematicsRequest
    | FrictionTorqueRequest
    | InverseKinematicsRequest
    | SingularityRequest
    | VelocityRequest
    | WorkspaceRequest,
    idempotency_key: None | str | Unset = UNSET,
) -> dict[str, Any]:
    headers: dict[str, Any] = {}
    if not isinstance(idempotency_key, Unset):
        headers["idempotency-key"] = idempotency_key

    _kwargs: dict[str, Any] = {
        "method": "post",
        "url": "/v1/jobs",
    }

    if isinstance(body, InverseKinematicsRequest):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, ForwardKinematicsRequest):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, VelocityRequest):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, EffortRequest):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, SingularityRequest):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, WorkspaceRequest):
        _kwargs["json"] = body.to_dict()
    else:
        _kwargs["json"] = body.to_dict()

    headers["Content-Type"] = "application/json"

    _kwargs["headers"] = headers
    return _kwargs


def _parse_response(*, client: AuthenticatedClient | Client, response: httpx.Response) -> Job | Problem | None:
    if response.status_code == 200:
        response_200 = Job.from_dict(response.json())

        return response_200

    if response.status_code == 201:
        response_201 = Job.from_dict(response.json())

        return response_201

    if response.status_code == 400:
        response_400 = Problem.from_dict(response.json())

        return response_400

    if response.status_code == 413:
        response_413 = Problem.from_dict(response.json())

        return response_413

    if response.status_code == 415:
        response_415 = Problem.from_dict(response.json())

        return response_415

    if response.status_code == 422:
        response_422 = Problem.from_dict(response.json())

        return response_422

    if response.status_code == 503:
        response_503 = Problem.from_dict(response.json())

        return response_503

    if client.raise_on_unexpected_status:
        raise errors.UnexpectedStatus(response.status_code, response.content)
    else:
        return None


def _build_response(*, client: AuthenticatedClient | Client, response: httpx.Response) -> Response[Job | Problem]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    *,
    client: AuthenticatedClient | Client,
    body: EffortRequest
    | ForwardKinematicsRequest
    | FrictionTorqueRequest
    | InverseKinematicsRequest
    | SingularityRequest
    | VelocityRequest
    | WorkspaceRequest,
    idempotency_key: None | str | Unset = UNSET,
) -> Response[Job | Problem]:
    """Create Job

     Queue an analysis; it is kept before this answers.

    Args:
        idempotency_key (None | str | Unset): The same key answers with the same job for 24 hours.
        body (EffortRequest | ForwardKinematicsRequest | FrictionTorqueRequest |
            InverseKinematicsRequest | SingularityRequest | VelocityRequest | WorkspaceRequest):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Job | Problem]
    """

    kwargs = _get_kwargs(
        body=body,
        idempotency_key=idempotency_key,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    *,
    client: AuthenticatedClient | Client,
    body: EffortRequest
    | ForwardKinematicsRequest
    | FrictionTorqueRequest
    | InverseKinematicsRequest
    | SingularityRequest
    | VelocityRequest
    | WorkspaceRequest,
    idempotency_key: None | str | Unset = UNSET,
) -> Job | Problem | None:
    """Create Job

     Queue an analysis; it is kept before this answers.

    Args:
        idempotency_key (None | str | Unset): The same key answers with the same job for 24 hours.
        body (EffortRequest | ForwardKinematicsRequest | FrictionTorqueRequest |
            InverseKinematicsRequest | SingularityRequest | VelocityRequest | WorkspaceRequest):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Job | Problem
    """

    return sync_detailed(
        client=client,
        body=body,
        idempotency_key=idempotency_key,
    ).parsed


async def asyncio_detailed(
    *,
    client: AuthenticatedClient | Client,
    body: EffortRequest
    | ForwardKinematicsRequest
    | FrictionTorqueRequest
    | InverseKinematicsRequest
    | SingularityRequest
    | VelocityRequest
    | WorkspaceRequest,
    idempotency_key: None | str | Unset = UNSET,
) -> Response[Job | Problem]:
    """Create Job

     Queue an analysis; it is kept before this answers.

    Args:
        idempotency_key (None | str | Unset): The same key answers with the same job for 24 hours.
        body (EffortRequest | ForwardKinematicsRequest | FrictionTorqueRequest |
            InverseKinematicsRequest | SingularityRequest | VelocityRequest | WorkspaceRequest):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Job | Problem]
    """

    kwargs = _get_kwargs(
        body=body,
        idempotency_key=idempotency_key,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    *,
    client: AuthenticatedClient | Client,
    body: EffortRequest
    | ForwardKinematicsRequest
    | FrictionTorqueRequest
    | InverseKinematicsRequest
    | SingularityRequest
    | VelocityRequest
    | WorkspaceRequest,
    idempotency_key: None | str | Unset = UNSET,
) -> Job | Problem | None:
    """Create Job

     Queue an analysis; it is kept before this answers.

    Args:
        idempotency_key (None | str | Unset): The same key answers with the same job for 24 hours.
        body (EffortRequest | ForwardKinematicsRequest | FrictionTorqueRequest |
            InverseKinematicsRequest | SingularityRequest | VelocityRequest | WorkspaceRequest):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Job | Problem
    """

    return (
        await asyncio_detailed(
            client=client,
            body=body,
            idempotency_key=idempotency_key,
        )
    ).parsed
