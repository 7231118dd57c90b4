"""
Requests and what their answers mean, without any input and output: the clients of both kinds, with
and without ``async``, send the same ones.
"""

from __future__ import annotations

import json
import os
from typing import Any, Callable, Dict, Generic, List, Mapping, Optional, Sequence, TypeVar, Union

from . import errors
from .state import Device, Diagnostic, LogEntry, State, device_of, diagnostic_of, state_of

T = TypeVar("T")

#: A value of an input: a level, a number, or a text with a unit such as ``12mA``.
InputValue = Union[bool, int, float, str]

#: What quantities and variables must be: a value, or ``{"above": 1, "below": 2}``.
Condition = Mapping[str, Union[bool, int, float, str, Mapping[str, float]]]

#: Robot time after which a wait for a condition ends, s.
CONDITION_TIMEOUT_S = 60.0

#: Robot time after which a wait for the end of a program ends, s.
END_TIMEOUT_S = 3600.0


class Call(Generic[T]):
    """A request to come, and what its result means."""

    def __init__(
        self, method: str, params: Mapping[str, Any], meaning: Callable[[Any], T]
    ) -> None:
        self.method = method
        self.params = {key: value for key, value in params.items() if value is not None}
        self.meaning = meaning


def request(number: int, call: Call[Any], handle: Optional[int]) -> bytes:
    """The line of a request."""
    params = dict(call.params)
    if handle is not None:
        params["handle"] = handle
    message = {"jsonrpc": "2.0", "id": number, "method": call.method, "params": params}
    return json.dumps(message, allow_nan=False).encode("ascii") + b"\n"


def result(answer: Mapping[str, Any], call: Call[T]) -> T:
    """What an answer means; raises the exception that an error means."""
    if "error" in answer:
        raise errors.of_answer(answer["error"])
    return call.meaning(answer["result"])


def _nothing(_: Any) -> None:
    return None


def create(
    *,
    model: Optional[str],
    arm: Optional[str],
    seed: Optional[int],
    installation: Optional[str],
    start: Optional[Sequence[float]],
    operator: Optional[str],
    answers: Optional[Mapping[str, Any]],
    inputs: Optional[Mapping[str, InputValue]],
    recording: bool,
    options: Optional[Mapping[str, Any]],
) -> Call[int]:
    params: Dict[str, Any] = {
        "robot": model,
        "arm": arm,
        "seed": seed,
        "installation": installation,
        "start": None if start is None else [float(each) for each in start],
        "operator": operator or ("absent" if answers is not None else None),
        "answer": None
        if answers is None
        else [f"{text}={value}" for text, value in answers.items()],
        "input": None if inputs is None else dict(inputs),
        "recording": recording,
    }
    params.update(options or {})
    return Call("robot.create", params, lambda answer: int(answer["handle"]))


def close() -> Call[None]:
    return Call("robot.close", {}, _nothing)


def info() -> Call[Dict[str, Any]]:
    return Call("server.info", {}, dict)


def load(file: str, text: Optional[str], begun_in: str) -> Call[List[Diagnostic]]:
    """``begun_in`` is the folder that the process was started in: paths are seen from there."""

    def meaning(answer: Any) -> List[Diagnostic]:
        diagnostics = [diagnostic_of(each) for each in answer["diagnostics"]]
        if not answer["loaded"]:
            raise errors.CompileError(answer["file"], diagnostics)
        return diagnostics

    if text is not None:
        return Call("program.load", {"text": text, "name": file}, meaning)
    same = os.getcwd() == begun_in
    return Call("program.load", {"file": file if same else os.path.abspath(file)}, meaning)


def do(method: str, **params: Any) -> Call[None]:
    """A call that answers nothing."""
    return Call(method, params, _nothing)


def state() -> Call[State]:
    return Call("state", {}, state_of)


def advance(seconds: Optional[float], frames: Optional[int], wall: Optional[float]) -> Call[State]:
    if (seconds is None) == (frames is None):
        raise TypeError("advance takes seconds or frames")
    params = {"seconds": seconds, "frames": frames, "wall": wall}
    return Call("advance", params, lambda answer: state_of(answer["state"]))


def advance_until(
    condition: Union[str, Condition], timeout: float, wall: Optional[float]
) -> Call[State]:
    def meaning(answer: Any) -> State:
        now = state_of(answer["state"])
        if answer["reason"] == "timeout":
            raise errors.RobotTimeout(f"after {timeout} s of robot time not {condition}", now)
        return now

    until = condition if isinstance(condition, str) else dict(condition)
    return Call("advance", {"until": until, "timeout": timeout, "wall": wall}, meaning)


def run_until_end(timeout: float, wall: Optional[float], check: bool) -> Call[State]:
    def meaning(answer: Any) -> State:
        now = state_of(answer["state"])
        if answer["reason"] == "timeout":
            raise errors.RobotTimeout(f"the program runs on after {timeout} s", now)
        stop = now.safety.stop
        if check and stop is not None:
            line = stop.line or 0
            raise errors.ProgramFailed(stop.message, now.program.file, line, 0, stop.code, now)
        if answer["reason"] == "question":
            raise errors.OperatorNeeded(f"the program asks: {now.questions[0].text}", now)
        if answer["reason"] == "popup":
            raise errors.OperatorNeeded(f"the program shows: {now.popups[0].text}", now)
        if answer["reason"] == "paused":
            raise errors.OperatorNeeded(f"paused in line {now.program.line}", now)
        ending = now.program.ending
        if check and ending is not None and ending.kind == "failed":
            raise errors.ProgramFailed(
                ending.message, ending.file, ending.line, ending.column, ending.code, now
            )
        return now

    return Call("advance", {"until": "ended", "timeout": timeout, "wall": wall}, meaning)


def read(names: Sequence[str]) -> Call[Dict[str, Any]]:
    return Call("read", {"names": list(names)}, dict)


def variables(names: Optional[Sequence[str]]) -> Call[Dict[str, Any]]:
    return Call("variables", {"names": None if names is None else list(names)}, dict)


def devices() -> Call[Dict[str, Device]]:
    return Call("devices", {}, lambda answer: {each["name"]: device_of(each) for each in answer})


def log(since: int) -> Call[List[LogEntry]]:
    return Call("log", {"since": since}, lambda answer: [LogEntry(**each) for each in answer])


class Recording:
    """A recording that comes in pieces."""

    def __init__(
        self, columns: Sequence[str], start: Optional[float], end: Optional[float], every: int
    ) -> None:
        self._columns = list(columns)
        self._next = start
        self._end = end
        self._every = every
        self._rows: Dict[str, List[Any]] = {name: [] for name in ["time_s", *self._columns]}
        self._more = True

    def next(self) -> Optional[Call[None]]:
        """The request for the next piece; none when all are there."""
        if not self._more:
            return None
        params = {
            "columns": self._columns,
            "from": self._next,
            "to": self._end,
            "every": self._every,
        }
        return Call("recording", params, self._take)

    def _take(self, answer: Any) -> None:
        self._rows["time_s"].extend(answer["time_s"])
        for name, cells in answer["columns"].items():
            self._rows[name].extend(cells)
        self._next = answer["next_s"]
        self._more = self._next is not None

    def table(self, numpy: Optional[bool]) -> Dict[str, Any]:
        """The columns by name, as arrays of NumPy where that is installed and not unwanted."""
        table: Dict[str, Any] = {
            name: [float("nan") if each is None else each for each in cells]
            for name, cells in self._rows.items()
        }
        if numpy is False:
            return table
        try:
            import numpy as np
        except ImportError:
            if numpy:
                raise
            return table
        return {name: np.asarray(cells) for name, cells in table.items()}
