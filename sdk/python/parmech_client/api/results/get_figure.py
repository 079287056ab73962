from http import HTTPStatus
from io import BytesIO
from typing import Any, cast
from urllib.parse import quote

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.get_figure_format_type_0 import GetFigureFormatType0
from ...models.problem import Problem
from ...types import UNSET, File, Response, Unset


def _get_kwargs(
    job_id: str,
    *,
    format_: GetFigureFormatType0 | None | Unset = UNSET,
    field: None | str | Unset = UNSET,
    accept: None | str | Unset = UNSET,
    if_none_match: None | str | Unset = UNSET,
) -> dict[str, Any]:
    headers: dict[str, Any] = {}
    if not isinstance(accept, Unset):
        headers["accept"] = accept

    if not isinstance(if_none_match, Unset):
        headers["if-none-match"] = if_none_match

    params: dict[str, Any] = {}

    json_format_: None | str | Unset
    if isinstance(format_, Unset):
        json_format_ = UNSET
    elif isinstance(format_, str):
        json_format_ = format_
    else:
        json_format_ = format_
    params["format"] = json_format_

    json_field: None | str | Unset
    if isinstance(field, Unset):
        json_field = UNSET
    else:
        json_field = field
    params["field"] = json_field

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/jobs/{job_id}/figure".format(
            job_id=quote(str(job_id), safe=""),
        ),
        "params": params,
    }

    _kwargs["headers"] = headers
    return _kwargs


def _parse_response(*, client: AuthenticatedClient | Client, response: httpx.Response) -> Any | File | Problem | None:
    if response.status_code == 200:
        response_200 = File(payload=BytesIO(response.content))

        return response_200

    if response.status_code == 206:
        response_206 = cast(Any, None)
        return response_206

    if response.status_code == 304:
        response_304 = cast(Any, None)
        return response_304

    if response.status_code == 404:
        response_404 = Problem.from_dict(response.json())

        return response_404

    if response.status_code == 406:
        response_406 = Problem.from_dict(response.json())

        return response_406

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
) -> Response[Any | File | Problem]:
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
    format_: GetFigureFormatType0 | None | Unset = UNSET,
    field: None | str | Unset = UNSET,
    accept: None | str | Unset = UNSET,
    if_none_match: None | str | Unset = UNSET,
) -> Response[Any | File | Problem]:
    """Get Figure

     Return a picture: of a workspace, or of a gear train's friction over the mesh cycle.

    A workspace is shown by its region, a field as colours and the mechanism in a pose.

    Args:
        job_id (str):
        format_ (GetFigureFormatType0 | None | Unset):
        field (None | str | Unset): Of a workspace a kept field, or `<field>_<leg>`, shown as
            colours; of friction `loss` or `input_torque`.
        accept (None | str | Unset):
        if_none_match (None | str | Unset):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | File | Problem]
    """

    kwargs = _get_kwargs(
        job_id=job_id,
        format_=format_,
        field=field,
        accept=accept,
        if_none_match=if_none_match,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    job_id: str,
    *,
    client: AuthenticatedClient | Client,
    format_: GetFigureFormatType0 | None | Unset = UNSET,
    field: None | str | Unset = UNSET,
    accept: None | str | Unset = UNSET,
    if_none_match: None | str | Unset = UNSET,
) -> Any | File | Problem | None:
    """Get Figure

     Return a picture: of a workspace, or of a gear train's friction over the mesh cycle.

    A workspace is shown by its region, a field as colours and the mechanism in a pose.

    Args:
        job_id (str):
        format_ (GetFigureFormatType0 | None | Unset):
        field (None | str | Unset): Of a workspace a kept field, or `<field>_<leg>`, shown as
            colours; of friction `loss` or `input_torque`.
        accept (None | str | Unset):
        if_none_match (None | str | Unset):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | File | Problem
    """

    return sync_detailed(
        job_id=job_id,
        client=client,
        format_=format_,
        field=field,
        accept=accept,
        if_none_match=if_none_match,
    ).parsed


async def asyncio_detailed(
    job_id: str,
    *,
    client: AuthenticatedClient | Client,
    format_: GetFigureFormatType0 | None | Unset = UNSET,
    field: None | str | Unset = UNSET,
    accept: None | str | Unset = UNSET,
    if_none_match: None | str | Unset = UNSET,
) -> Response[Any | File | Problem]:
    """Get Figure

     Return a picture: of a workspace, or of a gear train's friction over the mesh cycle.

    A workspace is shown by its region, a field as colours and the mechanism in a pose.

    Args:
        job_id (str):
        format_ (GetFigureFormatType0 | None | Unset):
        field (None | str | Unset): Of a workspace a kept field, or `<field>_<leg>`, shown as
            colours; of friction `loss` or `input_torque`.
        accept (None | str | Unset):
        if_none_match (None | str | Unset):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[Any | File | Problem]
    """

    kwargs = _get_kwargs(
        job_id=job_id,
        format_=format_,
        field=field,
        accept=accept,
        if_none_match=if_none_match,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    job_id: str,
    *,
    client: AuthenticatedClient | Client,
    format_: GetFigureFormatType0 | None | Unset = UNSET,
    field: None | str | Unset = UNSET,
    accept: None | str | Unset = UNSET,
    if_none_match: None | str | Unset = UNSET,
) -> Any | File | Problem | None:
    """Get Figure

     Return a picture: of a workspace, or of a gear train's friction over the mesh cycle.

    A workspace is shown by its region, a field as colours and the mechanism in a pose.

    Args:
        job_id (str):
        format_ (GetFigureFormatType0 | None | Unset):
        field (None | str | Unset): Of a workspace a kept field, or `<field>_<leg>`, shown as
            colours; of friction `loss` or `input_torque`.
        accept (None | str | Unset):
        if_none_match (None | str | Unset):

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Any | File | Problem
    """

    return (
        await asyncio_detailed(
            job_id=job_id,
            client=client,
            format_=format_,
            field=field,
            accept=accept,
            if_none_match=if_none_match,
        )
    ).parsed
