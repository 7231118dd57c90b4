package org.pendant.desktop.scene;

import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

/** Arms in a posture that shows all of them. */
public final class Models {
  /** The tool points down, in front of the base. */
  public static final Joints WORKING = Joints.of(0, -1.2, 1.3, -1.67, -1.5708, 0.3);

  private Models() {}

  /** One arm at work. */
  public static SceneModel of(String id) {
    return SceneModel.of(ArmLibrary.load(id), WORKING);
  }
}
