"""What the tests share."""

from __future__ import annotations

import pathlib
from typing import Iterator, List

import pytest

import pendant

pytest_plugins = ["pytester"]

#: The project's folder.
HOME = pathlib.Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def process() -> Iterator[pendant.Pendant]:
    """One process for all tests that need no own."""
    with pendant.Pendant() as started:
        yield started


@pytest.fixture
def plugin_arguments(pytestconfig: pytest.Config) -> List[str]:
    """How another pytest gets the plugin as this one has: installed, or by the option -p."""
    installed = pytestconfig.pluginmanager.has_plugin("pendant")
    return [] if installed else ["-p", "pendant.pytest_plugin"]
