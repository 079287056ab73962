from http import HTTPStatus
from typing import Any

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.custom import Custom
from ...models.delta_linear import DeltaLinear
from ...models.delta_linear_4_dof import DeltaLinear4Dof
from ...models.delta_rotary import DeltaRotary
from ...models.five_bar import FiveBar
from ...models.geared_decoupled import GearedDecoupled
from ...models.gough_stewart import GoughStewart
from ...models.hexa_linear import HexaLinear
from ...models.hexa_rotary import HexaRotary
from ...models.planar_3rrr import Planar3RRR
from ...models.problem import Problem
from ...models.spherical_3rrr import Spherical3RRR
from ...models.stored_mechanism_document import StoredMechanismDocument
from ...models.translational_3rrrr import Translational3RRRR
from ...types import Response


def _get_kwargs(
    *,
    body: Custom
    | DeltaLinear
    | DeltaLinear4Dof
    | DeltaRotary
    | FiveBar
    | GearedDecoupled
    | GoughStewart
    | HexaLinear
    | HexaRotary
    | Planar3RRR
    | Spherical3RRR
    | Translational3RRRR,
) -> dict[str, Any]:
    headers: dict[str, Any] = {}

    _kwargs: dict[str, Any] = {
        "method": "post",
        "url": "/v1/mechanisms",
    }

    if isinstance(body, FiveBar):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, Planar3RRR):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, Translational3RRRR):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, DeltaRotary):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, DeltaLinear):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, DeltaLinear4Dof):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, HexaLinear):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, GoughStewart):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, HexaRotary):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, Spherical3RRR):
        _kwargs["json"] = body.to_dict()
    elif isinstance(body, GearedDecoupled):
        _kwargs["json"] = body.to_dict()
    else:
        _kwargs["json"] = body.to_dict()

    headers["Content-Type"] = "application/json"

    _kwargs["headers"] = headers
    return _kwargs


def _parse_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Problem | StoredMechanismDocument | None:
    if response.status_code == 200:
        response_200 = StoredMechanismDocument.from_dict(response.json())

        return response_200

    if response.status_code == 201:
        response_201 = StoredMechanismDocument.from_dict(response.json())

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


def _build_response(
    *, client: AuthenticatedClient | Client, response: httpx.Response
) -> Response[Problem | StoredMechanismDocument]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    *,
    client: AuthenticatedClient | Client,
    body: Custom
    | DeltaLinear
    | DeltaLinear4Dof
    | DeltaRotary
    | FiveBar
    | GearedDecoupled
    | GoughStewart
    | HexaLinear
    | HexaRotary
    | Planar3RRR
    | Spherical3RRR
    | Translational3RRRR,
) -> Response[Problem | StoredMechanismDocument]:
    """Create Mechanism

     Store a mechanism; the same spec again answers 200 with the same id.

    Args:
        body (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled |
            GoughStewart | HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | Translational3RRRR):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Problem | StoredMechanismDocument]
    """

    kwargs = _get_kwargs(
        body=body,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    *,
    client: AuthenticatedClient | Client,
    body: Custom
    | DeltaLinear
    | DeltaLinear4Dof
    | DeltaRotary
    | FiveBar
    | GearedDecoupled
    | GoughStewart
    | HexaLinear
    | HexaRotary
    | Planar3RRR
    | Spherical3RRR
    | Translational3RRRR,
) -> Problem | StoredMechanismDocument | None:
    """Create Mechanism

     Store a mechanism; the same spec again answers 200 with the same id.

    Args:
        body (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled |
            GoughStewart | HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | Translational3RRRR):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Problem | StoredMechanismDocument
    """

    return sync_detailed(
        client=client,
        body=body,
    ).parsed


async def asyncio_detailed(
    *,
    client: AuthenticatedClient | Client,
    body: Custom
    | DeltaLinear
    | DeltaLinear4Dof
    | DeltaRotary
    | FiveBar
    | GearedDecoupled
    | GoughStewart
    | HexaLinear
    | HexaRotary
    | Planar3RRR
    | Spherical3RRR
    | Translational3RRRR,
) -> Response[Problem | StoredMechanismDocument]:
    """Create Mechanism

     Store a mechanism; the same spec again answers 200 with the same id.

    Args:
        body (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled |
            GoughStewart | HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | Translational3RRRR):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Problem | StoredMechanismDocument]
    """

    kwargs = _get_kwargs(
        body=body,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    *,
    client: AuthenticatedClient | Client,
    body: Custom
    | DeltaLinear
    | DeltaLinear4Dof
    | DeltaRotary
    | FiveBar
    | GearedDecoupled
    | GoughStewart
    | HexaLinear
    | HexaRotary
    | Planar3RRR
    | Spherical3RRR
    | Translational3RRRR,
) -> Problem | StoredMechanismDocument | None:
    """Create Mechanism

     Store a mechanism; the same spec again answers 200 with the same id.

    Args:
        body (Custom | DeltaLinear | DeltaLinear4Dof | DeltaRotary | FiveBar | GearedDecoupled |
            GoughStewart | HexaLinear | HexaRotary | Planar3RRR | Spherical3RRR | Translational3RRRR):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Problem | StoredMechanismDocument
    """

    return (
        await asyncio_detailed(
            client=client,
            body=body,
        )
    ).parsed
