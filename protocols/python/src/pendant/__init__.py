"""
Drives and tests URScript programs on Pendant's simulated robots, in virtual time::

    import pendant

    with pendant.Robot(model="ur5e") as robot:
        robot.load("pick.script")
        robot.start()
        robot.inputs["digital_in[0]"] = True
        robot.run_until_end()
        print(robot.state.tcp_pose, robot.variables["n"])

    for run in pendant.sweep("place_base.toml"):
        print(run["x"], run["y"], run.outcome)

:mod:`pendant.aio` has the same for ``async``.
"""

from .client import Inputs, Pendant, Robot, Variables
from .errors import (
    CompileError,
    ConnectionLost,
    InvalidParams,
    LauncherNotFound,
    OperatorNeeded,
    PendantError,
    ProgramError,
    ProgramFailed,
    Refused,
    RobotTimeout,
    RpcError,
)
from .state import (
    Device,
    Diagnostic,
    Ending,
    LogEntry,
    Popup,
    Program,
    Question,
    Safety,
    SafetyStop,
    State,
)
from .sweeps import Run, Sweep, SweepError, sweep

__all__ = [
    "CompileError",
    "ConnectionLost",
    "Device",
    "Diagnostic",
    "Ending",
    "Inputs",
    "InvalidParams",
    "LauncherNotFound",
    "LogEntry",
    "OperatorNeeded",
    "Pendant",
    "PendantError",
    "Popup",
    "Program",
    "ProgramError",
    "ProgramFailed",
    "Question",
    "Refused",
    "Robot",
    "RobotTimeout",
    "RpcError",
    "Run",
    "Safety",
    "SafetyStop",
    "State",
    "Sweep",
    "SweepError",
    "Variables",
    "sweep",
]
