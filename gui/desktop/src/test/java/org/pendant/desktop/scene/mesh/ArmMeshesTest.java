package org.pendant.desktop.scene.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.shape.ArmShape;
import org.pendant.models.shape.ArmShapes;
import org.pendant.models.shape.JointHousing;
import org.pendant.models.shape.Limb;

@Tag("slow")
final class ArmMeshesTest {
  /** Faces between links are put in the middle of what was measured; seals stand in the gap. */
  private static final float TOLERANCE_M = 0.008f;

  private static List<String> ids() {
    return ArmLibrary.ids();
  }

  private static ArmMeshes meshes(String id) {
    return meshes(id, Detail.FINE);
  }

  private static ArmMeshes meshes(String id, Detail detail) {
    return new ArmMeshes(ArmShapes.load(id), ArmLibrary.load(id).dh(), detail);
  }

  @ParameterizedTest
  @MethodSource("ids")
  void bodiesAreClosed(String id) {
    for (Detail detail : Detail.values()) {
      ArmMeshes meshes = meshes(id, detail);
      for (Link link : Link.values()) {
        assertEquals(
            0, MeshChecks.openEdges(meshes.of(link)), detail + " " + link + " has open edges");
      }
    }
  }

  @ParameterizedTest
  @MethodSource("ids")
  void bodiesFaceOutwards(String id) {
    ArmMeshes meshes = meshes(id);

    for (Link link : Link.values()) {
      assertTrue(MeshChecks.volumeM3(meshes.of(link)) > 1e-5, link + " is inside out");
      double turned = MeshChecks.turnedShare(meshes.of(link));
      assertTrue(turned < 0.002, link + " has " + turned + " of its area turned");
    }
  }

  @ParameterizedTest
  @MethodSource("ids")
  void bodiesStayWithinTheShape(String id) {
    ArmMeshes meshes = meshes(id);
    ArmShape shape = ArmShapes.load(id);
    float foot = (float) Math.max(shape.base().footRadiusM(), shape.base().topRadiusM());

    assertWithin(
        new Mesh.Box(-foot, -foot, 0, foot, foot, (float) shape.base().heightM()),
        meshes.of(Link.BASE),
        id + " base");
    assertWithin(box(shape.shoulder()), meshes.of(Link.SHOULDER), id + " shoulder");
    assertWithin(box(shape.upperArm()), meshes.of(Link.UPPER_ARM), id + " upper arm");
    assertWithin(box(shape.forearm()), meshes.of(Link.FOREARM), id + " forearm");
    assertWithin(box(shape.wrist1()), meshes.of(Link.WRIST_1), id + " wrist 1");
    assertWithin(box(shape.wrist2()), meshes.of(Link.WRIST_2), id + " wrist 2");
    assertWithin(box(shape.wrist3()), meshes.of(Link.WRIST_3), id + " wrist 3");
  }

  @ParameterizedTest
  @MethodSource("ids")
  void anArmHasFewEnoughTrianglesToDrawWithoutGraphics(String id) {
    int triangles = meshes(id).triangleCount();

    assertTrue(triangles < 40_000, id + " has " + triangles);
  }

  @ParameterizedTest
  @MethodSource("ids")
  void aCoarseArmIsTheSameBodyWithAQuarterOfTheTriangles(String id) {
    ArmMeshes fine = meshes(id);
    ArmMeshes coarse = meshes(id, Detail.COARSE);

    assertTrue(4 * coarse.triangleCount() < fine.triangleCount());
    for (Link link : Link.values()) {
      double share = MeshChecks.volumeM3(coarse.of(link)) / MeshChecks.volumeM3(fine.of(link));
      assertEquals(1, share, 0.06, link.toString());
    }
  }

  private static Mesh.Box box(JointHousing jointHousing) {
    float radius = (float) jointHousing.alongZ().radiusM();
    return new Mesh.Box(
        -radius,
        Math.min(-radius, (float) jointHousing.alongY().fromM()),
        (float) Math.min(-radius, jointHousing.alongZ().fromM()),
        radius,
        Math.max(radius, (float) jointHousing.alongY().toM()),
        (float) Math.max(radius, jointHousing.alongZ().toM()));
  }

  private static Mesh.Box box(Limb limb) {
    float near = (float) limb.near().radiusM();
    float far = (float) limb.far().radiusM();
    float tube = (float) Math.max(limb.tube().nearRadiusM(), limb.tube().farRadiusM());
    float wide = Math.max(near, Math.max(far, tube));
    float centre = (float) limb.tube().centreZM();
    return new Mesh.Box(
        (float) -limb.lengthM() - far,
        -wide,
        Math.min(centre - tube, (float) Math.min(limb.near().fromM(), limb.far().fromM())),
        near,
        wide,
        Math.max(centre + tube, (float) Math.max(limb.near().toM(), limb.far().toM())));
  }

  private static void assertWithin(Mesh.Box limits, Mesh mesh, String what) {
    Mesh.Box box = mesh.box();
    String found = what + ": " + box + " must be within " + limits;
    assertTrue(box.lowX() >= limits.lowX() - TOLERANCE_M, found);
    assertTrue(box.lowY() >= limits.lowY() - TOLERANCE_M, found);
    assertTrue(box.lowZ() >= limits.lowZ() - TOLERANCE_M, found);
    assertTrue(box.highX() <= limits.highX() + TOLERANCE_M, found);
    assertTrue(box.highY() <= limits.highY() + TOLERANCE_M, found);
    assertTrue(box.highZ() <= limits.highZ() + TOLERANCE_M, found);
  }
}
