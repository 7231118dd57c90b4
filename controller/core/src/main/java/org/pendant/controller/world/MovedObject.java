package org.pendant.controller.world;

import org.pendant.models.pose.Pose;

/**
 * Moved object: where an object of a scene that has a mass is at one moment.
 *
 * @param name of the object
 * @param poseInBase its centre and orientation in the base frame
 */
public record MovedObject(String name, Pose poseInBase) {}
