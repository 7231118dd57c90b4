package org.pendant.controller.box;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.TorquePathLimits;

/**
 * Arm model: what the controller believes about its arm: masses, the payload that programs declare,
 * and how the base is mounted and moves (manual 16.44, 16.48, 16.52).
 */
public final class ArmModel {
  private final ArmDynamics dynamics;
  private final TorquePathLimits pathLimits;
  private final double[] gravity = {0, 0, ArmDynamics.STANDARD_GRAVITY_M_PER_S2};
  private final double[] baseAcceleration = new double[3];
  private Payload from = Payload.NONE;
  private Payload payload = Payload.NONE;
  private Payload target = Payload.NONE;
  private long transitionFrames;
  private long framesDone;
  private boolean transitionEnded;
  private Mounting mounting = Mounting.FLOOR;

  ArmModel(ArmDescription arm) {
    dynamics = new ArmDynamics(arm);
    pathLimits = new TorquePathLimits(arm);
    dynamics.setGravity(gravity[0], gravity[1], gravity[2]);
    pathLimits.setGravity(gravity[0], gravity[1], gravity[2]);
  }

  /** Dynamics with the payload, gravity and base acceleration that hold now. */
  public ArmDynamics dynamics() {
    return dynamics;
  }

  /** What moves can be planned with for that payload, gravity and base acceleration. */
  TorquePathLimits pathLimits() {
    return pathLimits;
  }

  /** The payload that holds now; between two of them while a transition continues. */
  public Payload payload() {
    return payload;
  }

  /** The payload that was declared last, and holds once the transition is over. */
  public Payload targetPayload() {
    return target;
  }

  /** The acceleration that the resting arm feels, along axis 0 to 2 of the base, m/s². */
  public double gravityMPerS2(int axis) {
    return gravity[axis];
  }

  /** The acceleration of the base along its axis 0 to 2, m/s². */
  public double baseAccelerationMPerS2(int axis) {
    return baseAcceleration[axis];
  }

  /** What the resting arm feels along an axis of the base, its motion included, m/s². */
  public double feltAccelerationMPerS2(int axis) {
    return gravity[axis] + baseAcceleration[axis];
  }

  /** Gravity and acceleration of the base; the same object until one changes. */
  public Mounting mounting() {
    return mounting;
  }

  private void mount() {
    pathLimits.setGravity(
        feltAccelerationMPerS2(0), feltAccelerationMPerS2(1), feltAccelerationMPerS2(2));
    mounting =
        new Mounting(
            gravity[0],
            gravity[1],
            gravity[2],
            baseAcceleration[0],
            baseAcceleration[1],
            baseAcceleration[2]);
  }

  void setGravity(double x, double y, double z) {
    gravity[0] = x;
    gravity[1] = y;
    gravity[2] = z;
    dynamics.setGravity(x, y, z);
    mount();
  }

  void setBaseAcceleration(double x, double y, double z) {
    baseAcceleration[0] = x;
    baseAcceleration[1] = y;
    baseAcceleration[2] = z;
    dynamics.setBaseAcceleration(x, y, z);
    mount();
  }

  /** Declares a payload that comes to hold evenly within a time. */
  void declare(Payload payload, double transitionS) {
    from = this.payload;
    target = payload;
    transitionFrames = transitionS > 0 ? FrameTime.framesFor(transitionS) : 0;
    framesDone = 0;
    if (transitionFrames == 0) {
      use(target);
    }
  }

  /** Whether the payload is on its way to another one. */
  boolean changing() {
    return framesDone < transitionFrames;
  }

  /** Takes the transition one frame further. */
  void stepTransition() {
    framesDone++;
    transitionEnded = !changing();
    use(changing() ? from.between(target, (double) framesDone / transitionFrames) : target);
  }

  /** Whether a transition ended since the last call. */
  boolean transitionEnded() {
    boolean ended = transitionEnded;
    transitionEnded = false;
    return ended;
  }

  private void use(Payload now) {
    payload = now;
    dynamics.setPayload(now);
    pathLimits.setPayload(now);
  }
}
