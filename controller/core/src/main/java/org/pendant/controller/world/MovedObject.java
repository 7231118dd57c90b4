package org.pendant.controller.world;

import org.pendant.models.pose.Pose;

/**
 * Moved object: where an object of a scene that has a mass is at one moment.
 *
 * @param name of the object
 * @param poseInBase its centre, or the origin of its file, and orientation in the base frame
 * @param there false where it has been taken away
 */
public record MovedObject(String name, Pose poseInBase, boolean there) {
  /** Between the name of an object and the number of a copy that a source has made of it. */
  static final String COPY = " #";

  /** One that is there. */
  public MovedObject(String name, Pose poseInBase) {
    this(name, poseInBase, true);
  }

  /** The name of the object that this is, or is a copy of. */
  public String original() {
    int mark = name.lastIndexOf(COPY);
    return mark < 0 ? name : name.substring(0, mark);
  }
}
