package org.pendant.motion;

import org.pendant.models.arm.ArmDescription;

/**
 * Path of the TCP along a curve, parametrised so that an even rate gives an even speed of the tool.
 */
interface ToolCurvePath extends MotionPath {
  /** The arm that goes there. */
  ArmDescription arm();

  /** The curve; its parameter is the path's. */
  ToolCurve curve();
}
