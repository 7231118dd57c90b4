package org.pendant.desktop.scene.mesh;

import java.util.Optional;
import org.joml.Matrix4f;
import org.pendant.models.shape.ArmShape;
import org.pendant.models.shape.Cylinder;
import org.pendant.models.shape.Limb;
import org.pendant.models.shape.Tube;

/** Limbs: upper arm and forearm, a housing at either end, and a tube between them. */
final class Limbs {
  private static final double GAP_M = JointFaces.HALF_GAP_M;
  private static final double FILLET_SHARE = 0.55;
  private static final double LID_SHARE = 0.38;
  private static final double MIN_LID_SHARE = 0.14;

  /** Between a lid and the tube, m. */
  private static final double CLEAR_M = 0.004;

  private static final double ELBOW_ROUNDING_SHARE = 0.55;

  private final ArmShape shape;
  private final JointFaces faces;
  private final Detail detail;

  Limbs(ArmShape shape, JointFaces faces, Detail detail) {
    this.shape = shape;
    this.faces = faces;
    this.detail = detail;
  }

  Mesh upperArm() {
    Limb limb = shape.upperArm();
    double length = limb.lengthM();
    MeshBuilder mesh = new MeshBuilder(detail);
    double nearM = faces.j2() + GAP_M;
    double farM = faces.j3() + GAP_M;
    Housing near =
        housing(AxisDirection.UP_Z.at(0, 0, nearM), limb.near(), limb.near().toM() - nearM);
    Housing far =
        housing(AxisDirection.UP_Z.at(-length, 0, farM), limb.far(), limb.far().toM() - farM);
    Tube tube = limb.tube();
    double nearLidM = lidM(limb.near(), limb.near().toM() - tube.centreZM(), tube);
    double farLidM = lidM(limb.far(), limb.far().toM() - tube.centreZM(), tube);
    near.addWithLid(mesh, nearLidM);
    far.addWithLid(mesh, farLidM);
    addTube(
        mesh,
        limb,
        new LimbRadius(
            tube,
            roomM(limb.near(), limb.near().toM() - tube.centreZM()),
            roomM(limb.far(), limb.far().toM() - tube.centreZM())),
        near.barrel(nearLidM, 0.002),
        far.barrel(farLidM, 0.002));
    Seal.add(
        mesh,
        AxisDirection.UP_Z.at(0, 0, faces.j2()),
        Math.min(limb.near().radiusM(), 0.96 * shape.shoulder().alongZ().radiusM()));
    return mesh.build();
  }

  Mesh forearm() {
    Limb limb = shape.forearm();
    double length = limb.lengthM();
    Tube tube = limb.tube();
    MeshBuilder mesh = new MeshBuilder(detail);
    double nearM = faces.j3() - GAP_M;
    double farM = faces.j4() - GAP_M;
    // The tube may reach lower than the housing was measured; the elbow takes it in.
    double elbowM = Math.min(limb.near().fromM(), tube.centreZM() - tube.nearRadiusM());
    double roundingM = ELBOW_ROUNDING_SHARE * limb.near().radiusM();
    Housing near = housing(AxisDirection.DOWN_Z.at(0, 0, nearM), limb.near(), nearM - elbowM);
    Housing far =
        housing(AxisDirection.DOWN_Z.at(-length, 0, farM), limb.far(), farM - limb.far().fromM());
    near.addWithDome(mesh, roundingM);
    double farLidM = lidM(limb.far(), tube.centreZM() - limb.far().fromM(), tube);
    far.addWithLid(mesh, farLidM);
    addTube(
        mesh,
        limb,
        new LimbRadius(
            tube,
            Double.POSITIVE_INFINITY,
            roomM(limb.far(), tube.centreZM() - limb.far().fromM())),
        near.barrel(0, roundingM),
        far.barrel(farLidM, 0.002));
    Seal.add(
        mesh,
        AxisDirection.UP_Z.at(0, 0, faces.j3()),
        Math.min(limb.near().radiusM(), shape.upperArm().far().radiusM()));
    return mesh.build();
  }

  private static Housing housing(Matrix4f frame, Cylinder body, double lengthM) {
    return new Housing(frame, body.radiusM(), lengthM);
  }

  /** As high as the tube leaves room for. */
  private static double lidM(Cylinder body, double beyondTubeAxisM, Tube tube) {
    double widestM = Math.max(tube.nearRadiusM(), tube.farRadiusM());
    double leftM = beyondTubeAxisM - widestM - CLEAR_M;
    return Math.clamp(leftM, MIN_LID_SHARE * body.radiusM(), LID_SHARE * body.radiusM());
  }

  /** What is left for the tube under the lowest lid. */
  private static double roomM(Cylinder body, double beyondTubeAxisM) {
    return beyondTubeAxisM - MIN_LID_SHARE * body.radiusM() - CLEAR_M;
  }

  private static void addTube(
      MeshBuilder mesh, Limb limb, LimbRadius radius, Barrel near, Barrel far) {
    Pipe pipe =
        new Pipe(AxisDirection.DOWN_X.at(0, 0, limb.tube().centreZM()), limb.lengthM(), radius);
    double filletM = FILLET_SHARE * limb.tube().middleRadiusM();
    new Tubing(pipe, Optional.of(near), far, filletM, mesh.detail()).addTo(mesh);
  }
}
