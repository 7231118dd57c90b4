package org.pendant.cell;

/**
 * Body hinge: guides a free body about a line between two ends, with friction. It takes what would
 * pull the body off its line, whatever that is; bodies on it touch others as all do.
 *
 * <p>Three directions at the line and two of turning are reckoned together, as each changes all of
 * the others; friction and the two ends are rows of the solver as those of contacts are.
 */
public final class BodyHinge extends BodyGuide {
  /** Rows are corrected so often for each time that contacts are. */
  private static final int SWEEPS = 3;

  /** Three at the line, two of turning across it. */
  private static final int GUIDES = 5;

  private static final int FRICTION = 5;
  private static final int NEAR_END = 6;
  private static final int FAR_END = 7;
  private static final int ROWS = 8;

  /**
   * How it guides.
   *
   * @param x a point of the line, in the base frame, m, as the next two
   * @param alongX the direction of the line, of length 1, as the next two; it turns right-handed
   *     about that
   * @param angleRad how far the body turns from where it is at first, above 0, at most 3
   * @param frictionNm torque that it takes to turn the body, Nm
   */
  public record Axis(
      double x,
      double y,
      double z,
      double alongX,
      double alongY,
      double alongZ,
      double angleRad,
      double frictionNm) {
    double along(int k) {
      return k == 0 ? alongX : k == 1 ? alongY : alongZ;
    }

    double point(int k) {
      return k == 0 ? x : k == 1 ? y : z;
    }
  }

  private final Axis axis;

  /** The line, and two directions across, in the base frame. */
  private final double[][] axes = new double[3][3];

  /** The same line and the first of these directions, and the point, along the body's own axes. */
  private final double[] ownAlong = new double[3];

  private final double[] ownAcross = new double[3];
  private final double[] ownPoint = new double[3];

  /** From the origin of the body to the point, in the base frame. */
  private final double[] arm = new double[3];

  private final double[] impulse = new double[ROWS];
  private final double[] wanted = new double[ROWS];

  /** What an impulse of one row changes of the speed of another; then its Cholesky factor. */
  private final double[][] yielding = new double[GUIDES][GUIDES];

  private final double[] solved = new double[GUIDES];
  private double most;
  private double inertiaKgM2;

  BodyHinge(CellBody body, Axis axis) {
    super(body);
    this.axis = axis;
    for (int k = 0; k < 3; k++) {
      axes[0][k] = axis.along(k);
    }
    ContactFrame.across(axes[0], axes[1], axes[2]);
    double[] pose = body.pose;
    for (int k = 0; k < 3; k++) {
      for (int row = 0; row < 3; row++) {
        ownAlong[k] += pose[3 * row + k] * axes[0][row];
        ownAcross[k] += pose[3 * row + k] * axes[1][row];
        ownPoint[k] += pose[3 * row + k] * (axis.point(row) - pose[9 + row]);
      }
    }
  }

  /** How far the body is turned from where it was at first, rad, -pi to pi. */
  @Override
  public double place() {
    double along = 0;
    double aside = 0;
    for (int row = 0; row < 3; row++) {
      double across = inBase(ownAcross, row);
      along += across * axes[1][row];
      aside += across * axes[2][row];
    }
    return Math.atan2(aside, along);
  }

  private double inBase(double[] own, int row) {
    double[] pose = body.pose;
    return pose[3 * row] * own[0] + pose[3 * row + 1] * own[1] + pose[3 * row + 2] * own[2];
  }

  @Override
  void begin(double stepS) {
    for (int row = 0; row < 3; row++) {
      arm[row] = inBase(ownPoint, row);
      wanted[row] = RECOVERY * (axis.point(row) - body.pose[9 + row] - arm[row]) / stepS;
    }
    for (int row = 3; row < GUIDES; row++) {
      double[] across = axes[row - 2];
      double off = 0;
      // the turn from where its line is now to where it should be
      for (int k = 0; k < 3; k++) {
        int a = (k + 1) % 3;
        int b = (k + 2) % 3;
        off += across[k] * (inBase(ownAlong, a) * axes[0][b] - inBase(ownAlong, b) * axes[0][a]);
      }
      wanted[row] = RECOVERY * off / stepS;
    }
    factor();
    inertiaKgM2 = inertiaAboutLine();
    double place = place();
    wanted[FRICTION] = driven;
    wanted[NEAR_END] = toEnd(-place, stepS);
    wanted[FAR_END] = -toEnd(place - axis.angleRad(), stepS);
    most = stepS * axis.frictionNm();
    for (int row = 0; row < ROWS; row++) {
      hit(row, impulse[row]);
    }
  }

  /** How fast the body goes along a row. */
  private double speed(int row) {
    double[] twist = body.twist;
    if (row < 3) {
      int a = (row + 1) % 3;
      int b = (row + 2) % 3;
      return twist[row] + twist[3 + a] * arm[b] - twist[3 + b] * arm[a];
    }
    double[] about = axes[row < GUIDES ? row - 2 : 0];
    return about[0] * twist[3] + about[1] * twist[4] + about[2] * twist[5];
  }

  private void hit(int row, double size) {
    if (row < 3) {
      body.hit(
          arm[0], arm[1], arm[2], row == 0 ? size : 0, row == 1 ? size : 0, row == 2 ? size : 0);
    } else {
      double[] about = axes[row < GUIDES ? row - 2 : 0];
      body.turn(size * about[0], size * about[1], size * about[2]);
    }
  }

  /** The turning that an impulse of a row gives its body, before its inertia. */
  private double lever(int row, int k) {
    if (row >= 3) {
      return axes[row - 2][k];
    }
    // arm x unit vector
    return k == row ? 0 : k == (row + 1) % 3 ? arm[(row + 2) % 3] : -arm[(row + 1) % 3];
  }

  private void factor() {
    double[] inverse = body.inverseInertia;
    for (int row = 0; row < GUIDES; row++) {
      for (int other = 0; other <= row; other++) {
        double sum = row == other && row < 3 ? body.inverseMass : 0;
        for (int i = 0; i < 3; i++) {
          for (int j = 0; j < 3; j++) {
            sum += lever(row, i) * inverse[3 * i + j] * lever(other, j);
          }
        }
        for (int k = 0; k < other; k++) {
          sum -= yielding[row][k] * yielding[other][k];
        }
        yielding[row][other] = row == other ? Math.sqrt(sum) : sum / yielding[other][other];
      }
    }
  }

  /** What the body resists turning about the line with: parallel axis theorem. */
  private double inertiaAboutLine() {
    double[] along = axes[0];
    double[] inverse = body.inverseInertia;
    double around = 0;
    double onLine = arm[0] * along[0] + arm[1] * along[1] + arm[2] * along[2];
    double apart2 = 0;
    for (int i = 0; i < 3; i++) {
      double apart = arm[i] - onLine * along[i];
      apart2 += apart * apart;
      for (int j = 0; j < 3; j++) {
        around += along[i] * inverse[3 * i + j] * along[j];
      }
    }
    return 1 / around + apart2 / body.inverseMass;
  }

  @Override
  double solve() {
    double change = 0;
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      for (int row = FRICTION; row < ROWS; row++) {
        double next = bounded(row, impulse[row] + inertiaKgM2 * (wanted[row] - speed(row)));
        double more = next - impulse[row];
        impulse[row] = next;
        hit(row, more);
        change += Math.abs(more);
        change += solveGuides();
      }
    }
    return change;
  }

  /** Corrects all that holds the body on its line at once. */
  private double solveGuides() {
    for (int row = 0; row < GUIDES; row++) {
      double sum = wanted[row] - speed(row);
      for (int k = 0; k < row; k++) {
        sum -= yielding[row][k] * solved[k];
      }
      solved[row] = sum / yielding[row][row];
    }
    double change = 0;
    for (int row = GUIDES - 1; row >= 0; row--) {
      double sum = solved[row];
      for (int k = row + 1; k < GUIDES; k++) {
        sum -= yielding[k][row] * solved[k];
      }
      solved[row] = sum / yielding[row][row];
    }
    for (int row = 0; row < GUIDES; row++) {
      impulse[row] += solved[row];
      hit(row, solved[row]);
      change += Math.abs(solved[row]);
    }
    return change;
  }

  private double bounded(int row, double size) {
    return switch (row) {
      case FRICTION -> Math.clamp(size, -most, most);
      case NEAR_END -> Math.max(0, size);
      default -> Math.min(0, size);
    };
  }
}
