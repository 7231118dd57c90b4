package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.mesh.ArmMeshes;
import org.pendant.desktop.scene.mesh.Detail;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.shape.ArmShapes;

final class PickTest {
  /** Stretched up: every axis is known by heart. */
  private static final SceneModel UPRIGHT =
      SceneModel.of(ArmLibrary.load("ur5e"), Joints.of(0, -Math.PI / 2, 0, -Math.PI / 2, 0, 0));

  private static final ArmMeshes MESHES =
      new ArmMeshes(ArmShapes.load("ur5e"), ArmLibrary.load("ur5e").dh(), Detail.FINE);

  /** From the side, along negative x. */
  private static Optional<Picked> fromTheSide(double y, double z) {
    Ray ray = new Ray(new Vector3(3, y, z), new Vector3(-1, 0, 0));
    return Pick.at(ray, UPRIGHT, MESHES);
  }

  private static Link link(Optional<Picked> picked) {
    return assertInstanceOf(Picked.OnLink.class, picked.orElseThrow()).link();
  }

  @Test
  void aRayFindsTheBodyItMeets() {
    assertEquals(Link.BASE, link(fromTheSide(0, 0.03)));
    assertEquals(Link.SHOULDER, link(fromTheSide(0, 0.18)));
    assertEquals(Link.UPPER_ARM, link(fromTheSide(-0.138, 0.37)));
    assertEquals(Link.FOREARM, link(fromTheSide(-0.007, 0.8)));
  }

  @Test
  void theHitIsOnTheSurface() {
    Picked picked = fromTheSide(-0.1378, 0.37).orElseThrow();

    assertEquals(0.0428, picked.pointInBaseM().x(), 5e-4);
    assertEquals(3 - 0.0428, picked.distanceM(), 5e-4);
  }

  @Test
  void aRayThatPassesByFindsNothing() {
    assertTrue(fromTheSide(0.5, 0.5).isEmpty());
  }

  @Test
  void whatIsBehindTheEyeIsNotFound() {
    Ray away = new Ray(new Vector3(3, 0, 0.18), new Vector3(1, 0, 0));

    assertTrue(Pick.at(away, UPRIGHT, MESHES).isEmpty());
  }

  private static SceneModel with(SceneObject... objects) {
    Scene world = new Scene(List.of(objects), Optional.empty(), List.of());
    return UPRIGHT.withWorld(world, Set.of());
  }

  /** The name of what a ray along negative x meets, at a height over the base. */
  private static String object(SceneModel model, double y, double z) {
    Ray ray = new Ray(new Vector3(3, y, z), new Vector3(-1, 0, 0));
    Picked picked = Pick.at(ray, model, MESHES).orElseThrow();
    return assertInstanceOf(Picked.OnObject.class, picked).name();
  }

  @Test
  void objectsAreFoundByName() {
    SceneObject box =
        new SceneObject.Box(
            "box", new Pose(0, 0.5, 0.5, 0, 0, 1), new Vector3(0.2, 0.2, 0.2), Material.DEFAULT);
    SceneObject ball =
        new SceneObject.Sphere("ball", new Vector3(0, 0.5, 1), 0.1, Material.DEFAULT);
    SceneObject wall =
        new SceneObject.Plane(
            "wall", new Vector3(-0.4, 0, 0), new Vector3(1, 0, 0), Material.DEFAULT);
    SceneModel model = with(box, ball, wall);

    assertEquals("box", object(model, 0.5, 0.5));
    assertEquals("ball", object(model, 0.5, 1));
    assertEquals("wall", object(model, 0.5, 0.8));
  }

  @Test
  void theNearerOfArmAndObjectIsFound() {
    SceneObject before =
        new SceneObject.Box(
            "before", new Pose(1, 0, 0.18, 0, 0, 0), new Vector3(0.1, 1, 0.1), Material.DEFAULT);
    SceneObject behind =
        new SceneObject.Box(
            "behind", new Pose(-1, 0, 0.18, 0, 0, 0), new Vector3(0.1, 1, 0.1), Material.DEFAULT);

    assertEquals("before", object(with(before, behind), 0, 0.18));
    Ray ray = new Ray(new Vector3(3, 0, 0.18), new Vector3(-1, 0, 0));
    assertEquals(Link.SHOULDER, link(Pick.at(ray, with(behind), MESHES)));
  }

  @Test
  void aPlaneIsFoundOnlyWhereItIsDrawn() {
    SceneObject wall =
        new SceneObject.Plane(
            "wall", new Vector3(-0.4, 0, 0), new Vector3(1, 0, 0), Material.DEFAULT);
    Ray far = new Ray(new Vector3(3, 5, 0.5), new Vector3(-1, 0, 0));

    assertTrue(Pick.at(far, with(wall), MESHES).isEmpty());
  }

  @Test
  void theToolCentrePointComesFirst() {
    SceneModel withTool = UPRIGHT.withTool(new Pose(0, 0, 0.2, 0, 0, 0));
    Pose tcp = withTool.tcpInBase();
    Ray ray = new Ray(new Vector3(3, tcp.y() + 0.01, tcp.z()), new Vector3(-1, 0, 0));

    Picked picked = Pick.at(ray, withTool, MESHES).orElseThrow();

    assertInstanceOf(Picked.OnTcp.class, picked);
    assertEquals(new Vector3(tcp.x(), tcp.y(), tcp.z()), picked.pointInBaseM());
  }
}
