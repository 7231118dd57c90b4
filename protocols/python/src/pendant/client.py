"""Robots without ``async``."""

from __future__ import annotations

import collections
import json
import os
import subprocess
import threading
from types import TracebackType
from typing import (
    Any,
    Deque,
    Dict,
    Iterator,
    List,
    Mapping,
    Optional,
    Sequence,
    Type,
    TypeVar,
    Union,
)

from . import calls
from .calls import Condition, InputValue
from .errors import ConnectionLost, InvalidParams
from .launcher import Launcher, command
from .state import Device, Diagnostic, LogEntry, State

T = TypeVar("T")

#: How long a process may take to end by itself, s.
_END_S = 5.0

#: Lines of standard error that are kept for messages.
_KEPT_LINES = 50


class Pendant:
    """
    A process of Pendant, in which any number of robots live. Threads may share it: their calls
    come one after the other.
    """

    def __init__(self, launcher: Optional[Launcher] = None) -> None:
        self.begun_in = os.getcwd()
        self._lock = threading.Lock()
        self._number = 0
        self._said: Deque[str] = collections.deque(maxlen=_KEPT_LINES)
        self._process = subprocess.Popen(
            command(launcher),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        self._listener = threading.Thread(target=self._listen, daemon=True)
        self._listener.start()

    def _listen(self) -> None:
        assert self._process.stderr is not None
        for line in self._process.stderr:
            self._said.append(line.decode("utf-8", "replace").rstrip())

    @property
    def alive(self) -> bool:
        """Whether the process can be asked."""
        return self._process.poll() is None

    def robot(self, model: Optional[str] = None, **options: Any) -> Robot:
        """A robot in this process; the options are those of :class:`Robot`."""
        return Robot(model, pendant=self, **options)

    def info(self) -> Dict[str, Any]:
        """Version and methods."""
        return self.call(calls.info())

    def call(self, call: calls.Call[T], handle: Optional[int] = None) -> T:
        """Sends a request and waits for what its answer means."""
        if self._process.stdin is None or self._process.stdin.closed:
            raise ConnectionLost("the process was closed")
        with self._lock:
            self._number += 1
            number = self._number
            try:
                self._process.stdin.write(calls.request(number, call, handle))
                self._process.stdin.flush()
                answer = self._answer(number)
            except OSError as problem:
                raise self._lost() from problem
        return calls.result(answer, call)

    def _answer(self, number: int) -> Mapping[str, Any]:
        """The answer to a request, behind those that nobody has waited for."""
        assert self._process.stdout is not None
        while True:
            line = self._process.stdout.readline()
            if not line:
                raise self._lost()
            try:
                answer: Mapping[str, Any] = json.loads(line)
                if answer.get("id") in (number, None):
                    return answer
            except (ValueError, AttributeError) as problem:
                raise ConnectionLost(f"this is not pendant rpc, it said {line[:80]!r}") from problem

    def _lost(self) -> ConnectionLost:
        try:
            code: Optional[int] = self._process.wait(_END_S)
        except subprocess.TimeoutExpired:
            code = None
        self._listener.join(1)
        said = "\n".join(self._said)
        return ConnectionLost(f"pendant rpc has ended with {code}" + (f":\n{said}" if said else ""))

    def close(self) -> None:
        """Ends the process, and with it all its robots."""
        process = self._process
        if process.stdin is not None and not process.stdin.closed:
            try:
                process.stdin.close()
            except OSError:
                pass  # it has ended already
        try:
            process.wait(_END_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        self._listener.join(1)
        for stream in (process.stdout, process.stderr):
            if stream is not None:
                stream.close()

    def __enter__(self) -> Pendant:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        self.close()


class Inputs:
    """The inputs of a robot: ``robot.inputs["digital_in[0]"] = True``."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot

    def __setitem__(self, name: str, value: InputValue) -> None:
        self.update({name: value})

    def __getitem__(self, name: str) -> Any:
        try:
            return self._robot.read(name)
        except InvalidParams as unknown:
            raise KeyError(unknown.message) from None

    def update(self, values: Mapping[str, InputValue]) -> None:
        """Sets several at the same moment."""
        self._robot.call(calls.do("inputs.set", values=dict(values)))


class Variables(Mapping[str, Any]):
    """The global variables of the running or last program, as they are when one is looked up."""

    def __init__(self, robot: Robot) -> None:
        self._robot = robot

    def _all(self) -> Dict[str, Any]:
        return self._robot.call(calls.variables(None))

    def __getitem__(self, name: str) -> Any:
        try:
            return self._robot.call(calls.variables([name]))[name]
        except InvalidParams:
            raise KeyError(name) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._all())

    def __len__(self) -> int:
        return len(self._all())

    def __repr__(self) -> str:
        return repr(self._all())


class Robot:
    """
    A robot in virtual time, powered and ready: time passes in :meth:`advance`,
    :meth:`advance_until` and :meth:`run_until_end` alone, so the same calls give the same numbers.

    :param model: such as ``ur5e``; ``pendant robots`` lists them
    :param arm: ``dynamic``, with masses and drives, or ``ideal``, always exactly on target
    :param seed: of random numbers and noise
    :param installation: file that says how the robot is set up
    :param start: angles of the joints at first, rad
    :param operator: ``present``: popups and questions wait for :meth:`close_popup` and
        :meth:`answer`; ``absent``: popups close at once, and questions get what ``answers`` has
    :param answers: values by the text of a question, of an operator that is absent
    :param inputs: what inputs have from the start
    :param recording: whether :meth:`recording` is wanted
    :param options: other options of ``pendant run``, such as ``{"scene": "table.scene.json"}``
    :param pendant: the process that it lives in; without one it gets its own
    :param launcher: the ``pendant`` command, see :func:`pendant.launcher.command`
    """

    def __init__(
        self,
        model: Optional[str] = None,
        *,
        arm: Optional[str] = None,
        seed: Optional[int] = None,
        installation: Optional[str] = None,
        start: Optional[Sequence[float]] = None,
        operator: Optional[str] = None,
        answers: Optional[Mapping[str, Any]] = None,
        inputs: Optional[Mapping[str, InputValue]] = None,
        recording: bool = True,
        options: Optional[Mapping[str, Any]] = None,
        pendant: Optional[Pendant] = None,
        launcher: Optional[Launcher] = None,
    ) -> None:
        creation = calls.create(
            model=model,
            arm=arm,
            seed=seed,
            installation=installation,
            start=start,
            operator=operator,
            answers=answers,
            inputs=inputs,
            recording=recording,
            options=options,
        )
        self._own = pendant is None
        self.pendant = Pendant(launcher) if pendant is None else pendant
        self._closed = False
        try:
            self._handle = self.pendant.call(creation)
        except BaseException:
            if self._own:
                self.pendant.close()
            raise

    def call(self, call: calls.Call[T]) -> T:
        """Sends a request about this robot."""
        return self.pendant.call(call, self._handle)

    def load(self, file: Union[str, os.PathLike[str]], text: Optional[str] = None) -> List[Diagnostic]:
        """
        Loads a program: the script or tree in ``file``, or ``text`` under that name. Returns the
        warnings.

        :raises CompileError: if it does not compile
        """
        return self.call(calls.load(os.fspath(file), text, self.pendant.begun_in))

    def start(self) -> None:
        """Starts the program that was loaded last; it runs as time passes."""
        self.call(calls.do("program.start"))

    def stop(self) -> None:
        """Ends the program; the arm comes to rest as time passes."""
        self.call(calls.do("program.stop"))

    def pause(self) -> None:
        """Pauses the program."""
        self.call(calls.do("program.pause"))

    def resume(self) -> None:
        """Continues the program."""
        self.call(calls.do("program.resume"))

    def advance(
        self,
        seconds: Optional[float] = None,
        *,
        frames: Optional[int] = None,
        wall: Optional[float] = None,
    ) -> State:
        """Lets time pass, in s or in frames of 2 ms; for at most ``wall`` seconds on the wall."""
        return self.call(calls.advance(seconds, frames, wall))

    def advance_until(
        self,
        condition: Union[str, Condition],
        timeout: float = calls.CONDITION_TIMEOUT_S,
        wall: Optional[float] = None,
    ) -> State:
        """
        Lets time pass until a condition holds: ``{"digital_out[0]": True, "var:n": {"above": 2}}``,
        or ``"rest"`` for an arm that stands still without a program that runs.

        :raises RobotTimeout: if it does not hold within ``timeout`` seconds of robot time
        """
        return self.call(calls.advance_until(condition, timeout, wall))

    def run_until_end(
        self,
        timeout: float = calls.END_TIMEOUT_S,
        wall: Optional[float] = None,
        check: bool = True,
    ) -> State:
        """
        Lets time pass until the program has ended.

        :param check: whether a program that has failed raises an exception
        :raises ProgramFailed: if a runtime error or a safety function ended it
        :raises OperatorNeeded: if it waits for an operator
        :raises RobotTimeout: if it runs longer than ``timeout`` seconds of robot time
        """
        return self.call(calls.run_until_end(timeout, wall, check))

    def run(self, file: Union[str, os.PathLike[str]], text: Optional[str] = None) -> State:
        """:meth:`load`, :meth:`start` and :meth:`run_until_end`."""
        self.load(file, text)
        self.start()
        return self.run_until_end()

    @property
    def state(self) -> State:
        """The robot at this moment."""
        return self.call(calls.state())

    @property
    def inputs(self) -> Inputs:
        """Inputs, to be set and read."""
        return Inputs(self)

    @property
    def variables(self) -> Variables:
        """Global variables of the running or last program."""
        return Variables(self)

    @property
    def devices(self) -> Dict[str, Device]:
        """Grippers, doors and sensors of the cell, by name, as they are now."""
        return self.call(calls.devices())

    def put_part(self, device: str, width_m: float) -> None:
        """Puts a part of this width between the fingers of a gripper; 0 takes it away."""
        self.call(calls.do("device.put_part", device=device, width=width_m))

    def set_signal(self, signal: str, value: int) -> None:
        """Sets a signal of the cell, such as ``plc.register[3]`` or ``digital_in[0]``."""
        self.call(calls.do("device.set_signal", signal=signal, value=int(value)))

    def read(self, name: str) -> Any:
        """A quantity: ``actual_q``, ``actual_tcp_z``, ``digital_out[0]``, ..."""
        return self.call(calls.read([name]))[name]

    def log(self, since: int = 0) -> List[LogEntry]:
        """Log lines after number ``since``."""
        return self.call(calls.log(since))

    def set_speed(self, fraction: float) -> None:
        """Moves the speed slider, 0 to 1."""
        self.call(calls.do("speed", fraction=fraction))

    def close_popup(self, number: Optional[int] = None) -> None:
        """Closes a popup, the oldest if none is named."""
        self.call(calls.do("popup.close", number=number))

    def answer(self, value: Union[bool, int, float, str], number: Optional[int] = None) -> None:
        """Answers a question, the oldest if none is named."""
        self.call(calls.do("question.answer", number=number, answer=value))

    def set_safety(self, **inputs: bool) -> None:
        """Safety inputs: ``emergency_stop``, ``safeguard_stop``, ``reduced_mode``, ..."""
        self.call(calls.do("safety.set", values=inputs))

    def unlock(self) -> None:
        """Ends a protective stop; the program stays paused."""
        self.call(calls.do("safety.do", action="unlock"))

    def restart_safety(self) -> None:
        """Starts the safety functions again after a violation or a fault."""
        self.call(calls.do("safety.do", action="restart"))

    def power_on(self) -> None:
        """Powers the arm on; it rests on its brakes then."""
        self.call(calls.do("safety.do", action="power_on"))

    def power_off(self) -> None:
        """Powers the arm off; a program ends."""
        self.call(calls.do("safety.do", action="power_off"))

    def release_brakes(self) -> None:
        """Releases the brakes of a powered arm."""
        self.call(calls.do("safety.do", action="release_brakes"))

    def trace(self, *variables: str) -> None:
        """Has variables recorded in every frame from now on, as columns ``var:NAME``."""
        self.call(calls.do("trace", variables=list(variables)))

    def recording(
        self,
        *columns: str,
        start: Optional[float] = None,
        end: Optional[float] = None,
        every: int = 1,
        numpy: Optional[bool] = None,
    ) -> Dict[str, Any]:
        """
        What was recorded, as columns by name, ``time_s`` first: quantities, and ``var:NAME`` for
        variables that were traced.

        :param start: robot time to begin with, s
        :param end: robot time to end with, s
        :param every: every how many frames there is a row
        :param numpy: arrays of NumPy or lists; otherwise arrays where NumPy is installed
        """
        recording = calls.Recording(columns, start, end, every)
        call = recording.next()
        while call is not None:
            self.call(call)
            call = recording.next()
        return recording.table(numpy)

    def close(self) -> None:
        """Switches the robot off."""
        if self._closed:
            return
        self._closed = True
        if self._own:
            self.pendant.close()
        elif self.pendant.alive:
            self.call(calls.close())

    def __enter__(self) -> Robot:
        return self

    def __exit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        self.close()
