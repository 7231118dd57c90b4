package org.pendant.desktop.scene.mesh;

import java.util.Optional;
import org.joml.Matrix4f;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.shape.ArmShape;
import org.pendant.models.shape.JointHousing;

/**
 * Joint housings of shoulder and wrists: a housing over the next joint, and the neck that leads to
 * it.
 */
final class JointHousings {
  /** The neck is a little narrower than the housing; equal ones have no edge to fill. */
  private static final double NECK_SHARE = 0.96;

  private static final double FILLET_SHARE = 0.35;
  private static final double GAP_M = JointFaces.HALF_GAP_M;

  private final ArmShape shape;
  private final DhLengths dh;
  private final JointFaces faces;
  private final Detail detail;

  JointHousings(ArmShape shape, DhLengths dh, JointFaces faces, Detail detail) {
    this.shape = shape;
    this.dh = dh;
    this.faces = faces;
    this.detail = detail;
  }

  Mesh shoulder() {
    JointHousing shoulder = shape.shoulder();
    double radiusM = shoulder.alongZ().radiusM();
    double startM = faces.j1() - dh.d1();
    MeshBuilder mesh = new MeshBuilder(detail);
    addBody(
        mesh,
        radiusM,
        AxisDirection.UP_Z.at(0, 0, startM + GAP_M),
        shoulder.alongZ().toM() - startM - GAP_M,
        shoulder.alongZ().toM(),
        AxisDirection.UP_Y.at(0, -faces.j2() + GAP_M, 0),
        faces.j2() - GAP_M);
    Seal.add(
        mesh, AxisDirection.UP_Z.at(0, 0, startM), Math.min(radiusM, shape.base().topRadiusM()));
    return mesh.build();
  }

  Mesh wrist1() {
    JointHousing wrist = shape.wrist1();
    double neckM = faces.j4() - dh.d4() + GAP_M;
    MeshBuilder mesh = new MeshBuilder(detail);
    addBody(
        mesh,
        wrist.alongZ().radiusM(),
        AxisDirection.UP_Y.at(0, -faces.j5() + GAP_M, 0),
        wrist.alongY().toM() + faces.j5() - GAP_M,
        wrist.alongY().toM(),
        AxisDirection.UP_Z.at(0, 0, neckM),
        -neckM);
    Seal.add(
        mesh,
        AxisDirection.UP_Z.at(0, 0, neckM - GAP_M),
        Math.min(neckRadiusM(wrist), shape.forearm().far().radiusM()));
    return mesh.build();
  }

  Mesh wrist2() {
    JointHousing wrist = shape.wrist2();
    double neckM = faces.j5() - dh.d5() + GAP_M;
    MeshBuilder mesh = new MeshBuilder(detail);
    addBody(
        mesh,
        wrist.alongZ().radiusM(),
        AxisDirection.DOWN_Y.at(0, faces.j6() - GAP_M, 0),
        faces.j6() - GAP_M - wrist.alongY().fromM(),
        -wrist.alongY().fromM(),
        AxisDirection.UP_Z.at(0, 0, neckM),
        -neckM);
    Seal.add(
        mesh,
        AxisDirection.UP_Z.at(0, 0, neckM - GAP_M),
        Math.min(neckRadiusM(wrist), shape.wrist1().alongY().radiusM()));
    return mesh.build();
  }

  /** The last link has no housing; it carries the flange and the socket of the tool's cable. */
  Mesh wrist3() {
    double startM = faces.j6() - dh.d6();
    MeshBuilder mesh = new MeshBuilder(detail);
    new FlangeMesh(shape.wrist3()).addTo(mesh, startM + GAP_M);
    Seal.add(
        mesh,
        AxisDirection.UP_Z.at(0, 0, startM),
        Math.min(shape.wrist3().alongZ().radiusM(), shape.wrist2().alongY().radiusM()));
    return mesh.build();
  }

  /**
   * @param body frame of the housing, its face towards the next link
   * @param endM where the housing ends beyond the axis of the neck, m
   * @param neck frame of the neck, its face towards the link before or the next
   */
  private static void addBody(
      MeshBuilder mesh,
      double radiusM,
      Matrix4f body,
      double lengthM,
      double endM,
      Matrix4f neck,
      double neckLengthM) {
    double neckRadiusM = NECK_SHARE * radiusM;
    Housing housing = new Housing(body, radiusM, lengthM);
    double lidM = Math.clamp(endM - neckRadiusM - 0.003, 0.14 * radiusM, 0.4 * radiusM);
    housing.addWithLid(mesh, lidM);
    new Tubing(
            new Pipe(neck, neckLengthM, share -> neckRadiusM),
            Optional.empty(),
            housing.barrel(lidM, 0.002),
            FILLET_SHARE * radiusM,
            mesh.detail())
        .addTo(mesh);
  }

  private static double neckRadiusM(JointHousing jointHousing) {
    return NECK_SHARE * jointHousing.alongZ().radiusM();
  }
}
