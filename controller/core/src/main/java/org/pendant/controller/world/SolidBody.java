package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import org.pendant.cell.BodyShape;
import org.pendant.models.pose.Pose;

/**
 * Solid body: what a solid of one piece fills as a body that may move.
 *
 * @param inFrame where its middle is in the frame that its object has its pose in; its principal
 *     axes are those of this pose
 */
record SolidBody(BodyShape shape, Pose inFrame) {
  /**
   * The body of an object.
   *
   * @throws IllegalArgumentException if it is a plane or a compound, or a mesh that can be no body
   */
  static SolidBody of(SceneObject object) {
    return switch (object) {
      case SceneObject.Plane _ -> throw new IllegalArgumentException("a plane is no body");
      case SceneObject.Compound _ -> throw new IllegalArgumentException(text("severalPieces"));
      case SceneObject.Box box ->
          new SolidBody(
              new BodyShape.Box(box.sizeM().x(), box.sizeM().y(), box.sizeM().z()),
              box.poseInBase());
      case SceneObject.Rod rod ->
          new SolidBody(
              rod.capsule()
                  ? new BodyShape.Capsule(rod.radiusM(), rod.lengthM())
                  : new BodyShape.Cylinder(rod.radiusM(), rod.lengthM()),
              rod.poseInBase());
      case SceneObject.Sphere ball -> {
        Vector3 at = ball.centreInBaseM();
        yield new SolidBody(
            new BodyShape.Sphere(ball.radiusM()), new Pose(at.x(), at.y(), at.z(), 0, 0, 0));
      }
      case SceneObject.Mesh mesh -> {
        MeshBody body = new MeshBody(mesh.part().triangles());
        yield new SolidBody(body.shape(), body.ofFile(mesh.poseInBase()));
      }
    };
  }
}
