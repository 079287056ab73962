from collections.abc import Iterator

import pytest

from tests.integration.servers import Server, serving


@pytest.fixture(scope="package")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    """Return a server that tests share, so they leave it as it is; small jobs have many tiles."""
    folder = tmp_path_factory.mktemp("server")
    with serving(folder, tile_seconds=0.001, synchronous_seconds=0.05) as shared:
        yield shared
