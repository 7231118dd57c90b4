package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;

/**
 * Joint setpoint: position, speed and acceleration of the joints in a frame, on the path or
 * displaced from it by offsets.
 */
final class JointSetpoint {
  private final PathState path;
  private final OffsetTarget offsets;

  /** At rest at {@code positionRad}, carried by nothing. */
  JointSetpoint(ArmDescription arm, Joints positionRad, JointSpeedCheck jointSpeeds) {
    path = new PathState(positionRad);
    offsets = new OffsetTarget(arm, jointSpeeds);
  }

  /** Where the path is; the target too unless offsets are engaged. */
  PathState path() {
    return path;
  }

  /** What carries the TCP aside. */
  OffsetTarget offsets() {
    return offsets;
  }

  /** Where the joints are to be, rad. */
  JointNumbers position() {
    return offsets.engaged() ? offsets.position() : path.position();
  }

  /** How fast they are to turn, rad/s. */
  JointNumbers speed() {
    return offsets.engaged() ? offsets.speed() : path.speed();
  }

  /** How their speeds are to change, rad/s². */
  JointNumbers acceleration() {
    return offsets.engaged() ? offsets.acceleration() : path.acceleration();
  }

  /** The path is put where the target is. */
  void takeForPath() {
    path.set(position().joints(), speed().joints(), acceleration().joints());
  }

  /**
   * An offset has ended, and the path is put so that the others carry the TCP to where it is; all
   * of them end where that is out of reach.
   */
  void rebase() {
    Joints acceleration = acceleration().joints();
    Optional<OffsetTarget.Rebased> rebased = offsets.rebased(path.position());
    if (rebased.isPresent()) {
      path.set(rebased.get().positionRad(), rebased.get().speedRadPerS(), acceleration);
    } else {
      takeForPath();
      offsets.end();
    }
  }
}
