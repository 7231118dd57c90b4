"""
Robots with ``async``; what they do is that of :mod:`pendant.client`::

    async with pendant.aio.Robot(model="ur5e") as robot:
        await robot.load("pick.script")
        await robot.start()
        await robot.run_until_end()
"""

from __future__ import annotations

import asyncio
import json
import os
from types import TracebackType
from typing import Any, Dict, List, Mapping, Optional, Sequence, Type, TypeVar, Union

from . import calls
from .calls import Condition, InputValue
from .errors import ConnectionLost
from .launcher import Launcher, command
from .state import Device, Diagnostic, LogEntry, State

T = TypeVar("T")

#: Bytes of an answer at most.
_MAX_BYTES = 1 << 28

#: How long a process may take to end by itself, s.
_END_S = 5.0


class Pendant:
    """A process of Pendant, in which any number of robots live. Tasks may share it."""

    def __init__(self, launcher: Optional[Launcher] = None) -> None:
        self.begun_in = os.getcwd()
        self._command = command(launcher)
        self._process: Optional[asyncio.subprocess.Process] = None
        self._reader: Optional[asyncio.Task[None]] = None
        self._waiting: Dict[int, asyncio.Future[Mapping[str, Any]]] = {}
        self._number = 0

    async def open(self) -> Pendant:
        """Starts the process."""
        self._process = await asyncio.create_subprocess_exec(
            *self._command,
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            limit=_MAX_BYTES,
        )
        self._reader = asyncio.create_task(self._read(self._process))
        return self

    async def _read(self, process: asyncio.subprocess.Process) -> None:
        assert process.stdout is not None
        lost = "pendant rpc has ended"
        try:
            async for line in process.stdout:
                answer = json.loads(line)
                waiting = self._waiting.pop(answer.get("id"), None)
                if waiting is not None and not waiting.done():
                    waiting.set_result(answer)
        except (ValueError, AttributeError):
            lost = "this is not pendant rpc, it said what is no answer"
        finally:
            for each in self._waiting.values():
                if not each.done():
                    each.set_exception(ConnectionLost(lost))
            self._waiting.clear()

    @property
    def alive(self) -> bool:
        """Whether the process can be asked."""
        return self._process is not None and self._process.returncode is None

    def robot(self, model: Optional[str] = None, **options: Any) -> Robot:
        """A robot in this process, to be opened; the options are those of :class:`Robot`."""
        return Robot(model, pendant=self, **options)

    async def info(self) -> Dict[str, Any]:
        """Version and methods."""
        return await self.call(calls.info())

    async def call(self, call: calls.Call[T], handle: Optional[int] = None) -> T:
        """Sends a request and waits for what its answer means."""
        if self._process is None or self._reader is None or self._reader.done():
            raise ConnectionLost("pendant rpc does not run")
        assert self._process.stdin is not None
        self._number += 1
        number = self._number
        answer: asyncio.Future[Mapping[str, Any]] = asyncio.get_running_loop().create_future()
        self._waiting[number] = answer
        try:
            self._process.stdin.write(calls.request(number, call, handle))
            await self._process.stdin.drain()
        except ConnectionError as problem:
            self._waiting.pop(number, None)
            raise ConnectionLost("pendant rpc has ended") from problem
        return calls.result(await answer, call)

    async def close(self) -> None:
        """Ends the process, and with it all its robots."""
        process = self._process
        if process is None:
            return
        self._process = None
        if process.stdin is not None:
            process.stdin.close()
        try:
            await asyncio.wait_for(process.wait(), _END_S)
        except asyncio.TimeoutError:
            process.kill()
            await process.wait()
        if self._reader is not None:
            await self._reader

    async def __aenter__(self) -> Pendant:
        return await self.open()

    async def __aexit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        await self.close()


class Robot:
    """As :class:`pendant.Robot`, with ``await``; it begins with ``async with``, or :meth:`open`."""

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
        self._creation = calls.create(
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
        self._handle: Optional[int] = None

    async def open(self) -> Robot:
        """Switches the robot on."""
        if self._own:
            await self.pendant.open()
        try:
            self._handle = await self.pendant.call(self._creation)
        except BaseException:
            if self._own:
                await self.pendant.close()
            raise
        return self

    async def call(self, call: calls.Call[T]) -> T:
        """Sends a request about this robot."""
        if self._handle is None:
            raise ConnectionLost("the robot is not open")
        return await self.pendant.call(call, self._handle)

    async def load(
        self, file: Union[str, os.PathLike[str]], text: Optional[str] = None
    ) -> List[Diagnostic]:
        """Loads a program, from a file or as a text under that name; returns the warnings."""
        return await self.call(calls.load(os.fspath(file), text, self.pendant.begun_in))

    async def start(self) -> None:
        """Starts the program that was loaded last."""
        await self.call(calls.do("program.start"))

    async def stop(self) -> None:
        """Ends the program."""
        await self.call(calls.do("program.stop"))

    async def pause(self) -> None:
        """Pauses the program."""
        await self.call(calls.do("program.pause"))

    async def resume(self) -> None:
        """Continues the program."""
        await self.call(calls.do("program.resume"))

    async def advance(
        self,
        seconds: Optional[float] = None,
        *,
        frames: Optional[int] = None,
        wall: Optional[float] = None,
    ) -> State:
        """Lets time pass, in s or in frames of 2 ms."""
        return await self.call(calls.advance(seconds, frames, wall))

    async def advance_until(
        self,
        condition: Union[str, Condition],
        timeout: float = calls.CONDITION_TIMEOUT_S,
        wall: Optional[float] = None,
    ) -> State:
        """Lets time pass until a condition holds."""
        return await self.call(calls.advance_until(condition, timeout, wall))

    async def run_until_end(
        self,
        timeout: float = calls.END_TIMEOUT_S,
        wall: Optional[float] = None,
        check: bool = True,
    ) -> State:
        """Lets time pass until the program has ended."""
        return await self.call(calls.run_until_end(timeout, wall, check))

    async def run(self, file: Union[str, os.PathLike[str]], text: Optional[str] = None) -> State:
        """:meth:`load`, :meth:`start` and :meth:`run_until_end`."""
        await self.load(file, text)
        await self.start()
        return await self.run_until_end()

    async def state(self) -> State:
        """The robot at this moment."""
        return await self.call(calls.state())

    async def set_inputs(self, values: Mapping[str, InputValue]) -> None:
        """Sets inputs, all at the same moment."""
        await self.call(calls.do("inputs.set", values=dict(values)))

    async def variables(self, *names: str) -> Dict[str, Any]:
        """Global variables of the running or last program, all of them if none is named."""
        return await self.call(calls.variables(names or None))

    async def devices(self) -> Dict[str, Device]:
        """Grippers, doors and sensors of the cell, by name, as they are now."""
        return await self.call(calls.devices())

    async def put_part(self, device: str, width_m: float) -> None:
        """Puts a part of this width between the fingers of a gripper; 0 takes it away."""
        await self.call(calls.do("device.put_part", device=device, width=width_m))

    async def set_signal(self, signal: str, value: int) -> None:
        """Sets a signal of the cell, such as ``plc.register[3]`` or ``digital_in[0]``."""
        await self.call(calls.do("device.set_signal", signal=signal, value=int(value)))

    async def read(self, name: str) -> Any:
        """A quantity: ``actual_q``, ``actual_tcp_z``, ``digital_out[0]``, ..."""
        return (await self.call(calls.read([name])))[name]

    async def log(self, since: int = 0) -> List[LogEntry]:
        """Log lines after number ``since``."""
        return await self.call(calls.log(since))

    async def set_speed(self, fraction: float) -> None:
        """Moves the speed slider, 0 to 1."""
        await self.call(calls.do("speed", fraction=fraction))

    async def close_popup(self, number: Optional[int] = None) -> None:
        """Closes a popup, the oldest if none is named."""
        await self.call(calls.do("popup.close", number=number))

    async def answer(
        self, value: Union[bool, int, float, str], number: Optional[int] = None
    ) -> None:
        """Answers a question, the oldest if none is named."""
        await self.call(calls.do("question.answer", number=number, answer=value))

    async def set_safety(self, **inputs: bool) -> None:
        """Safety inputs: ``emergency_stop``, ``safeguard_stop``, ``reduced_mode``, ..."""
        await self.call(calls.do("safety.set", values=inputs))

    async def unlock(self) -> None:
        """Ends a protective stop; the program stays paused."""
        await self.call(calls.do("safety.do", action="unlock"))

    async def restart_safety(self) -> None:
        """Starts the safety functions again after a violation or a fault."""
        await self.call(calls.do("safety.do", action="restart"))

    async def power_on(self) -> None:
        """Powers the arm on; it rests on its brakes then."""
        await self.call(calls.do("safety.do", action="power_on"))

    async def power_off(self) -> None:
        """Powers the arm off; a program ends."""
        await self.call(calls.do("safety.do", action="power_off"))

    async def release_brakes(self) -> None:
        """Releases the brakes of a powered arm."""
        await self.call(calls.do("safety.do", action="release_brakes"))

    async def trace(self, *variables: str) -> None:
        """Has variables recorded in every frame from now on, as columns ``var:NAME``."""
        await self.call(calls.do("trace", variables=list(variables)))

    async def recording(
        self,
        *columns: str,
        start: Optional[float] = None,
        end: Optional[float] = None,
        every: int = 1,
        numpy: Optional[bool] = None,
    ) -> Dict[str, Any]:
        """What was recorded, as columns by name, ``time_s`` first."""
        recording = calls.Recording(columns, start, end, every)
        call = recording.next()
        while call is not None:
            await self.call(call)
            call = recording.next()
        return recording.table(numpy)

    async def close(self) -> None:
        """Switches the robot off."""
        if self._handle is None:
            return
        if self._own:
            await self.pendant.close()
        elif self.pendant.alive:
            await self.call(calls.close())
        self._handle = None

    async def __aenter__(self) -> Robot:
        return await self.open()

    async def __aexit__(
        self,
        kind: Optional[Type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        await self.close()
