package org.pendant.controller.device.camera;

import org.pendant.models.pose.Pose;

/**
 * Seen part: a part in a picture of a camera.
 *
 * @param name of the object of the scene, or of the copy of it
 * @param pose where the camera says that it is
 */
public record SeenPart(String name, Pose pose) {}
