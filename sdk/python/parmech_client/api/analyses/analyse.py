from http import HTTPStatus
from typing import Any

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.effort_request import EffortRequest
from ...models.effort_result import EffortResult
from ...models.forward_kinematics_guess_result import ForwardKinematicsGuessResult
from ...models.forward_kinematics_request import ForwardKinematicsRequest
from ...models.forward_kinematics_result import ForwardKinematicsResult
from ...models.friction_torque_request import FrictionTorqueRequest
from ...models.friction_torque_result import FrictionTorqueResult
from ...models.inverse_kinematics_all_modes_result import InverseKinematicsAllModesResult
from ...models.inverse_kinematics_request import InverseKinematicsRequest
from ...models.inverse_kinematics_result import InverseKinematicsResult
from ...models.job import Job
from ...models.motor_torque_result import MotorTorqueResult
from ...models.problem import Problem
from ...models.singularity_request import SingularityRequest
from ...models.singularity_result import SingularityResult
from ...models.velocity_request import VelocityRequest
from ...models.velocity_result import VelocityResult
from ...models.workspace_request import WorkspaceRequest
from ...models.workspace_result import WorkspaceResult
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
    prefer: None | str | Unset = UNSET,
    idempotency_key: None | str | Unset = UNSET,
) -> dict[str, Any]:
    headers: dict[str, Any] = {}
    if not isinstance(prefer, Unset):
        headers["prefer"] = prefer

    if not isinstance(idempotency_key, Unset):
        headers["idempotency-key"] = idempotency_key

    _kwargs: dict[str, Any] = {
        "method": "post",
        "url": "/v1/analyses",
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


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> (
    EffortResult
    | ForwardKinematicsGuessResult
    | ForwardKinematicsResult
    | FrictionTorqueResult
    | InverseKinematicsAllModesResult
    | InverseKinematicsResult
    | MotorTorqueResult
    | SingularityResult
    | VelocityResult
    | WorkspaceResult
    | Job
    | Problem
    | None
):
    if response.status_code == 200:

        def _parse_response_200(
            data: object,
        ) -> (
            EffortResult
            | ForwardKinematicsGuessResult
            | ForwardKinematicsResult
            | FrictionTorqueResult
            | InverseKinematicsAllModesResult
            | InverseKinematicsResult
            | MotorTorqueResult
            | SingularityResult
            | VelocityResult
            | WorkspaceResult
        ):
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_0 = InverseKinematicsResult.from_dict(data)

                return response_200_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_1 = InverseKinematicsAllModesResult.from_dict(data)

                return response_200_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_2 = ForwardKinematicsResult.from_dict(data)

                return response_200_type_2
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_3 = ForwardKinematicsGuessResult.from_dict(data)

                return response_200_type_3
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_4 = VelocityResult.from_dict(data)

                return response_200_type_4
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_5 = EffortResult.from_dict(data)

                return response_200_type_5
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_6 = SingularityResult.from_dict(data)

                return response_200_type_6
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_7 = WorkspaceResult.from_dict(data)

                return response_200_type_7
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                response_200_type_8 = FrictionTorqueResult.from_dict(data)

                return response_200_type_8
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            if not isinstance(data, dict):
                raise TypeError()
            response_200_type_9 = MotorTorqueResult.from_dict(data)

            return response_200_type_9

        response_200 = _parse_response_200(response.json())

        return response_200

    if response.status_code == 202:
        response_202 = Job.from_dict(response.json())

        return response_202

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


def _build_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Response[
    EffortResult
    | ForwardKinematicsGuessResult
    | ForwardKinematicsResult
    | FrictionTorqueResult
    | InverseKinematicsAllModesResult
    | InverseKinematicsResult
    | MotorTorqueResult
    | SingularityResult
    | VelocityResult
    | WorkspaceResult
    | Job
    | Problem
]:
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
    prefer: None | str | Unset = UNSET,
    idempotency_key: None | str | Unset = UNSET,
) -> Response[
    EffortResult
    | ForwardKinematicsGuessResult
    | ForwardKinematicsResult
    | FrictionTorqueResult
    | InverseKinematicsAllModesResult
    | InverseKinematicsResult
    | MotorTorqueResult
    | SingularityResult
    | VelocityResult
    | WorkspaceResult
    | Job
    | Problem
]:
    """Analyse

     Answer an analysis at once, or make a job of it when it is heavy or when asked to.

    Args:
        prefer (None | str | Unset): `respond-async` asks for a job.
        idempotency_key (None | str | Unset): The same key answers with the same job for 24 hours.
        body (EffortRequest | ForwardKinematicsRequest | FrictionTorqueRequest |
            InverseKinematicsRequest | SingularityRequest | VelocityRequest | WorkspaceRequest):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[EffortResult | ForwardKinematicsGuessResult | ForwardKinematicsResult | FrictionTorqueResult | InverseKinematicsAllModesResult | InverseKinematicsResult | MotorTorqueResult | SingularityResult | VelocityResult | WorkspaceResult | Job | Problem]
    """

    kwargs = _get_kwargs(
        body=body,
        prefer=prefer,
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
    prefer: None | str | Unset = UNSET,
    idempotency_key: None | str | Unset = UNSET,
) -> (
    EffortResult
    | ForwardKinematicsGuessResult
    | ForwardKinematicsResult
    | FrictionTorqueResult
    | InverseKinematicsAllModesResult
    | InverseKinematicsResult
    | MotorTorqueResult
    | SingularityResult
    | VelocityResult
    | WorkspaceResult
    | Job
    | Problem
    | None
):
    """Analyse

     Answer an analysis at once, or make a job of it when it is heavy or when asked to.

    Args:
        prefer (None | str | Unset): `respond-async` asks for a job.
        idempotency_key (None | str | Unset): The same key answers with the same job for 24 hours.
        body (EffortRequest | ForwardKinematicsRequest | FrictionTorqueRequest |
            InverseKinematicsRequest | SingularityRequest | VelocityRequest | WorkspaceRequest):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        EffortResult | ForwardKinematicsGuessResult | ForwardKinematicsResult | FrictionTorqueResult | InverseKinematicsAllModesResult | InverseKinematicsResult | MotorTorqueResult | SingularityResult | VelocityResult | WorkspaceResult | Job | Problem
    """

    return sync_detailed(
        client=client,
        body=body,
        prefer=prefer,
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
    prefer: None | str | Unset = UNSET,
    idempotency_key: None | str | Unset = UNSET,
) -> Response[
    EffortResult
    | ForwardKinematicsGuessResult
    | ForwardKinematicsResult
    | FrictionTorqueResult
    | InverseKinematicsAllModesResult
    | InverseKinematicsResult
    | MotorTorqueResult
    | SingularityResult
    | VelocityResult
    | WorkspaceResult
    | Job
    | Problem
]:
    """Analyse

     Answer an analysis at once, or make a job of it when it is heavy or when asked to.

    Args:
        prefer (None | str | Unset): `respond-async` asks for a job.
        idempotency_key (None | str | Unset): The same key answers with the same job for 24 hours.
        body (EffortRequest | ForwardKinematicsRequest | FrictionTorqueRequest |
            InverseKinematicsRequest | SingularityRequest | VelocityRequest | WorkspaceRequest):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[EffortResult | ForwardKinematicsGuessResult | ForwardKinematicsResult | FrictionTorqueResult | InverseKinematicsAllModesResult | InverseKinematicsResult | MotorTorqueResult | SingularityResult | VelocityResult | WorkspaceResult | Job | Problem]
    """

    kwargs = _get_kwargs(
        body=body,
        prefer=prefer,
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
    prefer: None | str | Unset = UNSET,
    idempotency_key: None | str | Unset = UNSET,
) -> (
    EffortResult
    | ForwardKinematicsGuessResult
    | ForwardKinematicsResult
    | FrictionTorqueResult
    | InverseKinematicsAllModesResult
    | InverseKinematicsResult
    | MotorTorqueResult
    | SingularityResult
    | VelocityResult
    | WorkspaceResult
    | Job
    | Problem
    | None
):
    """Analyse

     Answer an analysis at once, or make a job of it when it is heavy or when asked to.

    Args:
        prefer (None | str | Unset): `respond-async` asks for a job.
        idempotency_key (None | str | Unset): The same key answers with the same job for 24 hours.
        body (EffortRequest | ForwardKinematicsRequest | FrictionTorqueRequest |
            InverseKinematicsRequest | SingularityRequest | VelocityRequest | WorkspaceRequest):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        EffortResult | ForwardKinematicsGuessResult | ForwardKinematicsResult | FrictionTorqueResult | InverseKinematicsAllModesResult | InverseKinematicsResult | MotorTorqueResult | SingularityResult | VelocityResult | WorkspaceResult | Job | Problem
    """

    return (
        await asyncio_detailed(
            client=client,
            body=body,
            prefer=prefer,
            idempotency_key=idempotency_key,
        )
    ).parsed
