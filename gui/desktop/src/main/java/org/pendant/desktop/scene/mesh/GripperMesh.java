package org.pendant.desktop.scene.mesh;

import java.util.List;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.world.GripperSetup;

/**
 * Gripper mesh: a plain gripper: a body on the flange, and what grips in the frame of the hand,
 * whose z axis leads on to what it grips: two fingers that close along y, or a cup.
 */
public final class GripperMesh {
  private static final double BEVEL_M = 0.001;
  private static final double BODY_RADIUS_M = 0.03;
  private static final double RAIL_M = 0.016;
  private static final double PART_M = 0.02;

  /** Of the way from the flange to the middle of the hand, so much is body. */
  private static final double BODY_SHARE = 0.55;

  /** The neck of a cup is so wide, and its lip so thick, as shares of its radius. */
  private static final double NECK_SHARE = 0.35;

  private static final double LIP_SHARE = 0.85;
  private static final int AROUND = 32;

  private final double reachM;
  private final Finish pad;
  private final Detail detail;

  private GripperMesh(double reachM, boolean holds, Detail detail) {
    this.reachM = reachM;
    this.detail = detail;
    pad = holds ? Finish.TOUCHED : Finish.SEAL;
  }

  /**
   * Meshes: the body, in the frame of the flange; in that of the hand what is between it and the
   * fingers, the finger at positive y as if it touched the other one, that one, and a part that is
   * 1 m wide.
   *
   * @param reachM how far the hand is from the flange along the flange's z axis
   * @param strokeM how far fingers open
   * @param holds whether it looks as if it held something
   */
  public static List<Mesh> of(
      GripperSetup.Grip grip, double reachM, double strokeM, boolean holds, Detail detail) {
    GripperMesh made = new GripperMesh(Math.max(0, reachM), holds, detail);
    return switch (grip) {
      case GripperSetup.Grip.Pads pads ->
          List.of(
              made.body(),
              made.rail(pads, strokeM),
              made.finger(pads, 1),
              made.finger(pads, -1),
              made.part());
      case GripperSetup.Grip.Cup cup -> {
        Mesh none = new MeshBuilder(detail).build();
        yield List.of(made.body(), made.cup(cup), none, none, none);
      }
    };
  }

  private double bodyM() {
    return BODY_SHARE * reachM;
  }

  private Mesh body() {
    MeshBuilder mesh = new MeshBuilder(detail).finish(Finish.SEAL);
    if (bodyM() > 4 * BEVEL_M) {
      Lathe.cylinder(mesh, BODY_RADIUS_M, 0, bodyM(), 2 * BEVEL_M, AROUND);
    }
    return mesh.build();
  }

  /** What the fingers slide on. */
  private Mesh rail(GripperSetup.Grip.Pads pads, double strokeM) {
    MeshBuilder mesh = new MeshBuilder(detail).finish(Finish.METAL);
    if (fingerM(pads) > 0) {
      double lengthM = strokeM + 4 * GripperSetup.FINGER_M;
      block(mesh, RAIL_M, lengthM, RAIL_M / 2, 0, bodyM() - reachM + RAIL_M / 4);
    }
    return mesh.build();
  }

  /** How long a finger is above its pad. */
  private double fingerM(GripperSetup.Grip.Pads pads) {
    return Math.max(0, reachM - bodyM() - pads.lengthM() / 2);
  }

  /**
   * @param side 1 for the one at positive y, otherwise -1
   */
  private Mesh finger(GripperSetup.Grip.Pads pads, int side) {
    MeshBuilder mesh = new MeshBuilder(detail).finish(pad);
    block(
        mesh,
        pads.widthM(),
        GripperSetup.FINGER_M / 2,
        pads.lengthM(),
        side * GripperSetup.FINGER_M / 4,
        0);
    mesh.finish(Finish.METAL);
    double lengthM = fingerM(pads) + pads.lengthM();
    block(
        mesh,
        0.8 * pads.widthM(),
        GripperSetup.FINGER_M / 2,
        lengthM,
        side * 0.75 * GripperSetup.FINGER_M,
        pads.lengthM() / 2 - lengthM / 2);
    return mesh.build();
  }

  private Mesh part() {
    MeshBuilder mesh = new MeshBuilder(detail).finish(Finish.OBJECT);
    block(mesh, PART_M, 1, PART_M, 0, 0);
    return mesh.build();
  }

  /** From the body on, with its lip in the middle of the hand. */
  private Mesh cup(GripperSetup.Grip.Cup cup) {
    MeshBuilder mesh = new MeshBuilder(detail).finish(Finish.METAL);
    double radiusM = cup.radiusM();
    double highM = Math.min(1.5 * radiusM, Math.max(radiusM / 2, reachM - bodyM()));
    double neckM = NECK_SHARE * radiusM;
    double tubeM = bodyM() - reachM;
    if (tubeM < -highM) {
      Lathe.cylinder(mesh, neckM, tubeM, BEVEL_M - highM, 0, AROUND);
    }
    mesh.finish(pad);
    Lathe.turn(
        mesh,
        new LatheProfile()
            .to(0, -highM)
            .to(neckM, -highM)
            .to(radiusM, 0)
            .to(LIP_SHARE * radiusM, 0)
            .to(0, -highM / 2),
        AROUND);
    return mesh.build();
  }

  /** A block along the axes, its middle on the plane x = 0. */
  private static void block(
      MeshBuilder mesh, double x, double y, double z, double middleY, double middleZ) {
    Vector3f half = new Vector3f((float) x / 2, (float) y / 2, (float) z / 2);
    double least = Math.min(x, Math.min(y, z));
    mesh.at(new Matrix4f().translation(0, (float) middleY, (float) middleZ));
    new Block(half, Math.min(BEVEL_M, least / 4)).addTo(mesh);
  }
}
