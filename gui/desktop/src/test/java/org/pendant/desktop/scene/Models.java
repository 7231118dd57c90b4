package org.pendant.desktop.scene;

import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Arms in a posture that shows all of them. */
public final class Models {
  /** The tool points down, in front of the base. */
  public static final Joints WORKING = Joints.of(0, -1.2, 1.3, -1.67, -1.5708, 0.3);

  private Models() {}

  /** One arm at work. */
  public static SceneModel of(String id) {
    return SceneModel.of(ArmLibrary.load(id), WORKING);
  }

  /** The tool went up from a place by 0.2 m in two seconds, at a line of the program. */
  public static TcpTrace trace(Pose from, int line) {
    TraceRing ring = new TraceRing(10);
    for (int i = 0; i < 3; i++) {
      ring.add(new Pose(from.x(), from.y(), from.z() + 0.1 * i, 0, 0, 0), Pose.ZERO, i, line);
    }
    return ring.trace();
  }
}
