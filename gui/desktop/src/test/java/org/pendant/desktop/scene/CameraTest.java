package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Point2D;
import java.util.List;
import java.util.Random;
import org.joml.Vector4f;
import org.junit.jupiter.api.Test;
import org.pendant.command.service.StandardView;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmLibrary;

final class CameraTest {
  private static final double WIDTH = 1200;
  private static final double HEIGHT = 800;

  private static Camera random(Random random) {
    return new Camera(
        new Vector3(random.nextDouble(), random.nextDouble(), random.nextDouble()),
        random.nextDouble(-3, 3),
        random.nextDouble(-1.5, 1.5),
        random.nextDouble(0.5, 5),
        random.nextBoolean() ? Lens.PERSPECTIVE : Lens.ORTHOGRAPHIC);
  }

  /** Where a point is seen, pixels. */
  private static double[] pixel(Camera camera, Vector3 point) {
    Vector4f clip =
        camera
            .projection(WIDTH / HEIGHT)
            .transform(new Vector4f((float) point.x(), (float) point.y(), (float) point.z(), 1));
    return new double[] {
      (clip.x / clip.w + 1) * WIDTH / 2, (1 - clip.y / clip.w) * HEIGHT / 2, clip.w
    };
  }

  private static void assertSamePixel(double x, double y, double[] pixel, String message) {
    assertEquals(x, pixel[0], 0.05, message);
    assertEquals(y, pixel[1], 0.05, message);
  }

  @Test
  void whatIsFittedIsClearOfWhatCoversThePicture() {
    SceneBounds bounds =
        new SceneBounds(
            List.of(
                new Ball(new Vector3(0, 0, 0), 0.1),
                new Ball(new Vector3(0.5, 0.2, 0.8), 0.1),
                new Ball(new Vector3(-0.2, -0.3, 0.4), 0.05)));
    Random random = new Random(11);
    for (int i = 0; i < 100; i++) {
      Camera outside = random(random).zoomedTo(new Vector3(0.1, 0, 0.4), 5);
      Camera camera = outside.fitted(bounds, WIDTH / HEIGHT, 0.1, 0.3);
      double least = HEIGHT;
      double most = 0;
      for (Ball each : bounds.balls()) {
        double y = pixel(camera, each.centreM())[1];
        least = Math.min(least, y);
        most = Math.max(most, y);
      }
      assertTrue(least > 0.1 * HEIGHT && most < 0.7 * HEIGHT, camera + ": " + least + " " + most);
    }
  }

  @Test
  void whatTheArmReachesIsSeenWholeWhereItIsShown() {
    SceneModel model =
        Models.of("ur5e").withSafety(new SafetySight(List.of(), List.of(), List.of(), true));
    Ball reach = Ball.reach(model);
    Camera camera = Camera.of(StandardView.FRONT, SceneBounds.of(model), WIDTH / HEIGHT);
    for (int side : List.of(-1, 1)) {
      Vector3 end =
          new Vector3(
              reach.centreM().x(),
              reach.centreM().y(),
              reach.centreM().z() + side * reach.radiusM());
      double y = pixel(camera, end)[1];
      assertTrue(y > 0 && y < HEIGHT, "the reach ends at " + y);
    }
  }

  @Test
  void theTargetIsInTheMiddleOfThePicture() {
    Random random = new Random(1);
    for (int i = 0; i < 200; i++) {
      Camera camera = random(random);
      assertSamePixel(WIDTH / 2, HEIGHT / 2, pixel(camera, camera.targetM()), camera.toString());
    }
  }

  @Test
  void aRayGoesThroughWhatIsSeenAtItsPixel() {
    Random random = new Random(2);
    for (int i = 0; i < 200; i++) {
      Camera camera = random(random);
      double x = random.nextDouble(WIDTH);
      double y = random.nextDouble(HEIGHT);
      Vector3 seen = camera.ray(x, y, WIDTH, HEIGHT).pointM(random.nextDouble(0.4, 4));
      assertSamePixel(x, y, pixel(camera, seen), camera.toString());
    }
  }

  @Test
  void aPixelIsWhereThePointIsDrawn() {
    Random random = new Random(8);
    for (int i = 0; i < 200; i++) {
      Camera camera = random(random);
      Vector3 point = camera.ray(300, 500, WIDTH, HEIGHT).pointM(random.nextDouble(0.4, 4));
      Point2D at = camera.pixel(point, WIDTH, HEIGHT).orElseThrow();
      assertEquals(300, at.getX(), 1e-6, camera.toString());
      assertEquals(500, at.getY(), 1e-6, camera.toString());
    }
  }

  @Test
  void whatIsBehindTheEyeHasNoPixel() {
    Camera camera = new Camera(new Vector3(0, 0, 0), 0, 0, 2);

    assertTrue(camera.pixel(new Vector3(3, 0, 0), WIDTH, HEIGHT).isEmpty());
  }

  @Test
  void withoutPerspectiveTheFarIsAsLargeAsTheNear() {
    Camera camera = new Camera(new Vector3(0, 0, 0), 0, 0, 2, Lens.ORTHOGRAPHIC);

    double[] near = pixel(camera, new Vector3(1, 0.3, 0));
    double[] far = pixel(camera, new Vector3(-9, 0.3, 0));

    assertSamePixel(near[0], near[1], far, "far");
  }

  @Test
  void theLensChangesNothingAtTheTarget() {
    Camera camera = new Camera(new Vector3(0.1, 0.2, 0.3), 0, 0, 2);
    Vector3 beside = new Vector3(0.1, 0.5, 0.4);

    double[] seen = pixel(camera, beside);

    assertSamePixel(
        seen[0], seen[1], pixel(camera.through(Lens.ORTHOGRAPHIC), beside), "through both");
  }

  @Test
  void theFloorIsSeenFromAboveOrBelow() {
    Camera above = new Camera(new Vector3(0, 0, 0), 0, 0.1, 2);
    Camera under = new Camera(new Vector3(0, 0, 1), 0, -0.1, 2);

    assertTrue(above.looksDownOn(0));
    assertFalse(above.looksDownOn(1));
    assertTrue(under.looksDownOn(0));
    assertFalse(under.through(Lens.ORTHOGRAPHIC).looksDownOn(0));
  }

  @Test
  void orbitingKeepsTargetAndDistance() {
    Camera camera = random(new Random(3));

    Camera turned = camera.orbited(0.7, -0.2);

    assertEquals(camera.targetM(), turned.targetM());
    assertEquals(camera.distanceM(), turned.distanceM());
    assertEquals(distance(turned.eyeM(), turned.targetM()), turned.distanceM(), 1e-12);
  }

  @Test
  void aFullTurnComesBack() {
    Camera camera = new Camera(new Vector3(0, 0, 0), 1, 0.3, 2);

    assertEquals(1, camera.orbited(2 * Math.PI, 0).azimuthRad(), 1e-12);
  }

  @Test
  void nobodyTurnsOverThePole() {
    Camera camera = new Camera(new Vector3(0, 0, 0), 0, 1.5, 2).orbited(0, 1);

    assertEquals(Math.PI / 2, camera.elevationRad());
  }

  @Test
  void panningLetsTheTargetFollowThePointer() {
    Random random = new Random(4);
    for (int i = 0; i < 100; i++) {
      Camera camera = random(random);
      Camera panned = camera.panned(120, -45, HEIGHT);
      assertSamePixel(
          WIDTH / 2 + 120, HEIGHT / 2 - 45, pixel(panned, camera.targetM()), camera.toString());
    }
  }

  @Test
  void dollyingAtAPixelKeepsWhatIsSeenThere() {
    Random random = new Random(5);
    for (int i = 0; i < 100; i++) {
      Camera camera = random(random);
      double x = random.nextDouble(WIDTH);
      double y = random.nextDouble(HEIGHT);
      Ray ray = camera.ray(x, y, WIDTH, HEIGHT);
      Vector3 toTarget = difference(camera.targetM(), camera.eyeM());
      double inPlaneM = camera.distanceM() * camera.distanceM() / dot(ray.direction(), toTarget);
      Vector3 seen = ray.pointM(inPlaneM);

      Camera nearer = camera.dolliedAt(0.6, x, y, WIDTH, HEIGHT);

      assertEquals(0.6 * camera.distanceM(), nearer.distanceM(), 1e-12);
      assertSamePixel(x, y, pixel(nearer, seen), camera.toString());
    }
  }

  @Test
  void theDistanceStaysInItsRange() {
    Camera camera = new Camera(new Vector3(0, 0, 0), 0, 0, 1);

    assertEquals(Camera.NEAREST_M, camera.dollied(1e-9).distanceM());
    assertEquals(Camera.MAX_M, camera.dollied(1e9).distanceM());
  }

  @Test
  void fromTheFrontXGoesToTheRightAndZUp() {
    Camera camera = new Camera(new Vector3(0, 0, 0), 0, 0, 3).from(StandardView.FRONT);

    assertTrue(pixel(camera, new Vector3(0.1, 0, 0))[0] > WIDTH / 2 + 10);
    assertTrue(pixel(camera, new Vector3(0, 0, 0.1))[1] < HEIGHT / 2 - 10);
    assertTrue(camera.eyeM().y() < 0);
  }

  @Test
  void fromAboveXGoesToTheRightAndYUp() {
    Camera camera = new Camera(new Vector3(0, 0, 0), 0, 0, 3).from(StandardView.TOP);

    assertTrue(pixel(camera, new Vector3(0.1, 0, 0))[0] > WIDTH / 2 + 10);
    assertTrue(pixel(camera, new Vector3(0, 0.1, 0))[1] < HEIGHT / 2 - 10);
    assertEquals(3, camera.eyeM().z(), 1e-9);
  }

  @Test
  void everyStandardViewShowsAllOfEveryArm() {
    for (String id : ArmLibrary.ids()) {
      SceneBounds outline = SceneBounds.of(Models.of(id));
      for (StandardView view : StandardView.values()) {
        Camera camera = Camera.of(view, outline, WIDTH / HEIGHT);
        double least = Double.POSITIVE_INFINITY;
        for (Ball ball : outline.balls()) {
          double[] pixel = pixel(camera, ball.centreM());
          double radiusPx = ball.radiusM() / pixel[2] * HEIGHT / 2 / Math.tan(Math.toRadians(16));
          least = Math.min(least, Math.min(pixel[0], WIDTH - pixel[0]) - radiusPx);
          least = Math.min(least, Math.min(pixel[1], HEIGHT - pixel[1]) - radiusPx);
        }
        assertTrue(least >= 0, id + " " + view + " is cut by " + -least + " px");
        assertTrue(least < 0.15 * HEIGHT, id + " " + view + " is small, margin " + least);
      }
    }
  }

  @Test
  void zoomingLooksAtThePoint() {
    Camera camera = new Camera(new Vector3(0, 0, 0), 1, 0.2, 3);

    Camera near = camera.zoomedTo(new Vector3(0.3, 0.2, 0.1), 0.5);

    assertEquals(new Camera(new Vector3(0.3, 0.2, 0.1), 1, 0.2, 0.5), near);
  }

  private static Vector3 difference(Vector3 a, Vector3 b) {
    return new Vector3(a.x() - b.x(), a.y() - b.y(), a.z() - b.z());
  }

  private static double dot(Vector3 a, Vector3 b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
  }

  private static double distance(Vector3 a, Vector3 b) {
    return difference(a, b).length();
  }
}
