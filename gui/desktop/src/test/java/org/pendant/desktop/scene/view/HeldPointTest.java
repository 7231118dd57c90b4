package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.Lens;
import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.Ray;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

final class HeldPointTest {
  private static final ArmDescription ARM = ArmLibrary.load("ur5e");
  private static final Joints START = BoxSetup.START_RAD;
  private static final SceneModel MODEL = SceneModel.of(ARM, START);
  private static final Camera CAMERA = new Camera(new Vector3(0, 0, 0.4), 0.7, 0.3, 2.5);
  private static final Vector3 POINT = new Vector3(-0.3, -0.1, 0.6);

  private static HeldPoint held(Link link, Camera camera) {
    return HeldPoint.of(new Picked.OnLink(link, POINT, 2), MODEL, camera).orElseThrow();
  }

  private static void assertNear(Vector3 expected, Vector3 actual) {
    assertEquals(expected.x(), actual.x(), 1e-9);
    assertEquals(expected.y(), actual.y(), 1e-9);
    assertEquals(expected.z(), actual.z(), 1e-9);
  }

  @Test
  void isWhereItWasGrabbedAsLongAsTheArmStays() {
    for (Link link : Link.values()) {
      if (link != Link.BASE) {
        assertNear(POINT, held(link, CAMERA).inBaseM(MODEL));
      }
    }
  }

  @Test
  void goesWithItsLink() {
    SceneModel turned = SceneModel.of(ARM, START.with(0, Math.PI / 2));
    assertNear(
        new Vector3(-POINT.y(), POINT.x(), POINT.z()), held(Link.FOREARM, CAMERA).inBaseM(turned));
    SceneModel behind = SceneModel.of(ARM, START.with(4, 0));
    assertNear(POINT, held(Link.FOREARM, CAMERA).inBaseM(behind));
  }

  @Test
  void linksAreCountedByTheJointThatMovesThem() {
    assertEquals(0, held(Link.SHOULDER, CAMERA).link());
    assertEquals(5, held(Link.WRIST_3, CAMERA).link());
    assertEquals(5, HeldPoint.of(new Picked.OnTcp(POINT, 2), MODEL, CAMERA).orElseThrow().link());
  }

  @Test
  void whatDoesNotMoveCannotBeHeld() {
    assertEquals(
        Optional.empty(), HeldPoint.of(new Picked.OnLink(Link.BASE, POINT, 2), MODEL, CAMERA));
    assertEquals(
        Optional.empty(), HeldPoint.of(new Picked.OnObject("table", POINT, 2), MODEL, CAMERA));
  }

  @ParameterizedTest
  @EnumSource
  void thePlaceIsUnderThePointerAtTheDepthWhereItWasGrabbed(Lens lens) {
    Camera camera = CAMERA.through(lens);
    HeldPoint held = held(Link.WRIST_1, camera);
    Vector3 place = held.placeM(camera.ray(700, 150, 900, 600)).orElseThrow();
    var pixel = camera.pixel(place, 900, 600).orElseThrow();
    assertEquals(700, pixel.getX(), 1e-6);
    assertEquals(150, pixel.getY(), 1e-6);
    Vector3 middle = camera.ray(450, 300, 900, 600).direction();
    double depth =
        (place.x() - POINT.x()) * middle.x()
            + (place.y() - POINT.y()) * middle.y()
            + (place.z() - POINT.z()) * middle.z();
    assertEquals(0, depth, 1e-9);
  }

  @Test
  void aRayAlongThePlaneOrAwayFromItLeadsNowhere() {
    HeldPoint held = held(Link.WRIST_1, CAMERA);
    Vector3 d = held.towardsScene();
    Ray away = new Ray(CAMERA.eyeM(), new Vector3(-d.x(), -d.y(), -d.z()));
    assertEquals(Optional.empty(), held.placeM(away));
    Ray along = new Ray(CAMERA.eyeM(), new Vector3(-d.y(), d.x(), 0));
    assertTrue(held.placeM(along).isEmpty());
  }
}
