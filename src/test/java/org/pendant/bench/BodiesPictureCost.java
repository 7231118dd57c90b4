package org.pendant.bench;

import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.pendant.command.service.StandardView;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.OtherArm;
import org.pendant.desktop.scene.SceneBounds;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.desktop.scene.gl.Quality;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * What a picture of a UR5e, or of two of a cell, costs among bodies that all move, with the size
 * that it has in a window of 1440x900: time by the wall, and of processors, which other work on the
 * computer changes less.
 */
final class BodiesPictureCost {
  private static final int WIDTH = 600;
  private static final int HEIGHT = 695;
  private static final int WARM_UP = 15;
  private static final int PICTURES = 40;

  private BodiesPictureCost() {}

  /** Prints a row for each way to draw and number of bodies. */
  public static void main(String[] unused) throws Exception {
    try (OffscreenScene scene = OffscreenScene.open()) {
      for (Quality quality : Quality.values()) {
        for (int arms : new int[] {1, 2}) {
          for (int bodies : new int[] {0, 50}) {
            measure(scene, quality, arms, bodies);
          }
        }
      }
    }
  }

  private static void measure(OffscreenScene scene, Quality quality, int arms, int bodies) {
    BufferedImage image = OffscreenScene.image(WIDTH, HEIGHT);
    Camera camera =
        Camera.of(
            StandardView.ISO, SceneBounds.of(model(0, arms, bodies)), (double) WIDTH / HEIGHT);
    double[] wallMs = new double[PICTURES];
    double processorMs = 0;
    for (int i = -WARM_UP; i < PICTURES; i++) {
      SceneModel model = model(i, arms, bodies);
      long wallNs = System.nanoTime();
      long processorNs = processorNs();
      var _ = scene.draw(model, camera, quality, image).join();
      if (i >= 0) {
        wallMs[i] = (System.nanoTime() - wallNs) / 1e6;
        processorMs += (processorNs() - processorNs) / 1e6 / PICTURES;
      }
    }
    Arrays.sort(wallMs);
    System.out.printf(
        Locale.ROOT,
        "%s, %d arms, %d bodies: median %.1f ms, processors %.1f ms%n",
        quality,
        arms,
        bodies,
        wallMs[PICTURES / 2],
        processorMs);
  }

  private static long processorNs() {
    return ManagementFactory.getPlatformMXBean(com.sun.management.OperatingSystemMXBean.class)
        .getProcessCpuTime();
  }

  private static SceneModel model(int number, int arms, int bodies) {
    double sway = Math.sin(0.03 * number);
    List<SceneObject> objects = new ArrayList<>();
    for (int i = 0; i < bodies; i++) {
      Pose pose =
          new Pose(0.3 + 0.1 * (i % 10), -0.5 + 0.1 * (i / 10), 0.1 + 0.05 * sway, 0, 0, sway);
      objects.add(
          new SceneObject.Box("part #" + i, pose, new Vector3(0.06, 0.04, 0.05), Material.DEFAULT));
    }
    SceneModel one =
        SceneModel.of(
                ArmLibrary.load("ur5e"),
                Joints.of(0.3 + 0.5 * sway, -1.4 + 0.2 * sway, 1.6, -1.7, -1.57, sway))
            .withWorld(new Scene(objects, Optional.empty(), List.of()), Set.of());
    return arms == 1
        ? one
        : one.withOthers(
            List.of(
                new OtherArm(
                    "right",
                    one.arm(),
                    one.kinematics(),
                    Joints.of(-0.5 * sway, -1.2 - 0.2 * sway, 1.6, -1.9, -1.57, -sway),
                    Pose.ZERO,
                    new Pose(1.5, 0, 0, 0, 0, Math.PI),
                    List.of(),
                    List.of(),
                    List.of())));
  }
}
