package org.pendant.cell;

import org.ode4j.math.DMatrix3;
import org.ode4j.math.DMatrix3C;
import org.ode4j.math.DVector3C;
import org.ode4j.ode.DBody;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DMass;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeHelper;
import org.pendant.models.pose.Transforms;

/** Rigid body: one of a world, as the library knows it. */
final class RigidBody {
  final BodyDescription description;
  final int index;
  final DGeom geom;

  /** Null where it is fixed. */
  final DBody body;

  /** Whether something touched it in the latest step. */
  boolean touched;

  /** Of contacts in the latest step: force, N, and torque about its origin, Nm, base's axes. */
  final double[] wrench = new double[6];

  private final DMatrix3 rotation = new DMatrix3();

  RigidBody(DWorld world, BodyDescription description, int index) {
    this.description = description;
    this.index = index;
    double[] at = new double[Transforms.SIZE];
    Transforms.of(description.poseInBase(), at);
    geom = geom(description.shape(), at);
    if (description.motion() == BodyMotion.FIXED) {
      body = null;
      if (!(description.shape() instanceof BodyShape.HalfSpace)) {
        geom.setPosition(at[9], at[10], at[11]);
        geom.setRotation(rotation(at));
      }
      return;
    }
    body = OdeHelper.createBody(world);
    geom.setBody(body);
    place(at);
    if (description.motion() == BodyMotion.GUIDED) {
      body.setKinematic();
      body.setAutoDisableFlag(false);
    } else {
      body.setMass(mass(description.shape(), description.massKg()));
    }
  }

  boolean free() {
    return description.motion() == BodyMotion.FREE;
  }

  boolean guided() {
    return description.motion() == BodyMotion.GUIDED;
  }

  /** Whether it may move in the next step. */
  boolean awake() {
    return body != null && body.isEnabled();
  }

  void place(double[] transform) {
    body.setPosition(transform[9], transform[10], transform[11]);
    body.setRotation(rotation(transform));
  }

  void readPose(double[] transform) {
    DMatrix3C r = body == null ? geom.getRotation() : body.getRotation();
    DVector3C p = body == null ? geom.getPosition() : body.getPosition();
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        transform[3 * row + column] = r.get(row, column);
      }
      transform[9 + row] = p.get(row);
    }
  }

  private DMatrix3 rotation(double[] t) {
    return rotation.set(t[0], t[1], t[2], t[3], t[4], t[5], t[6], t[7], t[8]);
  }

  private static DGeom geom(BodyShape shape, double[] at) {
    return switch (shape) {
      case BodyShape.Box(double x, double y, double z) -> OdeHelper.createBox(x, y, z);
      case BodyShape.Sphere(double radius) -> OdeHelper.createSphere(radius);
      case BodyShape.Cylinder(double radius, double length) ->
          OdeHelper.createCylinder(radius, length);
      case BodyShape.Capsule(double radius, double length) ->
          OdeHelper.createCapsule(radius, length);
      case BodyShape.HalfSpace() ->
          OdeHelper.createPlane(
              null, at[2], at[5], at[8], at[2] * at[9] + at[5] * at[10] + at[8] * at[11]);
    };
  }

  private static DMass mass(BodyShape shape, double massKg) {
    DMass mass = OdeHelper.createMass();
    switch (shape) {
      case BodyShape.Box(double x, double y, double z) -> mass.setBoxTotal(massKg, x, y, z);
      case BodyShape.Sphere(double radius) -> mass.setSphereTotal(massKg, radius);
      case BodyShape.Cylinder(double radius, double length) ->
          mass.setCylinderTotal(massKg, 3, radius, length);
      case BodyShape.Capsule(double radius, double length) ->
          mass.setCapsuleTotal(massKg, 3, radius, length);
      case BodyShape.HalfSpace() -> throw new IllegalStateException("half spaces are fixed");
    }
    return mass;
  }
}
