package org.pendant.desktop.scene.mesh;

import java.util.List;
import java.util.Set;
import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;

/**
 * World mesh: the solids of a scene, in the base frame. Planes have no end and are drawn otherwise.
 */
public final class WorldMesh {
  private static final double WIDEST_BEVEL_M = 0.003;
  private static final double BEVEL_SHARE = 0.08;
  private static final int MERIDIANS = 48;

  private WorldMesh() {}

  /**
   * The mesh of some objects.
   *
   * @param touched names of those that look touched
   * @param detail how finely balls are cut
   */
  public static Mesh of(List<SceneObject> objects, Set<String> touched, Detail detail) {
    MeshBuilder mesh = new MeshBuilder(detail);
    for (SceneObject object : objects) {
      mesh.finish(touched.contains(object.name()) ? Finish.TOUCHED : Finish.OBJECT);
      add(mesh, object, touched);
    }
    return mesh.build();
  }

  private static void add(MeshBuilder mesh, SceneObject object, Set<String> touched) {
    switch (object) {
      case SceneObject.Compound compound ->
          compound.pieces().forEach(piece -> add(mesh, piece, touched));
      case SceneObject.Box box -> addBox(mesh, box);
      case SceneObject.Sphere sphere -> addSphere(mesh, sphere);
      case SceneObject.Rod rod -> addRod(mesh, rod);
      case SceneObject.Mesh part -> {
        mesh.at(frame(part.poseInBase()));
        Facets.add(mesh, part.part().triangles(), !touched.contains(part.name()));
      }
      case SceneObject.Plane plane -> {
        // Drawn as a surface with a grid.
      }
    }
  }

  private static void addBox(MeshBuilder mesh, SceneObject.Box box) {
    Pose pose = box.poseInBase();
    Vector3 size = box.sizeM();
    Vector3f half = new Vector3f((float) size.x() / 2, (float) size.y() / 2, (float) size.z() / 2);
    float shortest = 2 * Math.min(half.x, Math.min(half.y, half.z));
    mesh.at(frame(pose));
    new Block(half, Math.min(WIDEST_BEVEL_M, BEVEL_SHARE * shortest)).addTo(mesh);
  }

  static Matrix4f frame(Pose pose) {
    Matrix4f frame =
        new Matrix4f().translation((float) pose.x(), (float) pose.y(), (float) pose.z());
    Vector3f axis = new Vector3f((float) pose.rx(), (float) pose.ry(), (float) pose.rz());
    float angle = axis.length();
    return angle > 0 ? frame.rotate(angle, axis.div(angle)) : frame;
  }

  private static void addRod(MeshBuilder mesh, SceneObject.Rod rod) {
    double half = rod.lengthM() / 2;
    mesh.at(frame(rod.poseInBase()));
    if (rod.capsule()) {
      Lathe.capsule(mesh, rod.radiusM(), rod.lengthM(), MERIDIANS);
    } else {
      double thinnest = 2 * Math.min(rod.radiusM(), half);
      double edge = Math.min(WIDEST_BEVEL_M, BEVEL_SHARE * thinnest);
      Lathe.cylinder(mesh, rod.radiusM(), -half, half, edge, MERIDIANS);
    }
  }

  private static void addSphere(MeshBuilder mesh, SceneObject.Sphere sphere) {
    Vector3 centre = sphere.centreInBaseM();
    mesh.at(AxisDirection.UP_Z.at(centre.x(), centre.y(), centre.z()));
    Lathe.ball(mesh, sphere.radiusM(), MERIDIANS);
  }
}
