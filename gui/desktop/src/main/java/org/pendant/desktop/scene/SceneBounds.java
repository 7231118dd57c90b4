package org.pendant.desktop.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3f;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.mesh.TriangleMesh;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Scene bounds: roughly what an arm, its tool and its trace fill, and its reach where that is
 * shown, for cameras that should show all of it.
 *
 * @param balls each of them is to be seen whole; at least one
 */
public record SceneBounds(List<Ball> balls) {
  /** Radius of a housing as a share of the length of the stretched arm. */
  private static final double HOUSING_SHARE = 0.075;

  /** More points of a trace than this say nothing more. */
  private static final int MAX_OF_TRACE = 200;

  /** Copies the list. */
  public SceneBounds {
    balls = List.copyOf(balls);
    if (balls.isEmpty()) {
      throw new IllegalArgumentException("outline: has no balls, must have at least one");
    }
  }

  /** The outline of the arm of a model as it stands. */
  public static SceneBounds of(SceneModel model) {
    DhLengths dh = model.arm().dh();
    double housingM = housingM(dh);
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    model.kinematics().frames(model.positionRad().toArray(), frames);
    List<Ball> balls = new ArrayList<>();
    balls.add(new Ball(new Vector3(0, 0, 0), housingM));
    for (double[] frame : frames) {
      balls.add(new Ball(new Vector3(frame[9], frame[10], frame[11]), housingM));
    }
    // The upper arm stands out along the axis of the shoulder, about as far as the wrist.
    for (int i = 0; i < 2; i++) {
      balls.add(new Ball(along(frames[i], dh.d4()), housingM));
    }
    Pose tcp = model.tcpInBase();
    balls.add(new Ball(new Vector3(tcp.x(), tcp.y(), tcp.z()), housingM));
    addObjects(model, balls);
    model.others().forEach(each -> addArm(each, balls));
    TcpTrace trace = model.trace();
    for (int i = 0; i < trace.size(); i += 1 + trace.size() / MAX_OF_TRACE) {
      balls.add(new Ball(new Vector3(trace.x(i), trace.y(i), trace.z(i)), 0));
    }
    if (model.safety().reach()) {
      balls.add(Ball.reach(model));
    }
    return new SceneBounds(balls);
  }

  private static double housingM(DhLengths dh) {
    return HOUSING_SHARE * (dh.d1() - dh.a2() - dh.a3() + dh.d5());
  }

  private static void addArm(OtherArm arm, List<Ball> balls) {
    LinkPlaces places = arm.places();
    double radiusM = housingM(arm.arm().dh());
    for (Link link : Link.values()) {
      Vector3f at = places.of(link).getTranslation(new Vector3f());
      balls.add(new Ball(new Vector3(at.x, at.y, at.z), radiusM));
    }
  }

  /** What stands so near that it belongs to the picture. */
  private static void addObjects(SceneModel model, List<Ball> balls) {
    double nearM = model.arm().reachM();
    List<SceneObject> pieces =
        model.world().objects().stream().flatMap(object -> object.pieces().stream()).toList();
    for (SceneObject piece : pieces) {
      Optional<Ball> ball =
          switch (piece) {
            case SceneObject.Sphere sphere ->
                Optional.of(new Ball(sphere.centreInBaseM(), sphere.radiusM()));
            case SceneObject.Box box -> {
              Pose pose = box.poseInBase();
              Vector3 centre = new Vector3(pose.x(), pose.y(), pose.z());
              yield Optional.of(new Ball(centre, box.sizeM().length() / 2));
            }
            case SceneObject.Rod rod -> {
              Pose pose = rod.poseInBase();
              Vector3 centre = new Vector3(pose.x(), pose.y(), pose.z());
              double half = rod.lengthM() / 2;
              yield Optional.of(
                  new Ball(
                      centre,
                      rod.capsule() ? half + rod.radiusM() : Math.hypot(half, rod.radiusM())));
            }
            case SceneObject.Mesh mesh -> Optional.of(around(mesh));
            case SceneObject.Plane _, SceneObject.Compound _ -> Optional.empty();
          };
      ball.filter(each -> each.centreM().length() + each.radiusM() < nearM).ifPresent(balls::add);
    }
  }

  /** A ball around the box of its triangles. */
  private static Ball around(SceneObject.Mesh mesh) {
    TriangleMesh triangles = mesh.part().triangles();
    double[] frame = new double[Transforms.SIZE];
    Transforms.of(mesh.poseInBase(), frame);
    double[] middle = new double[3];
    double[] half = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      middle[axis] = (triangles.least(axis) + triangles.most(axis)) / 2;
      half[axis] = (triangles.most(axis) - triangles.least(axis)) / 2;
    }
    double[] centre = new double[3];
    for (int row = 0; row < 3; row++) {
      centre[row] =
          frame[9 + row]
              + frame[3 * row] * middle[0]
              + frame[3 * row + 1] * middle[1]
              + frame[3 * row + 2] * middle[2];
    }
    return new Ball(
        new Vector3(centre[0], centre[1], centre[2]),
        new Vector3(half[0], half[1], half[2]).length());
  }

  private static Vector3 along(double[] frame, double z) {
    return new Vector3(frame[9] + z * frame[2], frame[10] + z * frame[5], frame[11] + z * frame[8]);
  }
}
