"""What can go wrong."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence

from .state import Diagnostic, State

#: Codes of JSON-RPC errors that have a class of their own.
REFUSED = -32000
PROGRAM = -32002
INVALID_PARAMS = -32602


class PendantError(Exception):
    """Base of all errors of this package."""


class LauncherNotFound(PendantError):
    """The ``pendant`` command was not found."""


class ConnectionLost(PendantError):
    """The process of Pendant has ended."""


class RpcError(PendantError):
    """A request was answered by an error; ``data`` has what the message says, for programs."""

    def __init__(self, code: int, message: str, data: Mapping[str, Any]) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.data = dict(data)


class Refused(RpcError):
    """The controller has refused a command, and nothing has changed."""

    @property
    def reason(self) -> str:
        """The kind of reason, such as ``program`` or ``safety``."""
        return str(self.data.get("code", ""))


class InvalidParams(RpcError, ValueError):
    """An argument is unknown or not what it must be."""


class ProgramError(PendantError):
    """Something is wrong with a program; it says where."""

    def __init__(
        self, message: str, file: str = "", line: int = 0, column: int = 0, code: str = ""
    ) -> None:
        place = ":".join(str(part) for part in (file, line, column) if part)
        super().__init__(f"{place}: {message}" if place else message)
        self.message = message
        self.file = file
        self.line = line
        self.column = column
        self.code = code


class CompileError(ProgramError):
    """A program does not compile; it is about the first error of ``diagnostics``."""

    def __init__(self, file: str, diagnostics: Sequence[Diagnostic]) -> None:
        errors = [each for each in diagnostics if each.severity == "error"]
        if errors:
            first = errors[0]
            more = f" (and {len(errors) - 1} more)" if len(errors) > 1 else ""
            super().__init__(
                first.message + more, first.file, first.line, first.column, first.code
            )
        else:
            super().__init__("cannot run", file)
        self.diagnostics = tuple(diagnostics)


class ProgramFailed(ProgramError):
    """A program has ended by a runtime error, or a safety function has stopped it."""

    def __init__(
        self,
        message: str,
        file: str = "",
        line: int = 0,
        column: int = 0,
        code: str = "",
        state: Optional[State] = None,
    ) -> None:
        super().__init__(message, file, line, column, code)
        self.state = state


class OperatorNeeded(PendantError):
    """A program waits for an operator: a popup, a question, or somebody who resumes it."""

    def __init__(self, message: str, state: State) -> None:
        super().__init__(message)
        self.state = state


class RobotTimeout(PendantError, TimeoutError):
    """Robot time is over and what was waited for has not come."""

    def __init__(self, message: str, state: State) -> None:
        super().__init__(message)
        self.state = state


def of_answer(error: Mapping[str, Any]) -> PendantError:
    """The exception that says what the error of an answer says."""
    code = int(error["code"])
    message = str(error["message"])
    data: Mapping[str, Any] = error.get("data") or {}
    if code == REFUSED:
        return Refused(code, message, data)
    if code == INVALID_PARAMS:
        return InvalidParams(code, message, data)
    if code == PROGRAM and "line" in data:
        return ProgramFailed(
            message, str(data["file"]), int(data["line"]), int(data["column"]), str(data["code"])
        )
    return RpcError(code, message, data)
