package org.pendant.desktop.scene.gl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.command.service.StandardView;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Ball;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.Lens;
import org.pendant.desktop.scene.Models;
import org.pendant.desktop.scene.OtherArm;
import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.SafetySight;
import org.pendant.desktop.scene.SceneBounds;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.SceneTheme;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.pose.Pose;

@Tag("slow")
final class OffscreenSceneTest {
  private static final int SIZE = 160;

  private static OffscreenScene scene;

  @BeforeAll
  static void open() {
    try {
      scene = OffscreenScene.open();
    } catch (SceneUnavailable e) {
      Assumptions.abort("no OpenGL on this machine: " + e.getMessage());
    }
  }

  @AfterAll
  static void close() {
    if (scene != null) {
      scene.close();
    }
  }

  private static int[] draw(SceneModel model) {
    return draw(model, Camera.of(StandardView.ISO, SceneBounds.of(model), 1));
  }

  private static int[] draw(SceneModel model, Camera camera) {
    BufferedImage image = scene.render(model, camera, SIZE, SIZE);
    return image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE);
  }

  private static double changedShare(int[] a, int[] b) {
    int changed = 0;
    for (int i = 0; i < a.length; i++) {
      changed += a[i] == b[i] ? 0 : 1;
    }
    return (double) changed / a.length;
  }

  private static long colours(int[] pixels) {
    return Arrays.stream(pixels).distinct().count();
  }

  private static double brightness(int rgb) {
    return ((rgb >> 16 & 0xFF) + (rgb >> 8 & 0xFF) + (rgb & 0xFF)) / (3 * 255.0);
  }

  @Test
  void aLinkThatHasHitSomethingIsRed() {
    SceneModel model = Models.of("ur5e");
    SafetySight hit =
        new SafetySight(List.of(), List.of(), List.of(), false, List.of("forearm", "wrist 2"));
    double before = redShare(draw(model));
    double share = redShare(draw(model.withSafety(hit)));
    assertTrue(share > before + 0.02, "red: " + before + ", then " + share);
  }

  @Test
  void aLinkOfAnotherArmThatWasHitIsRed() {
    SceneModel model = Models.of("ur5e");
    double before = redShare(draw(model.withOthers(List.of(beside(model)))));
    double share = redShare(draw(model.withOthers(List.of(beside(model, "upper arm")))));
    assertTrue(share > before + 0.01, "red: " + before + ", then " + share);
  }

  private static OtherArm beside(SceneModel model, String... hitLinks) {
    return new OtherArm(
        "right",
        model.arm(),
        model.kinematics(),
        model.positionRad(),
        Pose.ZERO,
        new Pose(0, 0.4, 0, 0, 0, 0),
        List.of(),
        List.of(),
        List.of(hitLinks));
  }

  private static double redShare(int[] pixels) {
    long red =
        Arrays.stream(pixels).filter(rgb -> (rgb >> 16 & 0xFF) > 1.4 * (rgb >> 8 & 0xFF)).count();
    return (double) red / pixels.length;
  }

  @Test
  void everyArmIsSeenAndLooksLikeNoOther() {
    Map<String, int[]> pictures = new HashMap<>();
    for (String id : ArmLibrary.ids()) {
      int[] picture =
          draw(Models.of(id), Camera.of(StandardView.ISO, SceneBounds.of(Models.of("ur20")), 1));
      assertTrue(colours(picture) > 100, id + " has " + colours(picture) + " colours");
      pictures.put(id, picture);
    }
    // These pairs have the same measures.
    Set<Set<String>> twins = Set.of(Set.of("ur5e", "ur7e"), Set.of("ur10e", "ur12e"));
    for (String a : pictures.keySet()) {
      for (String b : pictures.keySet()) {
        if (!a.equals(b) && !twins.contains(Set.of(a, b))) {
          double changed = changedShare(pictures.get(a), pictures.get(b));
          assertTrue(changed > 0.01, a + " and " + b + " differ in " + changed);
        }
      }
    }
  }

  @Test
  void theSamePictureIsDrawnAgain() {
    SceneModel model = Models.of("ur5e");

    assertEquals(0, changedShare(draw(model), draw(model)));
  }

  @Test
  void upIsUp() {
    SceneModel model = Models.of("ur5e");
    Camera camera = Camera.of(StandardView.FRONT, SceneBounds.of(model), 1);
    Camera sky = camera.zoomedTo(new Vector3(0, 0, 30), 3);

    int[] picture = draw(model, sky);

    assertTrue(brightness(picture[0]) > brightness(picture[picture.length - 1]) + 0.01);
  }

  @Test
  void darkIsDarkerThanLight() {
    SceneModel model = Models.of("ur5e");

    double light = Arrays.stream(draw(model)).mapToDouble(OffscreenSceneTest::brightness).sum();
    double dark =
        Arrays.stream(draw(model.withTheme(SceneTheme.DARK)))
            .mapToDouble(OffscreenSceneTest::brightness)
            .sum();

    assertTrue(dark < 0.5 * light);
  }

  @Test
  void theArmThrowsAShadow() {
    SceneModel model = Models.of("ur5e");
    // Straight down, beside the arm: only the floor, and on it the shadow.
    Camera down = new Camera(new Vector3(-0.55, 0.4, 0), -Math.PI / 2, Math.PI / 2, 1.2);
    int[] picture = draw(model, down);

    double darkest =
        Arrays.stream(picture).mapToDouble(OffscreenSceneTest::brightness).min().orElse(1);
    double lightest =
        Arrays.stream(picture).mapToDouble(OffscreenSceneTest::brightness).max().orElse(0);

    assertTrue(darkest < 0.75 * lightest, darkest + " against " + lightest);
  }

  @Test
  void ghostFramesAndThingsShow() {
    SceneModel model = Models.of("ur5e");
    int[] plain = draw(model);
    SceneObject box =
        new SceneObject.Box(
            "box",
            new Pose(-0.3, -0.4, 0.1, 0, 0, 0),
            new Vector3(0.2, 0.2, 0.2),
            Material.DEFAULT);
    Scene world = new Scene(List.of(box), Optional.empty(), List.of());
    Camera camera = Camera.of(StandardView.ISO, SceneBounds.of(model), 1);
    int[] untouched = draw(model.withWorld(world, Set.of()), camera);

    assertTrue(
        changedShare(plain, draw(model.withGhost(Optional.of(Models.WORKING.with(0, 0.6))), camera))
            > 0.02);
    assertTrue(
        changedShare(plain, draw(model.withTool(new Pose(0, 0, 0.2, 0, 0, 0)), camera)) > 0.002);
    assertTrue(
        changedShare(
                plain, draw(model.withFrames(List.of(new Pose(0, -0.4, 0.3, 0, 0, 0))), camera))
            > 0.002);
    assertTrue(changedShare(plain, untouched) > 0.02);
    assertTrue(changedShare(untouched, draw(model.withWorld(world, Set.of("box")), camera)) > 0.02);
  }

  @Test
  void safetyPlanesShowAndARedOneWhereTheArmWasStopped() {
    SceneModel model = Models.of("ur5e");
    Camera camera = Camera.of(StandardView.ISO, SceneBounds.of(model), 1);
    int[] plain = draw(model, camera);
    int[] holds = draw(model.withSafety(wall(SafetySight.State.HOLDS)), camera);
    int[] tripped = draw(model.withSafety(wall(SafetySight.State.TRIPPED)), camera);

    assertTrue(changedShare(plain, holds) > 0.1);
    assertTrue(changedShare(holds, tripped) > 0.1);
    assertTrue(redness(tripped) > 1.02 * redness(holds), redness(tripped) + " " + redness(holds));
  }

  private static SafetySight wall(SafetySight.State state) {
    SafetyPlane wall = new SafetyPlane("wall", 0, 0.5, 0, new Axis(0, -1, 0), Applies.BOTH, false);
    return new SafetySight(
        List.of(new SafetySight.Plane(wall, state)), List.of(), List.of(), false);
  }

  private static double redness(int[] pixels) {
    long red = 0;
    long all = 0;
    for (int rgb : pixels) {
      red += rgb >> 16 & 0xFF;
      all += (rgb >> 16 & 0xFF) + (rgb >> 8 & 0xFF) + (rgb & 0xFF);
    }
    return 3.0 * red / all;
  }

  private static double meanDifference(int[] a, int[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += Math.abs(brightness(a[i]) - brightness(b[i]));
    }
    return sum / a.length;
  }

  @Test
  void quickPicturesLookAlmostLikeTheBest() {
    SceneModel model = Models.of("ur5e");
    Camera camera = Camera.of(StandardView.ISO, SceneBounds.of(model), 1);
    int[] best = draw(model, camera);

    for (Quality quality : Quality.values()) {
      BufferedImage image =
          scene.draw(model, camera, quality, OffscreenScene.image(SIZE, SIZE)).join();
      int[] quick = image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE);
      double difference = meanDifference(best, quick);
      assertTrue(
          difference < (quality == Quality.HALF ? 0.05 : 0.015),
          quality + " differs by " + difference);
    }
  }

  @Test
  void theLensAndThePayloadShow() {
    SceneModel model = Models.of("ur5e");
    Camera camera = Camera.of(StandardView.ISO, SceneBounds.of(model), 1);
    int[] plain = draw(model, camera);
    Pose tcp = model.tcpInBase();
    Ball ball = new Ball(new Vector3(tcp.x(), tcp.y(), tcp.z()), 0.1);

    assertTrue(changedShare(plain, draw(model, camera.through(Lens.ORTHOGRAPHIC))) > 0.1);
    assertTrue(changedShare(plain, draw(model.withPayload(Optional.of(ball)), camera)) > 0.01);
  }

  @Test
  void theFloorHidesNothingFromBelow() {
    SceneModel model = Models.of("ur5e");
    for (Lens lens : Lens.values()) {
      Camera below = new Camera(new Vector3(0, 0, 0.3), 0.5, -0.6, 3).through(lens);

      assertTrue(colours(draw(model, below)) > 100, lens.toString());
    }
  }

  @Test
  void whatIsPickedIsWhatIsSeen() {
    SceneModel model = Models.of("ur5e");
    Camera camera = Camera.of(StandardView.ISO, SceneBounds.of(model), 1);
    draw(model, camera);
    Pose tcp = model.tcpInBase();

    Optional<Picked> picked =
        scene
            .pick(
                camera
                    .zoomedTo(new Vector3(tcp.x(), tcp.y(), tcp.z()), 1)
                    .ray(SIZE / 2.0, SIZE / 2.0, SIZE, SIZE),
                model)
            .join();

    assertTrue(picked.orElseThrow() instanceof Picked.OnTcp);
  }
}
