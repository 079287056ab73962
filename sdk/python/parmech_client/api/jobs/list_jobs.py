from http import HTTPStatus
from typing import Any

import httpx

from ... import errors
from ...client import AuthenticatedClient, Client
from ...models.job_page import JobPage
from ...models.list_jobs_state_type_0 import ListJobsStateType0
from ...models.problem import Problem
from ...types import UNSET, Response, Unset


def _get_kwargs(
    *,
    state: ListJobsStateType0 | None | Unset = UNSET,
    analysis: None | str | Unset = UNSET,
    mechanism: None | str | Unset = UNSET,
    page_token: None | str | Unset = UNSET,
    page_size: int | Unset = 50,
) -> dict[str, Any]:

    params: dict[str, Any] = {}

    json_state: None | str | Unset
    if isinstance(state, Unset):
        json_state = UNSET
    elif isinstance(state, str):
        json_state = state
    else:
        json_state = state
    params["state"] = json_state

    json_analysis: None | str | Unset
    if isinstance(analysis, Unset):
        json_analysis = UNSET
    else:
        json_analysis = analysis
    params["analysis"] = json_analysis

    json_mechanism: None | str | Unset
    if isinstance(mechanism, Unset):
        json_mechanism = UNSET
    else:
        json_mechanism = mechanism
    params["mechanism"] = json_mechanism

    json_page_token: None | str | Unset
    if isinstance(page_token, Unset):
        json_page_token = UNSET
    else:
        json_page_token = page_token
    params["page_token"] = json_page_token

    params["page_size"] = page_size

    params = {k: v for k, v in params.items() if v is not UNSET and v is not None}

    _kwargs: dict[str, Any] = {
        "method": "get",
        "url": "/v1/jobs",
        "params": params,
    }

    return _kwargs


def _parse_response(*, client: AuthenticatedClient | Client, response: httpx.Response) -> JobPage | Problem | None:
    if response.status_code == 200:
        response_200 = JobPage.from_dict(response.json())

        return response_200

    if response.status_code == 422:
        response_422 = Problem.from_dict(response.json())

        return response_422

    if client.raise_on_unexpected_status:
        raise errors.UnexpectedStatus(response.status_code, response.content)
    else:
        return None


def _build_response(*, client: AuthenticatedClient | Client, response: httpx.Response) -> Response[JobPage | Problem]:
    return Response(
        status_code=HTTPStatus(response.status_code),
        content=response.content,
        headers=response.headers,
        parsed=_parse_response(client=client, response=response),
    )


def sync_detailed(
    *,
    client: AuthenticatedClient | Client,
    state: ListJobsStateType0 | None | Unset = UNSET,
    analysis: None | str | Unset = UNSET,
    mechanism: None | str | Unset = UNSET,
    page_token: None | str | Unset = UNSET,
    page_size: int | Unset = 50,
) -> Response[JobPage | Problem]:
    """List Jobs

     List jobs, the newest first.

    Args:
        state (ListJobsStateType0 | None | Unset):
        analysis (None | str | Unset):
        mechanism (None | str | Unset):
        page_token (None | str | Unset): `next_page_token` of the page before.
        page_size (int | Unset): Most items of a page. Default: 50.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[JobPage | Problem]
    """

    kwargs = _get_kwargs(
        state=state,
        analysis=analysis,
        mechanism=mechanism,
        page_token=page_token,
        page_size=page_size,
    )

    response = client.get_httpx_client().request(
        **kwargs,
    )

    return _build_response(client=client, response=response)


def sync(
    *,
    client: AuthenticatedClient | Client,
    state: ListJobsStateType0 | None | Unset = UNSET,
    analysis: None | str | Unset = UNSET,
    mechanism: None | str | Unset = UNSET,
    page_token: None | str | Unset = UNSET,
    page_size: int | Unset = 50,
) -> JobPage | Problem | None:
    """List Jobs

     List jobs, the newest first.

    Args:
        state (ListJobsStateType0 | None | Unset):
        analysis (None | str | Unset):
        mechanism (None | str | Unset):
        page_token (None | str | Unset): `next_page_token` of the page before.
        page_size (int | Unset): Most items of a page. Default: 50.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        JobPage | Problem
    """

    return sync_detailed(
        client=client,
        state=state,
        analysis=analysis,
        mechanism=mechanism,
        page_token=page_token,
        page_size=page_size,
    ).parsed


async def asyncio_detailed(
    *,
    client: AuthenticatedClient | Client,
    state: ListJobsStateType0 | None | Unset = UNSET,
    analysis: None | str | Unset = UNSET,
    mechanism: None | str | Unset = UNSET,
    page_token: None | str | Unset = UNSET,
    page_size: int | Unset = 50,
) -> Response[JobPage | Problem]:
    """List Jobs

     List jobs, the newest first.

    Args:
        state (ListJobsStateType0 | None | Unset):
        analysis (None | str | Unset):
        mechanism (None | str | Unset):
        page_token (None | str | Unset): `next_page_token` of the page before.
        page_size (int | Unset): Most items of a page. Default: 50.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        Response[JobPage | Problem]
    """

    kwargs = _get_kwargs(
        state=state,
        analysis=analysis,
        mechanism=mechanism,
        page_token=page_token,
        page_size=page_size,
    )

    response = await client.get_async_httpx_client().request(**kwargs)

    return _build_response(client=client, response=response)


async def asyncio(
    *,
    client: AuthenticatedClient | Client,
    state: ListJobsStateType0 | None | Unset = UNSET,
    analysis: None | str | Unset = UNSET,
    mechanism: None | str | Unset = UNSET,
    page_token: None | str | Unset = UNSET,
    page_size: int | Unset = 50,
) -> JobPage | Problem | None:
    """List Jobs

     List jobs, the newest first.

    Args:
        state (ListJobsStateType0 | None | Unset):
        analysis (None | str | Unset):
        mechanism (None | str | Unset):
        page_token (None | str | Unset): `next_page_token` of the page before.
        page_size (int | Unset): Most items of a page. Default: 50.

    Raises:
        errors.UnexpectedStatus: If the server returns an undocumented status code and Client.raise_on_unexpected_status is True.
        httpx.TimeoutException: If the request takes longer than Client.timeout.

    Returns:
        JobPage | Problem
    """

    return (
        await asyncio_detailed(
            client=client,
            state=state,
            analysis=analysis,
            mechanism=mechanism,
            page_token=page_token,
            page_size=page_size,
        )
    ).parsed
