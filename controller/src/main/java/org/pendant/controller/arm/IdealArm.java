package org.pendant.controller.arm;

import org.pendant.models.arm.Joints;

/** An arm without mass or delay: it is always exactly where it should be. */
public final class IdealArm implements SimulatedArm {
  private Joints positionRad;
  private Joints speedRadPerS = Joints.ZERO;

  /** An arm at rest. */
  public IdealArm(Joints positionRad) {
    this.positionRad = positionRad;
  }

  @Override
  public void step(Joints targetPositionRad, Joints targetSpeedRadPerS) {
    positionRad = targetPositionRad;
    speedRadPerS = targetSpeedRadPerS;
  }

  @Override
  public void jumpTo(Joints positionRad) {
    this.positionRad = positionRad;
    speedRadPerS = Joints.ZERO;
  }

  @Override
  public Joints positionRad() {
    return positionRad;
  }

  @Override
  public Joints speedRadPerS() {
    return speedRadPerS;
  }
}
