package org.pendant.desktop.scene.mesh;

import java.util.EnumMap;
import java.util.Map;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.shape.ArmShape;

/**
 * Arm meshes: the bodies of an arm as triangles, made from its measures: housings with covers over
 * the joints, tubes that grow out of them with fillets, a dark gap where one link turns on the
 * other. About 32,000 triangles; making them takes some tenths of a second.
 */
public final class ArmMeshes {
  private final Map<Link, Mesh> meshes = new EnumMap<>(Link.class);

  /**
   * @param shape what the arm looks like
   * @param dh its lengths: they say where the bodies meet
   * @param detail how finely they are cut
   */
  public ArmMeshes(ArmShape shape, DhLengths dh, Detail detail) {
    JointFaces faces = JointFaces.of(shape, dh);
    JointHousings jointHousings = new JointHousings(shape, dh, faces, detail);
    Limbs limbs = new Limbs(shape, faces, detail);
    meshes.put(Link.BASE, Foot.of(shape.base(), faces.j1() - JointFaces.HALF_GAP_M, detail));
    meshes.put(Link.SHOULDER, jointHousings.shoulder());
    meshes.put(Link.UPPER_ARM, limbs.upperArm());
    meshes.put(Link.FOREARM, limbs.forearm());
    meshes.put(Link.WRIST_1, jointHousings.wrist1());
    meshes.put(Link.WRIST_2, jointHousings.wrist2());
    meshes.put(Link.WRIST_3, jointHousings.wrist3());
  }

  /** One body, in the frame at its near end ({@link ArmShape}). */
  public Mesh of(Link link) {
    return meshes.get(link);
  }

  /** Triangles of all bodies. */
  public int triangleCount() {
    return meshes.values().stream().mapToInt(Mesh::triangleCount).sum();
  }
}
