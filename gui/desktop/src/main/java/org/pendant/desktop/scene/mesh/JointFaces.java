package org.pendant.desktop.scene.mesh;

import org.pendant.models.arm.DhLengths;
import org.pendant.models.shape.ArmShape;

/**
 * Joint faces: where each link turns on the one before, m. The bodies were measured apart and
 * overlap or gape by some millimetres; the face is put in the middle of that.
 *
 * @param j1 height over the base frame
 * @param j2 on z of frame 1
 * @param j3 on z of frame 2
 * @param j4 on z of frame 3
 * @param j5 on z of frame 4
 * @param j6 on z of frame 5
 */
record JointFaces(double j1, double j2, double j3, double j4, double j5, double j6) {
  /** Half the gap that stays open between two links. */
  static final double HALF_GAP_M = 0.0011;

  static JointFaces of(ArmShape shape, DhLengths dh) {
    return new JointFaces(
        middle(shape.base().heightM(), dh.d1() + shape.shoulder().alongZ().fromM()),
        middle(-shape.shoulder().alongY().fromM(), shape.upperArm().near().fromM()),
        middle(shape.upperArm().far().fromM(), shape.forearm().near().toM()),
        middle(shape.forearm().far().toM(), dh.d4() + shape.wrist1().alongZ().fromM()),
        middle(-shape.wrist1().alongY().fromM(), dh.d5() + shape.wrist2().alongZ().fromM()),
        middle(shape.wrist2().alongY().toM(), dh.d6() + shape.wrist3().alongZ().fromM()));
  }

  private static double middle(double a, double b) {
    return (a + b) / 2;
  }
}
