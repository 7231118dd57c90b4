"""RTDEControlInterface with its own uploaded program: moves, servos, forces and what it reads."""
# serve: --ready

import math
import signal
import socket
import struct
import sys
import time

from rtde_control import Path, PathEntry, RTDEControlInterface
from rtde_receive import RTDEReceiveInterface

HOST = sys.argv[1]
GIVE_UP_S = 240
EFFECT_S = 10
PERIOD_S = 0.002

START = [0.0, -1.5708, -1.5708, -1.5708, 1.5708, 0.0]

signal.alarm(GIVE_UP_S)


def passed(what):
    print("ok", what, flush=True)


def near(found, wanted, tolerance, what):
    assert len(found) == len(wanted), (what, found, wanted)
    for each, right in zip(found, wanted):
        assert abs(each - right) <= tolerance, (what, found, wanted)


def near_pose(found, wanted, tolerance, what):
    """As near, for poses: at half a turn the noise of readings turns rotation vectors round."""
    near(found[:3], wanted[:3], tolerance, what)
    near(opposite_if_nearer(found[3:], wanted[3:]), wanted[3:], tolerance, what)


def opposite_if_nearer(vector, wanted):
    angle = math.hypot(*vector)
    opposite = [each * (1 - 2 * math.pi / angle) for each in vector]
    return min(vector, opposite, key=lambda each: math.dist(each, wanted))


def until(condition, what):
    end = time.monotonic() + EFFECT_S
    while not condition():
        assert time.monotonic() < end, what
        time.sleep(PERIOD_S)


def moved(pose, x=0.0, y=0.0, z=0.0):
    return [pose[0] + x, pose[1] + y, pose[2] + z] + list(pose[3:])


def turned(q, joint, angle):
    return [each + (angle if i == joint else 0) for i, each in enumerate(q)]


def settled(question):
    """The answer to a question whose answer the library does not wait for."""
    question()
    time.sleep(0.1)
    return question()


def moves(control, receive):
    assert control.moveJ(START, 2.0, 4.0)
    near(receive.getTargetQ(), START, 1e-3, "moveJ")
    passed("moveJ")
    pose = receive.getTargetTCPPose()
    assert control.moveL(moved(pose, y=0.1), 0.5, 2.0)
    near(receive.getTargetTCPPose()[:3], moved(pose, y=0.1)[:3], 1e-3, "moveL")
    passed("moveL")
    assert control.moveL_FK(START, 0.5, 2.0)
    near(receive.getTargetQ(), START, 1e-3, "moveL_FK")
    assert control.moveJ_IK(moved(pose, z=-0.05), 2.0, 4.0)
    near(receive.getTargetTCPPose()[:3], moved(pose, z=-0.05)[:3], 1e-3, "moveJ_IK")
    passed("moveL_FK, moveJ_IK")
    assert control.moveJ(turned(START, 0, 1.0), 1.0, 2.0, True)
    until(lambda: abs(receive.getTargetQ()[0]) > 0.1, "moveJ has not begun")
    control.stopJ(4.0)
    assert 0.1 < receive.getTargetQ()[0] < 0.95, receive.getTargetQ()
    passed("asynchronous moveJ, stopJ")
    assert control.moveJ(START, 2.0, 4.0)


def paths(control, receive):
    pose = receive.getTargetTCPPose()
    corners = [moved(pose, y=0.1), moved(pose, y=0.1, z=-0.1), moved(pose, z=-0.1), pose]
    rows = [corner + [0.25, 0.5, 0.02] for corner in corners[:-1]] + [pose + [0.25, 0.5, 0.0]]
    assert control.moveL(rows)
    near(receive.getTargetTCPPose()[:3], pose[:3], 1e-3, "path of moveL")
    joints = [turned(START, 0, 0.2), turned(START, 0, 0.4), START]
    assert control.moveJ([q + [1.0, 2.0, r] for q, r in zip(joints, (0.02, 0.02, 0.0))])
    near(receive.getTargetQ(), START, 1e-3, "path of moveJ")
    path = Path()
    path.addEntry(
        PathEntry(PathEntry.MoveJ, PathEntry.PositionJoints, START + [1.0, 2.0, 0.0])
    )
    for corner in corners:
        path.addEntry(
            PathEntry(PathEntry.MoveL, PathEntry.PositionTcpPose, corner + [0.25, 0.5, 0.0])
        )
    path.addEntry(
        PathEntry(PathEntry.MoveP, PathEntry.PositionTcpPose, corners[0] + [0.25, 0.5, 0.02])
    )
    path.addEntry(PathEntry(PathEntry.MoveP, PathEntry.PositionTcpPose, pose + [0.25, 0.5, 0.0]))
    assert control.movePath(path)
    near(receive.getTargetTCPPose()[:3], pose[:3], 1e-3, "movePath")
    passed("paths with blends")


def speeds(control, receive):
    for _ in range(250):
        begin = control.initPeriod()
        assert control.speedJ([0.3, 0, 0, 0, 0, 0], 2.0, PERIOD_S)
        control.waitPeriod(begin)
    near(receive.getTargetQd(), [0.3, 0, 0, 0, 0, 0], 0.05, "speedJ")
    assert control.speedStop()
    until(lambda: max(map(abs, receive.getTargetQd())) < 1e-6, "speedStop")
    passed("speedJ, speedStop")
    before = receive.getTargetTCPPose()
    for _ in range(250):
        begin = control.initPeriod()
        assert control.speedL([0, 0, -0.1, 0, 0, 0], 1.0, PERIOD_S)
        control.waitPeriod(begin)
    near(receive.getTargetTCPSpeed()[:3], [0, 0, -0.1], 0.02, "speedL")
    assert control.speedStop()
    assert receive.getTargetTCPPose()[2] < before[2] - 0.02
    passed("speedL")
    assert control.moveJ(START, 2.0, 4.0)


def servos(control, receive):
    """A circle in joint space at 500 Hz. A moment in which the computer was busy elsewhere says nothing, so
    the median counts."""
    lags = []
    for step in range(1000):
        begin = control.initPeriod()
        angle = 2 * math.pi * step / 500
        wanted = turned(turned(START, 0, 0.1 * math.sin(angle)), 1, 0.1 * (math.cos(angle) - 1))
        assert control.servoJ(wanted, 0, 0, PERIOD_S, 0.03, 500)
        if step > 100:
            lags.append(max(abs(a - b) for a, b in zip(receive.getTargetQ(), wanted)))
        control.waitPeriod(begin)
    assert control.servoStop()
    lag = sorted(lags)[len(lags) // 2]
    assert lag < 0.05, lag
    until(lambda: max(map(abs, receive.getTargetQd())) < 1e-6, "servoStop")
    near(receive.getTargetQ(), START, 0.1, "end of the circle")
    passed("servoJ circle at 500 Hz, %.3f rad behind" % lag)
    pose = receive.getTargetTCPPose()
    for step in range(100):
        begin = control.initPeriod()
        assert control.servoL(moved(pose, z=-0.0002 * step), 0, 0, PERIOD_S, 0.03, 500)
        control.waitPeriod(begin)
    assert control.servoStop()
    assert receive.getTargetTCPPose()[2] < pose[2] - 0.01
    passed("servoL")
    pose = receive.getTargetTCPPose()
    assert control.servoC(moved(pose, y=0.05), 0.25, 1.2, 0.0)
    until(lambda: abs(receive.getTargetTCPPose()[1] - pose[1] - 0.05) < 2e-3, "servoC")
    # the library never takes the command back, and its program answers no other one before that
    control.disconnect()
    assert control.reconnect()
    passed("servoC")
    assert control.moveJ(START, 2.0, 4.0)


def forces(control, receive):
    assert control.zeroFtSensor()
    assert control.forceModeSetDamping(0.05)
    assert control.forceModeSetGainScaling(1.0)
    before = receive.getTargetTCPPose()

    def pushed():
        begin = control.initPeriod()
        assert control.forceMode(
            [0.0] * 6, [0, 0, 1, 0, 0, 0], [0, 0, -5, 0, 0, 0], 2, [0.1, 0.1, 0.05, 0.3, 0.3, 0.3]
        )
        control.waitPeriod(begin)
        return receive.getTargetTCPPose()[2] < before[2] - 0.002

    until(pushed, "force mode has not moved the tool")
    assert control.forceModeStop()
    passed("forceMode")
    assert control.freedriveMode()
    assert control.getFreedriveStatus() == 0
    assert control.endFreedriveMode()
    assert control.teachMode()
    assert control.endTeachMode()
    passed("freedrive, teach mode")
    assert settled(lambda: control.toolContact([0, 0, -1, 0, 0, 0])) == 0
    assert control.startContactDetection()
    assert not control.readContactDetection()
    assert not control.stopContactDetection()
    passed("toolContact")
    before = receive.getTargetTCPPose()
    assert control.jogStart([0, 0.05, 0, 0, 0, 0], RTDEControlInterface.FEATURE_BASE)
    until(lambda: receive.getTargetTCPPose()[1] > before[1] + 0.01, "jogging")
    assert control.jogStop()
    until(lambda: max(map(abs, receive.getTargetQd())) < 1e-6, "jogStop")
    passed("jogging")
    assert control.moveJ(START, 2.0, 4.0)


class Sensor:
    """Sends readings by itself: the library's own function writes them to another recipe."""

    def __init__(self):
        self.rtde = socket.create_connection((HOST, 30004))
        for kind, content in ((b"V", b"\x00\x02"), (b"I", b"external_force_torque")):
            self.rtde.sendall(struct.pack("!H", 3 + len(content)) + kind + content)
            answer = self.rtde.recv(64)
            assert answer in (b"\x00\x04V\x01", b"\x00\x0cI\x01VECTOR6D"), answer

    def send(self, *reading):
        self.rtde.sendall(struct.pack("!HcB6d", 52, b"U", 1, *reading))


def external_sensor(control, receive):
    sensor = Sensor()
    # in place of the strict one that the box sets by itself: this process may be held up
    assert control.setWatchdog(0.1)
    assert control.ftRtdeInputEnable(True, 0.0, [0.0] * 3, [0.0] * 3)
    before = receive.getTargetTCPPose()
    for _ in range(300):
        begin = control.initPeriod()
        # the tool points down: a push up
        sensor.send(0, 0, -10, 0, 0, 0)
        assert control.forceMode(
            [0.0] * 6, [0, 0, 1, 0, 0, 0], [0.0] * 6, 2, [0.1, 0.1, 0.05, 0.3, 0.3, 0.3]
        )
        control.waitPeriod(begin)
    assert control.forceModeStop()
    assert control.ftRtdeInputEnable(False, 0.0, [0.0] * 3, [0.0] * 3)
    sensor.rtde.close()
    assert receive.getTargetTCPPose()[2] > before[2] + 0.002, "the tool has not given way"
    passed("external force sensor")
    assert control.moveJ(START, 2.0, 4.0)


def settings(control, receive):
    assert control.setPayload(1.2, [0.0, 0.01, 0.05])
    until(lambda: abs(receive.getPayload() - 1.2) < 1e-9, "setPayload")
    near(receive.getPayloadCog(), [0.0, 0.01, 0.05], 1e-9, "setPayload")
    assert control.setTargetPayload(0.8, [0.0, 0.0, 0.02], [0.01, 0.01, 0.01, 0, 0, 0])
    until(lambda: abs(receive.getPayload() - 0.8) < 1e-9, "setTargetPayload")
    near(receive.getPayloadInertia(), [0.01, 0.01, 0.01, 0, 0, 0], 1e-9, "setTargetPayload")
    assert control.setPayload(0.0, [0.0, 0.0, 0.0])
    tool = [0.01, 0.02, 0.15, 0.1, 0.2, 0.3]
    assert control.setTcp(tool)
    near(control.getTCPOffset(), tool, 1e-6, "getTCPOffset")
    assert control.setTcp([0.0] * 6)
    assert control.setGravity([0.0, 0.0, 9.82])
    passed("payload, TCP, gravity")


def kinematics(control, receive):
    pose = control.getForwardKinematics()
    near_pose(pose, receive.getTargetTCPPose(), 5e-4, "getForwardKinematics")
    # not of other joints: the library sends them without the TCP that its program reads
    near(control.getInverseKinematics(pose), START, 1e-3, "getInverseKinematics")
    near(control.getInverseKinematics(pose, START), START, 1e-3, "near joints")
    assert control.getInverseKinematicsHasSolution(pose)
    assert not control.getInverseKinematicsHasSolution(moved(pose, x=5))
    near_pose(control.poseTrans(pose, [0.0] * 6), pose, 1e-6, "poseTrans")
    near_pose(control.getActualToolFlangePose(), receive.getActualTCPPose(), 1e-3, "flange")
    assert control.isPoseWithinSafetyLimits(pose)
    assert control.isJointsWithinSafetyLimits(START)
    assert not control.isJointsWithinSafetyLimits(turned(START, 0, 50))
    passed("kinematics")


def dynamics(control, receive):
    # what acts on the arm from outside: nothing but the dry friction that a stop leaves loaded
    near(settled(control.getJointTorques), [0.0] * 6, 8, "getJointTorques")
    history = settled(lambda: control.getActualJointPositionsHistory(10))
    near(history, receive.getActualQ(), 1e-3, "history")
    near(control.getTargetWaypoint(), receive.getTargetTCPPose(), 1e-3, "getTargetWaypoint")
    near(settled(control.getTargetJointAccelerations), [0.0] * 6, 1e-6, "accelerations")
    near(control.getCoriolisAndCentrifugalTorques(START, [0.0] * 6), [0.0] * 6, 1e-6, "at rest")
    mass = settled(lambda: control.getMassMatrix(START))
    assert len(mass) == 36
    for i in range(6):
        assert mass[7 * i] > 0, mass
        for j in range(6):
            assert abs(mass[6 * i + j] - mass[6 * j + i]) < 1e-6, mass
    assert len(control.getJacobian()) == 36
    assert len(control.getJacobian(START, [0.0] * 6)) == 36
    assert len(control.getJacobianTimeDerivative(START, [0.1] * 6, [0.0] * 6)) == 36
    assert abs(settled(control.getStepTime) - PERIOD_S) < 1e-9
    until(control.isSteady, "isSteady")
    assert control.getAsyncOperationProgress() < 0
    assert control.getRobotStatus() & 3 == 3, control.getRobotStatus()
    passed("dynamics and status")


def custom_programs(control, receive):
    text = "  set_standard_digital_out(4, True)\n  textmsg(\"custom\")\n"
    assert control.sendCustomScriptFunction("CUSTOM", text)
    until(lambda: receive.getDigitalOutState(4), "custom program")
    passed("custom program")


def ends_and_comes_back(control, receive):
    control.stopScript()
    until(lambda: not control.isProgramRunning(), "stopScript")
    assert control.reuploadScript()
    until(control.isProgramRunning, "reuploadScript")
    assert control.moveJ(turned(START, 5, 0.2), 2.0, 4.0)
    passed("stopScript, reuploadScript")
    control.disconnect()
    assert not control.isConnected()
    assert control.reconnect()
    assert control.moveJ(START, 2.0, 4.0)
    near(receive.getTargetQ(), START, 1e-3, "moveJ after a reconnect")
    passed("reconnect")


def watchdog(control, receive):
    assert control.setWatchdog(2.0)
    for _ in range(20):
        assert control.kickWatchdog()
        time.sleep(0.1)
    assert control.isProgramRunning()
    until(lambda: receive.getRuntimeState() == 1, "the watchdog has not ended the program")
    passed("watchdog")


def protective_stop(control, receive):
    assert control.reuploadScript()
    until(control.isProgramRunning, "reuploadScript")
    control.triggerProtectiveStop()
    until(receive.isProtectiveStopped, "protective stop")
    passed("protective stop")


def main():
    flags = RTDEControlInterface.FLAG_UPLOAD_SCRIPT | RTDEControlInterface.FLAG_NO_EXT_FT
    control = RTDEControlInterface(HOST, 500, flags)
    assert control.isConnected()
    passed("connected with its own program")
    receive = RTDEReceiveInterface(HOST, 500)
    for check in (
        moves,
        paths,
        speeds,
        servos,
        forces,
        external_sensor,
        settings,
        kinematics,
        dynamics,
        custom_programs,
        ends_and_comes_back,
        watchdog,
        protective_stop,
    ):
        check(control, receive)
    control.disconnect()
    receive.disconnect()


main()
