package org.pendant.controller.world;

import java.util.List;
import java.util.Optional;
import org.pendant.cell.BodyDescription;
import org.pendant.cell.BodyInertia;
import org.pendant.cell.BodyShape;
import org.pendant.cell.BodySurface;
import org.pendant.models.collision.SolidEdges;
import org.pendant.models.collision.ToolSolid;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Tool body: a solid on the flange: what links, objects and other arms meet of it, and what it
 * weighs. A mesh meets what can move with its convex hull, and links with its own surface.
 */
final class ToolBody {
  private final SceneObject object;
  private final BodyShape shape;

  /** Where its middle is in the flange's frame; its principal axes are those of this pose. */
  private final Pose inFlange;

  /**
   * The body of an object whose pose is one in the flange's frame.
   *
   * @throws IllegalArgumentException if it is a plane or a compound, or a mesh that can be no body
   */
  ToolBody(SceneObject object) {
    this.object = object;
    SolidBody body = SolidBody.of(object);
    shape = body.shape();
    inFlange = body.inFrame();
  }

  /** All of a tool. */
  static List<ToolBody> of(List<SceneObject> bodies) {
    return bodies.stream().map(ToolBody::new).toList();
  }

  /** What is on the flange of a scene, as links and objects that stand still meet it. */
  static List<ToolSolid> solids(List<SceneObject> bodies) {
    return of(bodies).stream().map(ToolBody::solid).toList();
  }

  private ToolSolid solid() {
    return shape instanceof BodyShape.Hull hull
        ? new ToolSolid(ArmSurroundings.solid(object), SolidEdges.of(inFlange, hull.hull()))
        : new ToolSolid(ArmSurroundings.solid(object));
  }

  Pose inFlange() {
    return inFlange;
  }

  /** The body that pushes what can move. */
  BodyDescription description(String name) {
    Material material = object.material();
    return BodyDescription.kinematic(
        name,
        shape,
        Pose.ZERO,
        new BodySurface(material.friction(), material.restitution(), material.stiffnessNPerM()));
  }

  /** What bodies with a mass weigh together; empty where none has one. */
  static Optional<Payload> weight(List<SceneObject> bodies) {
    List<ToolBody> all = of(bodies.stream().filter(each -> each.massKg() > 0).toList());
    if (all.isEmpty()) {
      return Optional.empty();
    }
    double massKg = 0;
    double[] cog = new double[3];
    for (ToolBody each : all) {
      massKg += each.object.massKg();
      for (int axis = 0; axis < 3; axis++) {
        cog[axis] += each.object.massKg() * each.inFlange.get(axis);
      }
    }
    for (int axis = 0; axis < 3; axis++) {
      cog[axis] /= massKg;
    }
    double[] inertia9 = new double[9];
    all.forEach(each -> each.addInertia(cog, inertia9));
    return Optional.of(
        new Payload(
            massKg,
            cog[0],
            cog[1],
            cog[2],
            inertia9[0],
            inertia9[4],
            inertia9[8],
            inertia9[1],
            inertia9[2],
            inertia9[5]));
  }

  /** Adds its inertia about a point, along the flange's axes (Steiner's theorem). */
  private void addInertia(double[] about3, double[] inertia9) {
    double massKg = object.massKg();
    double[] own = BodyInertia.of(shape, massKg);
    double[] frame = new double[Transforms.SIZE];
    Transforms.of(inFlange, frame);
    double[] arm = new double[3];
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
      arm[axis] = frame[9 + axis] - about3[axis];
      square += arm[axis] * arm[axis];
    }
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double sum = massKg * ((i == j ? square : 0) - arm[i] * arm[j]);
        for (int k = 0; k < 3; k++) {
          sum += frame[3 * i + k] * own[k] * frame[3 * j + k];
        }
        inertia9[3 * i + j] += sum;
      }
    }
  }
}
