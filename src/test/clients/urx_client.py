"""urx 0.11.0, with its real-time monitor: state, moves, outputs."""

import collections
import collections.abc
import math
import signal
import sys
import time

HOST = sys.argv[1]
GIVE_UP_S = 150

signal.alarm(GIVE_UP_S)

# math3d 3.4.1, the last that fits, uses names that Python 3.10 has moved
for name in ("Iterable", "Sequence", "Mapping", "Callable"):
    if not hasattr(collections, name):
        setattr(collections, name, getattr(collections.abc, name))

import urx  # noqa: E402
from urx import ursecmon  # noqa: E402

# urx tells the version of a box by the size of the robot mode data, and knows none of 47 bytes
analyze = ursecmon.ParserUtils.analyze_header


def analyze_as_before(self, data):
    size, kind, content, rest = analyze(self, data)
    return (46 if kind == 0 and size == 47 else size), kind, content, rest


ursecmon.ParserUtils.analyze_header = analyze_as_before


def check(what, right, found):
    print(what, found, flush=True)
    assert right, f"{what}: {found}"


def near(one, other, tolerance):
    return all(abs(a - b) <= tolerance for a, b in zip(one, other, strict=True))


def same_pose(one, other, tolerance):
    """A rotation by half a turn is the same one about the opposite axis."""
    opposite = [-component for component in other[3:]]
    return near(one[:3], other[:3], tolerance) and (
        near(one[3:], other[3:], tolerance) or near(one[3:], opposite, tolerance)
    )


def awaited(what, condition):
    """Waits for something that the next packages show."""
    end = time.monotonic() + 20
    while not condition():
        assert time.monotonic() < end, what
        time.sleep(0.05)
    print(what, flush=True)


robot = urx.Robot(HOST, use_rt=True)
try:
    check("running", robot.is_running(), robot.secmon._dict["RobotModeData"]["robotMode"])
    robot.set_tcp((0, 0, 0.1, 0, 0, 0))
    robot.set_payload(0.5)

    begin = robot.getj()
    check("joints", len(begin) == 6, begin)
    turned = list(begin)
    turned[5] += 0.4
    turned[0] -= 0.2
    robot.movej(turned, acc=2.0, vel=1.5)
    check("joints after movej", near(turned, robot.getj(wait=True), 0.002), robot.getj())
    monitor = robot.get_realtime_monitor()
    check("joints of the other port", near(turned, monitor.q_actual(wait=True), 0.002), turned)

    pose = robot.getl(wait=True)
    realtime = monitor.tcf_pose(wait=True)
    check("pose of the other port", same_pose(pose, realtime, 0.002), (pose, realtime))
    raised = list(pose)
    raised[2] += 0.05
    robot.movel(raised, acc=1.0, vel=0.25)
    check("pose after movel", near(raised[:3], robot.getl(wait=True)[:3], 0.001), robot.getl())
    robot.translate((0, 0.04, -0.03), acc=1.0, vel=0.25)
    moved = robot.getl(wait=True)
    check(
        "pose after translate",
        near((raised[0], raised[1] + 0.04, raised[2] - 0.03), moved[:3], 0.001),
        moved,
    )
    robot.movels(
        [[*moved[:2], moved[2] + 0.03, *moved[3:]], moved], acc=1.0, vel=0.25, radius=0.01
    )
    check("pose after movels", near(moved[:3], robot.getl(wait=True)[:3], 0.001), robot.getl())

    # what set_digital_out, speedj and a payload with its centre send is not the language of today:
    # an array digital_out, an argument t_min, a list in round brackets
    for level in (True, False):
        robot.send_program(f"set_digital_out(3, {level})")
        awaited(f"output 3 {level}", lambda: bool(robot.get_digital_out(3)) == level)
    robot.set_analog_out(0, 0.5)
    robot.set_tool_voltage(24)
    inputs = robot.get_analog_inputs()
    check("analog inputs", all(math.isfinite(each) for each in inputs), inputs)
    check("digital inputs", robot.get_digital_in_bits() == 0, robot.get_digital_in_bits())

    force = robot.get_tcp_force()
    check("force", len(force) == 6 and all(map(math.isfinite, force)), force)

    before = robot.getj(wait=True)[5]
    robot.send_program("speedj([0, 0, 0, 0, 0, 0.5], 2.0, 30)")
    awaited("wrist 3 turns", lambda: robot.getj()[5] > before + 0.3)
    robot.stopj(2.0)
    awaited(
        "wrist 3 stands",
        lambda: abs(robot.getj(wait=True)[5] - robot.getj(wait=True)[5]) < 1e-4,
    )

    robot.send_program("def waits():\n  sleep(60)\nend")
    awaited("program runs", robot.is_program_running)
    robot.stop()
    awaited("program ended", lambda: not robot.secmon.is_program_running(wait=True))
finally:
    robot.close()
