"""
Fixtures for pytest: ``robot``, a fresh robot for each test, ``cell``, one in the cell of a file, and
``robot_factory`` for several. One
process of Pendant serves all tests. What a failed test's robots logged is in its report.
"""

from __future__ import annotations

from typing import Any, Callable, Generator, Iterator, List, Optional

import pytest

from .client import Pendant, Robot
from .errors import PendantError

_ROBOTS = pytest.StashKey[List[Robot]]()

#: Log lines in a report at most.
_LOG_LINES = 40


class _Processes:
    """The process that serves the tests: another one where a test has lost it."""

    def __init__(self, launcher: Optional[str]) -> None:
        self._launcher = launcher
        self._pendant: Optional[Pendant] = None

    def pendant(self) -> Pendant:
        if self._pendant is None or not self._pendant.alive:
            self.close()
            self._pendant = Pendant(self._launcher)
        return self._pendant

    def close(self) -> None:
        if self._pendant is not None:
            self._pendant.close()
            self._pendant = None


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.getgroup("pendant").addoption(
        "--pendant",
        metavar="LAUNCHER",
        help="the pendant command; default: $PENDANT, or pendant on the PATH",
    )


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line(
        "markers",
        "robot(model=..., arm=..., seed=..., ...): what the fixture robot begins with, "
        "the arguments of pendant.Robot",
    )
    config.addinivalue_line(
        "markers", "cell(file): the scene that the fixture cell stands in, from the test's folder"
    )


@pytest.fixture(scope="session")
def _pendant_processes(pytestconfig: pytest.Config) -> Iterator[_Processes]:
    processes = _Processes(pytestconfig.getoption("--pendant"))
    yield processes
    processes.close()


@pytest.fixture
def robot_factory(
    request: pytest.FixtureRequest, _pendant_processes: _Processes
) -> Iterator[Callable[..., Robot]]:
    """Makes robots, with the arguments of :class:`pendant.Robot`; the test's end closes them."""
    robots: List[Robot] = []
    request.node.stash[_ROBOTS] = robots

    def make(model: Optional[str] = None, **options: Any) -> Robot:
        robot = Robot(model, pendant=_pendant_processes.pendant(), **options)
        robots.append(robot)
        return robot

    yield make
    for each in robots:
        each.close()


@pytest.fixture
def robot(request: pytest.FixtureRequest, robot_factory: Callable[..., Robot]) -> Robot:
    """A fresh robot, with the arguments of the marker ``robot``: the nearest one counts."""
    return robot_factory(**_options(request))


@pytest.fixture
def cell(request: pytest.FixtureRequest, robot_factory: Callable[..., Robot]) -> Robot:
    """As ``robot``, in the cell that the marker ``cell`` names."""
    marker = request.node.get_closest_marker("cell")
    if marker is None or len(marker.args) != 1 or marker.kwargs:
        raise pytest.UsageError("the fixture cell needs the marker cell, with a file")
    options = _options(request)
    scene = str(request.path.parent / marker.args[0])
    options["options"] = {**options.get("options", {}), "scene": scene}
    return robot_factory(**options)


def _options(request: pytest.FixtureRequest) -> dict[str, Any]:
    """The arguments that the markers of a test give its robot."""
    options: dict[str, Any] = {}
    for marker in reversed(list(request.node.iter_markers("robot"))):
        if len(marker.args) > 1:
            raise pytest.UsageError("the marker robot takes the model and arguments by name")
        if marker.args:
            options["model"] = marker.args[0]
        options.update(marker.kwargs)
    return options


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, Any, None]:
    outcome = yield
    report: pytest.TestReport = outcome.get_result()
    if report.when == "call" and report.failed:
        robots = item.stash.get(_ROBOTS, [])
        for number, robot in enumerate(robots, start=1):
            title = "Pendant robot" if len(robots) == 1 else f"Pendant robot {number}"
            report.sections.append((title, _told(robot)))


def _told(robot: Robot) -> str:
    """What a report says of a robot."""
    try:
        state = robot.state
        lines = robot.log()
    except PendantError as problem:
        return f"it cannot be asked any more: {problem}"
    program = state.program
    told = [
        f"time {state.time_s:.3f} s, frame {state.frame}",
        f"program {program.name or '(none)'}: {program.state}, line {program.line}",
    ]
    if program.ending is not None:
        told.append(f"ended: {program.ending.kind} {program.ending.message}".rstrip())
    told.append(f"safety: {state.safety.safety_mode}, robot: {state.safety.robot_mode}")
    told.append("joints: " + ", ".join(f"{each:.4f}" for each in state.joints) + " rad")
    told.append("TCP: " + ", ".join(f"{each:.4f}" for each in state.tcp_pose))
    high = [
        f"{bank}[{index}]"
        for bank, levels in state.raw["signals"].items()
        for index, level in enumerate(levels)
        if level is True
    ]
    told.append("high: " + (", ".join(high) or "(none)"))
    told.extend(f"popup {each.number}: {each.text}" for each in state.popups)
    told.extend(f"question {each.number}: {each.text}" for each in state.questions)
    if lines:
        told.append("log:")
        if len(lines) > _LOG_LINES:
            told.append(f"  ... ({len(lines) - _LOG_LINES} lines before)")
        told.extend(f"  {each}" for each in lines[-_LOG_LINES:])
    return "\n".join(told)
