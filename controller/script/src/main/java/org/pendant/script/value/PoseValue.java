package org.pendant.script.value;

import org.pendant.models.pose.Pose;

/** A pose: position in metres, orientation as a rotation vector in radians. */
public record PoseValue(Pose pose) implements Value {
  private static final long BYTES = 96;

  @Override
  public ValueKind kind() {
    return ValueKind.POSE;
  }

  @Override
  public long sizeBytes() {
    return BYTES;
  }
}
