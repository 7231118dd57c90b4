package org.pendant.controller.safety;

import org.pendant.controller.sensor.ArmSensors;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.WrenchNumbers;

/**
 * Frame facts: what the safety functions look at in one frame. Numbers that change are read within
 * the frame only.
 *
 * @param timeS controller time, s
 * @param targetPositionRad where the joints should be, rad
 * @param targetSpeedRadPerS how fast they should turn, rad/s
 * @param sensors what the arm reports
 * @param tcpInFlange the active tool centre point
 * @param externalWrenchAtFlangeInBase what pushes the tool, at the flange's origin along the axes
 *     of the base, N and Nm
 * @param steady whether the target has rested for 500 ms (manual 16.39)
 * @param moving whether a motion is under way, a paused one included
 * @param programRunning whether a program runs and is not paused
 * @param guided whether the arm is guided by hand: its target follows it, and pushes are wanted
 * @param pressing whether force mode presses with the tool: torques from outside are no collision
 */
public record FrameFacts(
    double timeS,
    JointNumbers targetPositionRad,
    JointNumbers targetSpeedRadPerS,
    ArmSensors sensors,
    Pose tcpInFlange,
    WrenchNumbers externalWrenchAtFlangeInBase,
    boolean steady,
    boolean moving,
    boolean programRunning,
    boolean guided,
    boolean pressing) {}
