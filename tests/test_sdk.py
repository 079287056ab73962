"""The committed client is what the committed schema generates."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def _files(folder: Path) -> dict[str, str]:
    """Return the text of every file but what installing and running leaves behind."""
    paths = {path.relative_to(folder): path for path in folder.rglob("*") if path.is_file()}
    return {
        str(name): path.read_text()
        for name, path in paths.items()
        if not {".pdm-build", "__pycache__"} & set(name.parts)
    }


def test_client_is_generated_from_the_committed_schema(tmp_path: Path) -> None:
    fresh = tmp_path / "python"
    subprocess.run([sys.executable, ROOT / "sdk" / "generate.py", fresh], check=True)
    assert _files(ROOT / "sdk" / "python") == _files(fresh), "make sdk"
