package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;

final class TouchingTest {

  @Test
  void namesWhatTheToolIsIn() {
    SceneModel model = Models.of("ur5e");
    Pose tcp = model.tcpInBase();
    Scene scene =
        new Scene(
            List.of(
                ball("here", tcp.x(), tcp.y(), tcp.z()),
                ball("there", tcp.x() + 0.3, tcp.y(), tcp.z())),
            Optional.empty(),
            List.of());

    assertEquals(
        Set.of("here"),
        new Touching(scene).names(model.kinematics(), model.positionRad(), Pose.ZERO));
  }

  private static SceneObject ball(String name, double x, double y, double z) {
    return new SceneObject.Sphere(name, new Vector3(x, y, z), 0.05, Material.DEFAULT);
  }
}
