"""What robots tell of themselves: immutable values. SI units, angles in rad, poses in the base frame."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Dict, List, Mapping, Optional, Tuple

Numbers = Tuple[float, ...]


@dataclass(frozen=True)
class Diagnostic:
    """What is wrong in a program, and where."""

    file: str
    line: int
    column: int
    severity: str
    code: str
    message: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}: {self.severity}: {self.message}"


@dataclass(frozen=True)
class Device:
    """A device of the cell: a gripper, a door, a sensor."""

    name: str
    #: What it is, for people.
    kind: str
    #: How far its fingers, or its door, open, m; 0 where it has none.
    stroke_m: float
    #: How far they are open, m.
    opening_m: float
    #: How hard they press on a part, N; 0 where they hold none.
    force_n: float
    #: Whether it holds a part, or sees something.
    on: bool
    #: How wide the part is that is there for it to hold, m; 0 for none.
    part_m: float
    #: Its signals that the cell is wired to, by their names, such as ``coil[0]``.
    signals: Dict[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class Ending:
    """How a program has ended: ``finished``, ``halted``, ``stopped`` or ``failed``."""

    kind: str
    message: str = ""
    code: str = ""
    file: str = ""
    line: int = 0
    column: int = 0


@dataclass(frozen=True)
class Program:
    """The running or last program; ``state`` is ``running``, ``paused`` or ``stopped``."""

    state: str
    name: str
    file: str
    line: int
    ending: Optional[Ending]


@dataclass(frozen=True)
class SafetyStop:
    """Why the arm may not move."""

    code: str
    message: str
    time_s: float
    line: Optional[int]


@dataclass(frozen=True)
class Safety:
    """Modes, as words: ``robot_mode`` such as ``running``, ``safety_mode`` such as ``normal``."""

    robot_mode: str
    safety_mode: str
    reduced: bool
    stop: Optional[SafetyStop]


@dataclass(frozen=True)
class Popup:
    """A message window; a program that shows a blocking one waits until it is closed."""

    number: int
    time_s: float
    title: str
    text: str
    severity: str
    blocking: bool


@dataclass(frozen=True)
class Question:
    """What a program asks; ``kind`` is ``boolean``, ``integer``, ``float`` or ``string``."""

    number: int
    time_s: float
    kind: str
    text: str


@dataclass(frozen=True)
class LogEntry:
    """A line of the log."""

    number: int
    time_s: float
    level: str
    origin: str
    code: str
    text: str
    source: Optional[str]
    line: Optional[int]

    def __str__(self) -> str:
        return f"{self.time_s:10.3f} {self.level:7} {self.text}"


@dataclass(frozen=True)
class State:
    """
    A robot at one moment.

    ``state["digital_out[0]"]`` and ``state["output_integer_register[3]"]`` are its signals and
    registers; ``raw`` is all that was sent.
    """

    time_s: float
    frame: int
    joints: Numbers
    target_joints: Numbers
    joint_speeds: Numbers
    target_joint_speeds: Numbers
    currents: Numbers
    torques: Numbers
    temperatures: Numbers
    tcp_pose: Numbers
    target_tcp_pose: Numbers
    tcp_velocity: Numbers
    tcp_speed: float
    tcp_wrench: Numbers
    tcp_force: float
    payload: float
    speed_slider: float
    speed_scaling: float
    encoders: Tuple[int, int]
    moving: bool
    program: Program
    safety: Safety
    popups: Tuple[Popup, ...]
    questions: Tuple[Question, ...]
    newest_log: int
    raw: Mapping[str, Any] = field(repr=False, compare=False)

    def __getitem__(self, name: str) -> Any:
        bank, bracket, rest = name.partition("[")
        signals: Mapping[str, List[Any]] = self.raw["signals"]
        if bracket and rest.endswith("]") and rest[:-1].isdigit():
            if bank in signals and int(rest[:-1]) < len(signals[bank]):
                return signals[bank][int(rest[:-1])]
            if bank.endswith("_register"):
                registers: Mapping[str, Any] = self.raw["registers"]
                nothing = {"boolean": False, "float": 0.0}.get(bank.split("_")[1], 0)
                return registers.get(name, nothing)
        raise KeyError(name)


def _numbers(values: List[Optional[float]]) -> Numbers:
    return tuple(float("nan") if each is None else float(each) for each in values)


def state_of(raw: Mapping[str, Any]) -> State:
    """The state that an answer tells."""
    program = raw["program"]
    safety = raw["safety"]
    return State(
        time_s=raw["time_s"],
        frame=raw["frame"],
        joints=_numbers(raw["actual_q"]),
        target_joints=_numbers(raw["target_q"]),
        joint_speeds=_numbers(raw["actual_qd"]),
        target_joint_speeds=_numbers(raw["target_qd"]),
        currents=_numbers(raw["current"]),
        torques=_numbers(raw["torque"]),
        temperatures=_numbers(raw["temperature"]),
        tcp_pose=_numbers(raw["actual_tcp"]),
        target_tcp_pose=_numbers(raw["target_tcp"]),
        tcp_velocity=_numbers(raw["tcp_velocity"]),
        tcp_speed=raw["tcp_speed"],
        tcp_wrench=_numbers(raw["tcp_wrench"]),
        tcp_force=raw["tcp_force"],
        payload=raw["payload"],
        speed_slider=raw["speed_slider"],
        speed_scaling=raw["speed_scaling"],
        encoders=(raw["encoder_0"], raw["encoder_1"]),
        moving=raw["moving"],
        program=Program(
            program["state"],
            program["name"],
            program["file"],
            program["line"],
            Ending(**program["ending"]) if program["ending"] else None,
        ),
        safety=Safety(
            safety["robot_mode"],
            safety["safety_mode"],
            safety["reduced"],
            SafetyStop(**safety["stop"]) if safety["stop"] else None,
        ),
        popups=tuple(Popup(**each) for each in raw["popups"]),
        questions=tuple(Question(**each) for each in raw["questions"]),
        newest_log=raw["newest_log"],
        raw=raw,
    )


def diagnostic_of(raw: Mapping[str, Any]) -> Diagnostic:
    """The diagnostic that an answer tells."""
    return Diagnostic(
        raw["file"], raw["line"], raw["column"], raw["severity"], raw["code"], raw["message"]
    )


def device_of(raw: Mapping[str, Any]) -> Device:
    """The device that an answer tells."""
    return Device(
        raw["name"],
        raw["kind"],
        raw["stroke_m"],
        raw["opening_m"],
        raw["force_n"],
        raw["on"],
        raw["part_m"],
        raw["signals"],
    )
