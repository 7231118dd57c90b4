package org.pendant.controller.motion;

import org.pendant.models.arm.ArmDescription;

/** A path on which the TCP goes along a curve at an even speed when the rate is even. */
interface ToolWay extends MotionPath {
  /** The arm that goes there. */
  ArmDescription arm();

  /** The curve; its parameter is the path's. */
  ToolCurve curve();
}
