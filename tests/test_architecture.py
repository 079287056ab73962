"""The folders and who may know whom: the contract in pyproject.toml is whole, and holds."""

import ast
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[1]
BESIDE_THE_HOUSE = {"benchmarks", "examples", "sdk", "tests"}


def _configuration() -> dict[str, Any]:
    tool: dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]
    return tool


def _layers() -> list[set[str]]:
    """Return the names in each layer of the contract, the highest first."""
    contracts = _configuration()["importlinter"]["contracts"]
    layers = next(contract["layers"] for contract in contracts if contract["type"] == "layers")
    return [{name.strip(" ()") for name in layer.split("|")} for layer in layers]


def _packages() -> set[str]:
    folders = {path.parent.name for path in ROOT.glob("[!.]*/*.py")}
    return folders - BESIDE_THE_HOUSE


def _modules() -> set[str]:
    return {path.stem for path in ROOT.glob("*.py")}


def _imports(module: str) -> set[str]:
    """Return the top-level names that a single-file module imports, wherever in the file."""
    names: set[str] = set()
    for node in ast.walk(ast.parse((ROOT / f"{module}.py").read_text())):
        if isinstance(node, ast.Import):
            names |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.add(node.module.partition(".")[0])
    return names


def test_import_contracts_hold() -> None:
    linter = Path(sys.executable).parent / "lint-imports"
    outcome = subprocess.run(
        [linter, "--no-cache"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr


def test_every_package_and_module_stands_in_the_contract() -> None:
    assert set[str]().union(*_layers()) == _packages() | _modules()


def test_every_package_is_searched_for_imports() -> None:
    assert set(_configuration()["importlinter"]["root_packages"]) == _packages()


def test_every_package_and_module_is_in_the_wheel() -> None:
    included = _configuration()["hatch"]["build"]["targets"]["wheel"]["only-include"]
    assert {name.removesuffix(".py") for name in included} == _packages() | _modules()


@pytest.mark.parametrize("module", sorted(_modules()))
def test_a_single_file_module_imports_downwards_only(module: str) -> None:
    layers = _layers()
    height = next(index for index, layer in enumerate(layers) if module in layer)
    not_below = set[str]().union(*layers[: height + 1])
    assert not _imports(module) & not_below


def test_commands_start_service_and_workers_without_importing_them() -> None:
    assert not _imports("commands") & {"service", "workers"}
