package org.pendant.controller.value;

import org.pendant.models.pose.Pose;

/** A pose: position in metres, orientation as a rotation vector in radians. */
public record PoseValue(Pose pose) implements Value {
  @Override
  public Kind kind() {
    return Kind.POSE;
  }
}
