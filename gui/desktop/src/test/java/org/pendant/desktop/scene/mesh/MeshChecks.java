package org.pendant.desktop.scene.mesh;

import java.util.HashMap;
import java.util.Map;
import org.joml.Vector3f;

/** What every mesh of a solid must satisfy. */
final class MeshChecks {
  private MeshChecks() {}

  private record Edge(Vector3f from, Vector3f to) {}

  /** Edges that are not run through as often in one direction as in the other. */
  static long openEdges(Mesh mesh) {
    Map<Edge, Integer> balance = new HashMap<>();
    for (int t = 0; t < mesh.triangleCount(); t++) {
      for (int k = 0; k < 3; k++) {
        Vector3f from = welded(mesh, mesh.corner(t, k));
        Vector3f to = welded(mesh, mesh.corner(t, (k + 1) % 3));
        balance.merge(new Edge(from, to), 1, Integer::sum);
        balance.merge(new Edge(to, from), -1, Integer::sum);
      }
    }
    return balance.values().stream().filter(count -> count != 0).count();
  }

  /** Zero and minus zero are one place. */
  private static Vector3f welded(Mesh mesh, int vertex) {
    return mesh.position(vertex).add(0, 0, 0);
  }

  /** What the surfaces enclose, m³; below 0 if they are turned inside out. */
  static double volumeM3(Mesh mesh) {
    double volume = 0;
    for (int t = 0; t < mesh.triangleCount(); t++) {
      Vector3f a = mesh.position(mesh.corner(t, 0));
      Vector3f b = mesh.position(mesh.corner(t, 1));
      Vector3f c = mesh.position(mesh.corner(t, 2));
      volume += a.dot(b.cross(c)) / 6;
    }
    return volume;
  }

  /** Share of the area whose triangles face the other way than the normals of their corners. */
  static double turnedShare(Mesh mesh) {
    double area = 0;
    double turned = 0;
    for (int t = 0; t < mesh.triangleCount(); t++) {
      Vector3f a = mesh.position(mesh.corner(t, 0));
      Vector3f across =
          mesh.position(mesh.corner(t, 1)).sub(a).cross(mesh.position(mesh.corner(t, 2)).sub(a));
      Vector3f normals = mesh.normal(mesh.corner(t, 0));
      normals.add(mesh.normal(mesh.corner(t, 1))).add(mesh.normal(mesh.corner(t, 2)));
      area += across.length();
      turned += across.dot(normals) < 0 ? across.length() : 0;
    }
    return turned / area;
  }
}
