package org.pendant.desktop.scene.mesh;

import org.joml.Matrix4f;

/** Marks: signs that are drawn among the bodies, in unit size. */
public final class Marks {
  private static final double SHAFT = 0.022;
  private static final double HEAD = 0.06;
  private static final double HEAD_FROM = 0.78;
  private static final int AROUND = 20;

  private Marks() {}

  /** The axes of a frame as arrows of length 1, red x, green y and blue z. */
  public static Mesh frame(Detail detail) {
    MeshBuilder mesh = new MeshBuilder(detail);
    addArrow(mesh.finish(Finish.AXIS_X), new Matrix4f().rotateY((float) (Math.PI / 2)));
    addArrow(mesh.finish(Finish.AXIS_Y), AxisDirection.UP_Y.at(0, 0, 0));
    addArrow(mesh.finish(Finish.AXIS_Z), AxisDirection.UP_Z.at(0, 0, 0));
    mesh.at(new Matrix4f()).finish(Finish.TOOL);
    Lathe.ball(mesh, 1.8 * SHAFT, AROUND);
    return mesh.build();
  }

  /** A rod along z from 0 to 1, to be stretched along z only, of a radius in m. */
  public static Mesh rod(double radiusM, Detail detail) {
    MeshBuilder mesh = new MeshBuilder(detail);
    mesh.finish(Finish.TOOL);
    Lathe.cylinder(mesh, radiusM, 0, 1, 0, AROUND);
    return mesh.build();
  }

  /** A ball of radius 1. */
  public static Mesh ball(Detail detail) {
    MeshBuilder mesh = new MeshBuilder(detail);
    mesh.finish(Finish.LOAD);
    Lathe.ball(mesh, 1, 2 * AROUND);
    return mesh.build();
  }

  private static void addArrow(MeshBuilder mesh, Matrix4f place) {
    mesh.at(place);
    LatheProfile profile =
        new LatheProfile().to(0, 0).to(SHAFT, 0).to(SHAFT, HEAD_FROM).to(HEAD, HEAD_FROM).to(0, 1);
    Lathe.turn(mesh, profile, AROUND);
  }
}
