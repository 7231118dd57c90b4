package org.pendant.desktop.scene;

import java.util.EnumMap;
import java.util.Map;
import org.joml.Matrix4f;
import org.joml.Matrix4fc;
import org.pendant.desktop.scene.mesh.Link;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Link poses: where the bodies of an arm are: the frame of each, as its mesh has it, in the base
 * frame.
 */
public final class LinkPlaces {
  private static final float QUARTER = (float) (Math.PI / 2);

  private final Map<Link, Matrix4f> places = new EnumMap<>(Link.class);

  /** The bodies of an arm at these joint positions, rad. */
  public LinkPlaces(ForwardKinematics kinematics, DhLengths dh, Joints positionRad) {
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    kinematics.frames(positionRad.toArray(), frames);
    // Each mesh is described at its near end; the Denavit-Hartenberg frame is at the far one.
    places.put(Link.BASE, new Matrix4f());
    places.put(Link.SHOULDER, matrix(frames[0]).rotateX(-QUARTER));
    places.put(Link.UPPER_ARM, matrix(frames[1]).translate((float) -dh.a2(), 0, 0));
    places.put(Link.FOREARM, matrix(frames[2]).translate((float) -dh.a3(), 0, 0));
    places.put(Link.WRIST_1, matrix(frames[3]).rotateX(-QUARTER));
    places.put(Link.WRIST_2, matrix(frames[4]).rotateX(QUARTER));
    places.put(Link.WRIST_3, matrix(frames[5]));
  }

  /** As the other one, of an arm whose base stands somewhere: the frames are those of its place. */
  LinkPlaces(ForwardKinematics kinematics, DhLengths dh, Joints positionRad, Matrix4fc base) {
    this(kinematics, dh, positionRad);
    places.replaceAll((link, place) -> new Matrix4f(base).mul(place));
  }

  /** The frame of one body in the base frame. */
  public Matrix4fc of(Link link) {
    return places.get(link);
  }

  /** A pose as a matrix. */
  public static Matrix4f matrix(Pose pose) {
    double[] transform = new double[Transforms.SIZE];
    Transforms.of(pose, transform);
    return matrix(transform);
  }

  private static Matrix4f matrix(double[] t) {
    // JOML takes columns.
    return new Matrix4f(
        (float) t[0],
        (float) t[3],
        (float) t[6],
        0,
        (float) t[1],
        (float) t[4],
        (float) t[7],
        0,
        (float) t[2],
        (float) t[5],
        (float) t[8],
        0,
        (float) t[9],
        (float) t[10],
        (float) t[11],
        1);
  }
}
