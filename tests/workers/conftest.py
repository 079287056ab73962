from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.workers.works import Works


@pytest.fixture
def works(tmp_path: Path) -> Iterator[Works]:
    works = Works(tmp_path)
    yield works
    works.close()


@pytest.fixture(scope="package")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Works]:
    """Return works with an engine that tests share, so they leave it as it is."""
    works = Works(tmp_path_factory.mktemp("running"))
    works.start_engine(tile_timeout_seconds=1.5, tile_retries=1)
    yield works
    works.close()
