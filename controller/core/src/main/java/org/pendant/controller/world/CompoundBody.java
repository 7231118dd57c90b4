package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import org.pendant.cell.BodyInertia;
import org.pendant.cell.BodyShape;
import org.pendant.models.mesh.PrincipalAxes;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Compound body: solids that are rigidly joined as one body. Its mass and inertia are those of its
 * parts together, by the parallel axis theorem; what overlaps counts twice.
 */
final class CompoundBody implements BodyFrame {
  /** A part as a body of its own. */
  private static final class Part {
    final BodyShape shape;
    final double massKg;
    final double[] inObject12 = new double[Transforms.SIZE];

    Part(BodyShape shape, Pose inObject, double massKg) {
      this.shape = shape;
      this.massKg = massKg;
      Transforms.of(inObject, inObject12);
    }
  }

  private final BodyShape.Compound shape;
  private final double[] bodyInObject12 = new double[Transforms.SIZE];
  private final double[] objectInBody12 = new double[Transforms.SIZE];

  /** The body of an object; of one that stands still meshes keep their surface. */
  CompoundBody(SceneObject.Compound object) {
    boolean moves = object.massKg() > 0;
    List<Part> parts = new ArrayList<>();
    for (int i = 0; i < object.parts().size(); i++) {
      parts.add(part(object.parts().get(i), moves, object.partKg(i)));
    }
    double[] moments = {1, 1, 1};
    if (moves) {
      moments = balance(parts, object.massKg());
    } else {
      for (int axis = 0; axis < 3; axis++) {
        bodyInObject12[4 * axis] = 1;
      }
    }
    Transforms.invert(bodyInObject12, objectInBody12);
    double[] inBody12 = new double[Transforms.SIZE];
    List<BodyShape.Compound.Part> joined = new ArrayList<>();
    for (Part part : parts) {
      Transforms.multiply(objectInBody12, part.inObject12, inBody12);
      joined.add(new BodyShape.Compound.Part(part.shape, Transforms.toPose(inBody12)));
    }
    shape = new BodyShape.Compound(joined, moments[0], moments[1], moments[2]);
  }

  private static Part part(SceneObject part, boolean moves, double massKg) {
    if (!moves && part instanceof SceneObject.Mesh mesh) {
      return new Part(new BodyShape.Faces(mesh.part().triangles()), mesh.poseInBase(), 0);
    }
    SolidBody body = SolidBody.of(part);
    return new Part(body.shape(), body.inFrame(), massKg);
  }

  /** Puts the body's frame where its parts balance; answers its moments for each kg, m^2. */
  private double[] balance(List<Part> parts, double massKg) {
    for (Part part : parts) {
      for (int axis = 0; axis < 3; axis++) {
        bodyInObject12[9 + axis] += part.massKg / massKg * part.inObject12[9 + axis];
      }
    }
    double[] inertia9 = new double[9];
    for (Part part : parts) {
      addInertia(part, inertia9);
    }
    PrincipalAxes.turn(inertia9, bodyInObject12);
    return new double[] {inertia9[0] / massKg, inertia9[4] / massKg, inertia9[8] / massKg};
  }

  private void addInertia(Part part, double[] inertia9) {
    double[] own = BodyInertia.of(part.shape, part.massKg);
    double[] frame = part.inObject12;
    double[] arm = new double[3];
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
      arm[axis] = frame[9 + axis] - bodyInObject12[9 + axis];
      square += arm[axis] * arm[axis];
    }
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double sum = part.massKg * ((i == j ? square : 0) - arm[i] * arm[j]);
        for (int k = 0; k < 3; k++) {
          sum += frame[3 * i + k] * own[k] * frame[3 * j + k];
        }
        inertia9[3 * i + j] += sum;
      }
    }
  }

  @Override
  public BodyShape.Compound shape() {
    return shape;
  }

  @Override
  public Pose ofFile(Pose objectInBase) {
    return BodyFrame.times(objectInBase, bodyInObject12);
  }

  @Override
  public void toFile(double[] body12, double[] object12) {
    Transforms.multiply(body12, objectInBody12, object12);
  }
}
