package org.pendant.desktop.scene.mesh;

import java.util.ArrayList;
import java.util.List;

/** Lathe: turns outlines around the z axis of the part's frame. */
final class Lathe {
  /** Corners of what is round, at best; at this number they are not seen. */
  static final int AROUND = 48;

  private Lathe() {}

  static void turn(MeshBuilder mesh, LatheProfile profile) {
    turn(mesh, profile, AROUND);
  }

  static void turn(MeshBuilder mesh, LatheProfile profile, int around) {
    turn(mesh, profile.points(mesh.detail()), mesh.detail().around(around));
  }

  private static void turn(MeshBuilder mesh, List<LatheProfile.Point> points, int around) {
    int first = -1;
    for (LatheProfile.Point point : points) {
      for (int j = 0; j < around; j++) {
        float cos = (float) Math.cos(2 * Math.PI * j / around);
        float sin = (float) Math.sin(2 * Math.PI * j / around);
        float r = (float) point.r();
        float nr = (float) point.nr();
        int vertex =
            mesh.vertex(
                r * cos, r * sin, (float) point.z(), nr * cos, nr * sin, (float) point.nz());
        first = first < 0 ? vertex : first;
      }
    }
    mesh.skin(first, points.size(), around);
  }

  /** A cylinder with rounded edges, from {@code fromM} to {@code toM} on the axis. */
  static void cylinder(
      MeshBuilder mesh, double radiusM, double fromM, double toM, double roundingM, int around) {
    LatheProfile profile =
        new LatheProfile()
            .to(0, fromM)
            .to(radiusM, fromM, roundingM)
            .to(radiusM, toM, roundingM)
            .to(0, toM);
    turn(mesh, profile, around);
  }

  /** A ball around the origin. */
  static void ball(MeshBuilder mesh, double radiusM, int around) {
    capsule(mesh, radiusM, 0, around);
  }

  /** A bar around the origin along z, with half a ball at each end. */
  static void capsule(MeshBuilder mesh, double radiusM, double lengthM, int around) {
    int meridians = mesh.detail().around(around);
    int steps = meridians / 4;
    List<LatheProfile.Point> points = new ArrayList<>();
    for (int end = -1; end <= 1; end += 2) {
      // once at the equator of a ball, where both halves meet
      for (int i = end > 0 && lengthM == 0 ? 1 : 0; i <= steps; i++) {
        double angle = (end < 0 ? i : i + steps) * Math.PI / (2 * steps);
        // exact at the poles: there the ring is one point
        double nr = (end < 0 && i == 0) || (end > 0 && i == steps) ? 0 : Math.sin(angle);
        double nz = -Math.cos(angle);
        points.add(new LatheProfile.Point(radiusM * nr, end * lengthM / 2 + radiusM * nz, nr, nz));
      }
    }
    turn(mesh, points, meridians);
  }
}
