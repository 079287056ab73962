from http import HTTPStatus
from typing import Any
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.effort_result import EffortResult
from ...models.forward_kinematics_guess_result import ForwardKinematicsGuessResult
from ...models.forward_kinematics_result import ForwardKinematicsResult
from ...models.friction_torque_result import FrictionTorqueResult
from ...models.inverse_kinematics_all_modes_result import InverseKinematicsAllModesResult
from ...models.inverse_kinematics_result import InverseKinematicsResult
from ...models.motor_torque_result import MotorTorqueResult
from ...models.problem import Problem
from ...models.singularity_result import SingularityResult
from ...models.velocity_result import VelocityResult
from ...models.workspace_result import WorkspaceResult
from ...types import Response


def _get_kwargs(
    job_id: str,
) -> dict[str, Any]:

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/jobs/{job_id}/result".format(
            job_id=quote(str(job_id), safe=""),
        ),
    }

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

    if response.status_code == 404:
        response_404 = Problem.from_dict(response.json())

        return response_404

    if response.status_code == 422:
        response_422 = Problem.from_dict(response.json())

        return response_422

    if response.status_code == 500:
        response_500 = Problem.from_dict(response.json())

        return response_500

    if response.status_code == 504:
        response_504 = Problem.from_dict(response.json())

        return response_504

    if response.status_code == 507:
        response_507 = Problem.from_dict(response.json())

        return response_507

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
    | Problem
]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    job_id: str,
    *,
    client: AuthenticatedClient | Client,
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
    | Problem
]:
    """Get Result

     Return the result; a failed job answers with its stored problem.

    Args:
        job_id (str):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[EffortResult | ForwardKinematicsGuessResult | ForwardKinematicsResult | FrictionTorqueResult | InverseKinematicsAllModesResult | InverseKinematicsResult | MotorTorqueResult | SingularityResult | VelocityResult | WorkspaceResult | Problem]
    """

    kwargs = _get_kwargs(
        job_id=job_id,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    job_id: str,
    *,
    client: AuthenticatedClient | Client,
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
    | Problem
    | None
):
    """Get Result

     Return the result; a failed job answers with its stored problem.

    Args:
        job_id (str):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        EffortResult | ForwardKinematicsGuessResult | ForwardKinematicsResult | FrictionTorqueResult | InverseKinematicsAllModesResult | InverseKinematicsResult | MotorTorqueResult | SingularityResult | VelocityResult | WorkspaceResult | Problem
    """

    return sync_detailed(
        job_id=job_id,
        client=client,
    ).parsed


async def asyncio_detailed(
    job_id: str,
    *,
    client: AuthenticatedClient | Client,
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
    | Problem
]:
    """Get Result

     Return the result; a failed job answers with its stored problem.

    Args:
        job_id (str):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[EffortResult | ForwardKinematicsGuessResult | ForwardKinematicsResult | FrictionTorqueResult | InverseKinematicsAllModesResult | InverseKinematicsResult | MotorTorqueResult | SingularityResult | VelocityResult | WorkspaceResult | Problem]
    """

    kwargs = _get_kwargs(
        job_id=job_id,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    job_id: str,
    *,
    client: AuthenticatedClient | Client,
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
    | Problem
    | None
):
    """Get Result

     Return the result; a failed job answers with its stored problem.

    Args:
        job_id (str):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        EffortResult | ForwardKinematicsGuessResult | ForwardKinematicsResult | FrictionTorqueResult | InverseKinematicsAllModesResult | InverseKinematicsResult | MotorTorqueResult | SingularityResult | VelocityResult | WorkspaceResult | Problem
    """

    return (
        await asyncio_detailed(
            job_id=job_id,
            client=client,
        )
    ).parsed
