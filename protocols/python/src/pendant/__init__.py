"""
Drives and tests URScript programs on Pendant's simulated robots, in virtual time::

    import pendant

    with pendant.Robot(model="ur5e") as robot:
        robot.load("pick.script")
        robot.start()
        robot.inputs["digital_in[0]"] = True
        robot.run_until_end()
        print(robot.state.tcp_pose, robot.variables["n"])

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
    "Safety",
    "SafetyStop",
    "State",
    "Variables",
]
