package org.pendant.controller.box;

import org.pendant.motion.TorquePathLimits;
import org.pendant.motion.toolpath.Toolpaths;

/**
 * Planning of moves.
 *
 * @param settings motion version and jerk
 * @param limits what the arm is capable of with the current payload and mounting
 * @param toolpaths motions that a program queues, and toolpaths
 */
public record MotionPlanning(
    MotionSettings settings, TorquePathLimits limits, Toolpaths toolpaths) {}
