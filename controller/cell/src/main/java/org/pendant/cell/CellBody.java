package org.pendant.cell;

import java.util.Arrays;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;

/** Cell body: a rigid one of a world, with its motion. */
final class CellBody {
  private static final double REST_SPEED_M_PER_S = 0.003;
  private static final double REST_SPEED_RAD_PER_S = 0.02;

  final BodyDescription description;
  final int index;

  /** What it is made of: all of it mostly, or several that are rigidly joined. */
  final BodyPart[] parts;

  /** Its pose in the base frame, as {@link Transforms} has it. */
  final double[] pose = new double[Transforms.SIZE];

  /** Speed of its origin, m/s, and rad/s, along the base's axes. */
  final double[] twist = new double[6];

  /** Of contacts in the latest step: force, N, and torque about its origin, Nm, base's axes. */
  final double[] wrench = new double[6];

  /** No point of it is farther from its origin, m. */
  final double reachM;

  /** 0 unless it is free. */
  final double inverseMass;

  /** Inverse of its inertia along the base's axes, rows; 0 unless it is free. */
  final double[] inverseInertia = new double[9];

  boolean awake;

  /** Whether it is there; what is not touches nothing and stays where it is. */
  boolean present = true;

  /** Speed of its surface along itself, as of a belt, m/s, along the base's axes. */
  final double[] belt = new double[3];

  /** What holds it; null where nothing does. */
  BodyHold hold;

  /** What guides it; null where nothing does. */
  BodyGuide guide;

  /** The latest round of the solver in which its speed was changed. */
  int stirred;

  /** Whether something touched it in the latest step. */
  boolean touched;

  /** Whether a kinematic body did. */
  boolean kinematicTouched;

  /** How long it has been at rest. */
  double restS;

  /** Moments of inertia along its own axes, kg m^2. */
  private final double[] inertia;

  private final double[] speedBefore = new double[3];
  private final double[] turn = new double[9];
  private final double[] turned = new double[9];
  private final double[] momentum = new double[3];

  CellBody(BodyDescription description, int index) {
    this.description = description;
    this.index = index;
    Transforms.of(description.poseInBase(), pose);
    parts =
        description.shape() instanceof BodyShape.Compound compound
            ? compound.parts().stream()
                .map(part -> new BodyPart(part, pose))
                .toArray(BodyPart[]::new)
            : new BodyPart[] {new BodyPart(description.shape(), pose)};
    reachM = BodyPart.reachM(description.shape());
    inertia = BodyInertia.of(description.shape(), description.massKg());
    inverseMass = free() ? 1 / description.massKg() : 0;
    awake = description.motion() != BodyMotion.FIXED;
    moved();
  }

  /** Whether balls around both are apart: the quickest way to tell that they do not touch. */
  boolean farFrom(CellBody other) {
    double x = pose[9] - other.pose[9];
    double y = pose[10] - other.pose[10];
    double z = pose[11] - other.pose[11];
    double reach = reachM + other.reachM;
    return x * x + y * y + z * z > reach * reach;
  }

  /** Whether bounds of parts of both are not apart. */
  boolean near(CellBody other) {
    for (BodyPart own : parts) {
      for (BodyPart of : other.parts) {
        if (!own.apart(of)) {
          return true;
        }
      }
    }
    return false;
  }

  boolean free() {
    return description.motion() == BodyMotion.FREE;
  }

  boolean kinematic() {
    return description.motion() == BodyMotion.KINEMATIC;
  }

  /** Tells the shape, and the inertia, of a new pose. */
  void moved() {
    for (BodyPart part : parts) {
      part.follow();
    }
    if (free()) {
      for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
          double sum = 0;
          for (int k = 0; k < 3; k++) {
            sum += pose[3 * i + k] * pose[3 * j + k] / inertia[k];
          }
          inverseInertia[3 * i + j] = sum;
        }
      }
    }
  }

  /** Whether its surface runs. */
  boolean runs() {
    return belt[0] != 0 || belt[1] != 0 || belt[2] != 0;
  }

  /** Is where it was at first, at rest. */
  void putBack() {
    Transforms.of(description.poseInBase(), pose);
    Arrays.fill(twist, 0);
    moved();
  }

  void wake() {
    awake = true;
    restS = 0;
  }

  void sleep() {
    awake = false;
    Arrays.fill(twist, 0);
  }

  /** Adds the speed that gravity gives in a step. */
  void fall(double[] gravity, double stepS) {
    for (int i = 0; i < 3; i++) {
      speedBefore[i] = twist[i];
      twist[i] += gravity[i] * stepS;
    }
  }

  /** Adds an impulse, Ns, that acts {@code (x, y, z)} m away from the origin. */
  void hit(double x, double y, double z, double px, double py, double pz) {
    twist[0] += inverseMass * px;
    twist[1] += inverseMass * py;
    twist[2] += inverseMass * pz;
    turn(y * pz - z * py, z * px - x * pz, x * py - y * px);
  }

  /** Adds an impulse of turning, Nms. */
  void turn(double tx, double ty, double tz) {
    twist[3] += inverseInertia[0] * tx + inverseInertia[1] * ty + inverseInertia[2] * tz;
    twist[4] += inverseInertia[3] * tx + inverseInertia[4] * ty + inverseInertia[5] * tz;
    twist[5] += inverseInertia[6] * tx + inverseInertia[7] * ty + inverseInertia[8] * tz;
  }

  /**
   * Moves as its speed says. What nothing touches follows its parabola exactly, and what turns
   * keeps its angular momentum.
   */
  void move(double stepS) {
    for (int i = 0; i < 3; i++) {
      double speed = free() && !touched ? 0.5 * (speedBefore[i] + twist[i]) : twist[i];
      pose[9 + i] += speed * stepS;
    }
    if (twist[3] != 0 || twist[4] != 0 || twist[5] != 0) {
      readMomentum();
      Rotations.vectorToMatrix(twist[3] * stepS, twist[4] * stepS, twist[5] * stepS, turn);
      for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
          turned[3 * i + j] =
              turn[3 * i] * pose[j] + turn[3 * i + 1] * pose[3 + j] + turn[3 * i + 2] * pose[6 + j];
        }
      }
      straighten(turned);
      System.arraycopy(turned, 0, pose, 0, 9);
      moved();
      if (free()) {
        for (int i = 0; i < 3; i++) {
          twist[3 + i] =
              inverseInertia[3 * i] * momentum[0]
                  + inverseInertia[3 * i + 1] * momentum[1]
                  + inverseInertia[3 * i + 2] * momentum[2];
        }
      }
    } else {
      moved();
    }
    boolean rests =
        square(0) < REST_SPEED_M_PER_S * REST_SPEED_M_PER_S
            && square(3) < REST_SPEED_RAD_PER_S * REST_SPEED_RAD_PER_S;
    restS = rests && touched ? restS + stepS : 0;
  }

  private double square(int from) {
    return twist[from] * twist[from]
        + twist[from + 1] * twist[from + 1]
        + twist[from + 2] * twist[from + 2];
  }

  private void readMomentum() {
    Arrays.fill(momentum, 0);
    for (int k = 0; k < 3; k++) {
      double along =
          inertia[k] * (pose[k] * twist[3] + pose[3 + k] * twist[4] + pose[6 + k] * twist[5]);
      for (int i = 0; i < 3; i++) {
        momentum[i] += pose[3 * i + k] * along;
      }
    }
  }

  /** Makes rows of length 1 and at right angles again, which rounding has bent. */
  private static void straighten(double[] m) {
    double a = 1 / Math.sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    for (int i = 0; i < 3; i++) {
      m[i] *= a;
    }
    double dot = m[0] * m[3] + m[1] * m[4] + m[2] * m[5];
    for (int i = 0; i < 3; i++) {
      m[3 + i] -= dot * m[i];
    }
    double b = 1 / Math.sqrt(m[3] * m[3] + m[4] * m[4] + m[5] * m[5]);
    for (int i = 0; i < 3; i++) {
      m[3 + i] *= b;
    }
    m[6] = m[1] * m[5] - m[2] * m[4];
    m[7] = m[2] * m[3] - m[0] * m[5];
    m[8] = m[0] * m[4] - m[1] * m[3];
  }
}
