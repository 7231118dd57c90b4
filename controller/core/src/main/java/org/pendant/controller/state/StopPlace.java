package org.pendant.controller.state;

import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Stop location: where program and arm were when a safety function stopped them; the arm as that
 * function saw it in this frame: where it should have been if the stop is about its target, and
 * where it was otherwise.
 *
 * @param line 1-based line that the main thread had reached, 0 when no program ran
 * @param tcpInBase pose of the TCP in the base frame
 * @param positionRad joint positions, rad
 */
public record StopPlace(int line, Pose tcpInBase, Joints positionRad) {}
