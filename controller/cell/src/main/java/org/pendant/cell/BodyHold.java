package org.pendant.cell;

import java.util.Arrays;
import org.pendant.models.pose.Transforms;

/**
 * Body hold: what a gripper does to a free body. A frame that somebody moves carries it along as
 * far as {@link HoldLimits} say; beyond them the body slips, and is held where it has slipped to.
 *
 * <p>The hold gives way a little, as a spring with a damper that is reckoned implicitly, so that
 * what carries it may be reckoned apart.
 */
public final class BodyHold {
  private static final double STIFFNESS_N_PER_M = 1e5;

  /** Of the hold against turning: that of springs 5 cm away from its middle, Nm/rad. */
  private static final double STIFFNESS_NM_PER_RAD = 250;

  private static final double DAMPING_RATIO = 0.7;

  /** Rows are corrected so often for each time that contacts are. */
  private static final int SWEEPS = 3;

  private static final int ROWS = 6;

  final CellBody body;
  private final int[] untouched;
  private HoldLimits limits;

  /** The frame at the end of the step, and its speed, along the base's axes. */
  private final double[] frame = new double[Transforms.SIZE];

  private final double[] twist = new double[6];

  /** Of the latest step, about the frame's origin, along the base's axes. */
  private final double[] wrench = new double[6];

  private final HeldPlace place;

  /** Of this step, as the place has them. */
  private final double[] arm;

  private final double[][] axes;
  private final double[] off;
  private final double[] impulse = new double[ROWS];
  private final double[] mass = new double[ROWS];
  private final double[] softness = new double[ROWS];
  private final double[] wanted = new double[ROWS];
  private final double[] most = new double[ROWS];
  private final double[] least = new double[ROWS];
  private int overloadedSteps;

  BodyHold(CellBody body, double[] frame, HoldLimits limits, int[] untouched) {
    this.body = body;
    this.limits = limits;
    this.untouched = untouched.clone();
    System.arraycopy(frame, 0, this.frame, 0, Transforms.SIZE);
    place = new HeldPlace(body, frame);
    arm = place.arm;
    axes = place.axes;
    off = place.off;
  }

  /** Whether the body passes through another one meanwhile, such as the fingers that hold it. */
  boolean ignores(CellBody other) {
    for (int each : untouched) {
      if (each == other.index) {
        return true;
      }
    }
    return false;
  }

  /**
   * Says where the frame is at the end of the next step, and how it moves.
   *
   * @param transform in the base frame
   * @param speed m/s of its origin and rad/s, along the base's axes
   */
  public void move(double[] transform, double[] speed) {
    System.arraycopy(transform, 0, frame, 0, Transforms.SIZE);
    System.arraycopy(speed, 0, twist, 0, 6);
  }

  /** Says what it withstands from now on. */
  public void withstand(HoldLimits limits) {
    this.limits = limits;
  }

  /** Which body it holds. */
  public int body() {
    return body.index;
  }

  /**
   * What the body does to the frame.
   *
   * @param wrench6 overwritten with force, N, and torque about its origin, Nm, along the base's
   *     axes
   */
  public void wrench(double[] wrench6) {
    System.arraycopy(wrench, 0, wrench6, 0, 6);
  }

  /** For how many steps on end more than it withstands has drawn at it. */
  public int overloadedSteps() {
    return overloadedSteps;
  }

  /** Begins a step: where things are, how far the body is off, and what may be done about it. */
  void begin(double stepS) {
    place.measure(frame, twist, stepS);
    place.slip(
        limits.axis(),
        limits.shearN() / STIFFNESS_N_PER_M,
        limits.bendNm() / STIFFNESS_NM_PER_RAD,
        limits.torsionNm() / STIFFNESS_NM_PER_RAD);
    for (int row = 0; row < ROWS; row++) {
      double yielding = yielding(row);
      double stiffness = row < 3 ? STIFFNESS_N_PER_M : STIFFNESS_NM_PER_RAD;
      double damping = 2 * DAMPING_RATIO * Math.sqrt(stiffness / yielding);
      softness[row] = 1 / (stepS * (damping + stepS * stiffness));
      wanted[row] = -off[row] * stepS * stiffness * softness[row];
      mass[row] = 1 / (yielding + softness[row]);
    }
    bound(stepS);
    for (int row = 0; row < ROWS; row++) {
      impulse[row] = Math.clamp(impulse[row], least[row], most[row]);
      hit(row, impulse[row]);
    }
  }

  /** Corrects the impulses; answers by how much, Ns. */
  double solve() {
    double change = 0;
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      for (int row = 0; row < ROWS; row++) {
        double next =
            impulse[row] + mass[row] * (wanted[row] - speed(row) - softness[row] * impulse[row]);
        next = Math.clamp(next, least[row], most[row]);
        double more = next - impulse[row];
        impulse[row] = next;
        hit(row, more);
        change += Math.abs(more);
      }
      change += keepWithinCircle(0, limits.axis());
      change += keepWithinCircle(3, limits.axis());
    }
    return change;
  }

  /** Ends a step: tells what was felt. */
  void end(double stepS) {
    Arrays.fill(wrench, 0);
    boolean overloaded = false;
    for (int row = 0; row < ROWS; row++) {
      for (int k = 0; k < 3; k++) {
        wrench[(row < 3 ? 0 : 3) + k] -= impulse[row] * axes[row % 3][k] / stepS;
      }
      overloaded |= impulse[row] <= least[row] || impulse[row] >= most[row];
    }
    overloaded |= fillsCircle(0) || fillsCircle(3);
    overloadedSteps = overloaded ? overloadedSteps + 1 : 0;
  }

  private void bound(double stepS) {
    int axis = limits.axis();
    for (int row = 0; row < 3; row++) {
      boolean along = row == axis;
      most[row] = stepS * (along ? limits.pushN() : limits.shearN());
      least[row] = -stepS * (along ? limits.pullN() : limits.shearN());
      most[3 + row] = stepS * (along ? limits.torsionNm() : limits.bendNm());
      least[3 + row] = -most[3 + row];
    }
  }

  /** What acts across the axis is within a circle; answers how much of it was too much. */
  private double keepWithinCircle(int from, int axis) {
    int a = from + (axis + 1) % 3;
    int b = from + (axis + 2) % 3;
    double size = Math.hypot(impulse[a], impulse[b]);
    if (size <= most[a]) {
      return 0;
    }
    double share = most[a] / size - 1;
    double change = 0;
    for (int row : new int[] {a, b}) {
      double more = impulse[row] * share;
      impulse[row] += more;
      hit(row, more);
      change += Math.abs(more);
    }
    return change;
  }

  private boolean fillsCircle(int from) {
    int a = from + (limits.axis() + 1) % 3;
    int b = from + (limits.axis() + 2) % 3;
    return Math.hypot(impulse[a], impulse[b]) >= 0.999 * most[a];
  }

  private void hit(int row, double size) {
    double[] along = axes[row % 3];
    if (row < 3) {
      body.hit(arm[0], arm[1], arm[2], size * along[0], size * along[1], size * along[2]);
    } else {
      body.turn(size * along[0], size * along[1], size * along[2]);
    }
  }

  /** How fast the body leaves the frame in a row, m/s or rad/s. */
  private double speed(int row) {
    double[] along = axes[row % 3];
    double[] of = body.twist;
    if (row >= 3) {
      return along[0] * (of[3] - twist[3])
          + along[1] * (of[4] - twist[4])
          + along[2] * (of[5] - twist[5]);
    }
    return along[0] * (of[0] + of[4] * arm[2] - of[5] * arm[1] - twist[0])
        + along[1] * (of[1] + of[5] * arm[0] - of[3] * arm[2] - twist[1])
        + along[2] * (of[2] + of[3] * arm[1] - of[4] * arm[0] - twist[2]);
  }

  /** The speed in a row that an impulse of 1 there gives. */
  private double yielding(int row) {
    double[] along = axes[row % 3];
    double x = along[0];
    double y = along[1];
    double z = along[2];
    if (row < 3) {
      x = arm[1] * along[2] - arm[2] * along[1];
      y = arm[2] * along[0] - arm[0] * along[2];
      z = arm[0] * along[1] - arm[1] * along[0];
    }
    double[] inverse = body.inverseInertia;
    double turning =
        x * (inverse[0] * x + inverse[1] * y + inverse[2] * z)
            + y * (inverse[3] * x + inverse[4] * y + inverse[5] * z)
            + z * (inverse[6] * x + inverse[7] * y + inverse[8] * z);
    return row < 3 ? body.inverseMass + turning : turning;
  }
}
