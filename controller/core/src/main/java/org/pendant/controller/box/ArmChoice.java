package org.pendant.controller.box;

import org.pendant.controller.arm.DynamicArm;
import org.pendant.controller.arm.IdealArm;

/** Arm choice: which arm is connected to the box. */
public enum ArmChoice {
  /** One with mass, friction and drives: {@link DynamicArm}. */
  DYNAMIC,
  /** One that is always exactly where it should be: {@link IdealArm}. */
  IDEAL
}
