package org.pendant.cell;

import org.pendant.models.pose.Transforms;

/**
 * Body rail: guides a free body along a line between two ends, without turning, with friction and
 * damping. It takes what is across its line, whatever that is; bodies on it touch others as all do.
 *
 * <p>Each direction is a row of the solver, reckoned with those of contacts.
 */
public final class BodyRail extends BodyGuide {
  /** Rows are corrected so often for each time that contacts are. */
  private static final int SWEEPS = 3;

  /** Two across, three of turning, then friction and the two ends. */
  private static final int GUIDES = 5;

  private static final int FRICTION = 5;
  private static final int NEAR_END = 6;
  private static final int FAR_END = 7;
  private static final int ROWS = 8;

  /**
   * How it guides.
   *
   * @param along its direction, of length 1, in the base frame: x
   * @param alongY the same: y
   * @param alongZ the same: z
   * @param travelM how far the body goes along it, from where it is at first, m
   * @param frictionN force that it takes to move the body, N
   * @param dampingNSPerM force for each m/s, N s/m
   */
  public record Line(
      double along,
      double alongY,
      double alongZ,
      double travelM,
      double frictionN,
      double dampingNSPerM) {
    double axis(int k) {
      return k == 0 ? along : k == 1 ? alongY : alongZ;
    }
  }

  private final Line line;
  private final double[] start = new double[Transforms.SIZE];

  /** The line, and two directions across. */
  private final double[][] axes = new double[3][3];

  private final double[] impulse = new double[ROWS];
  private final double[] wanted = new double[ROWS];
  private final double[] mass = new double[ROWS];
  private double most;

  BodyRail(CellBody body, Line line) {
    super(body);
    this.line = line;
    System.arraycopy(body.pose, 0, start, 0, Transforms.SIZE);
    for (int k = 0; k < 3; k++) {
      axes[0][k] = line.axis(k);
    }
    ContactFrame.across(axes[0], axes[1], axes[2]);
  }

  /** How far the body is along the line from where it was at first, m. */
  @Override
  public double place() {
    return off(0);
  }

  private double off(int axis) {
    double sum = 0;
    for (int k = 0; k < 3; k++) {
      sum += axes[axis][k] * (body.pose[9 + k] - start[9 + k]);
    }
    return sum;
  }

  private double speed(int row) {
    double[] twist = body.twist;
    if (row >= 2 && row < GUIDES) {
      return twist[1 + row];
    }
    double[] along = axes[row < 2 ? 1 + row : 0];
    return along[0] * twist[0] + along[1] * twist[1] + along[2] * twist[2];
  }

  private void hit(int row, double size) {
    if (row >= 2 && row < GUIDES) {
      body.turn(row == 2 ? size : 0, row == 3 ? size : 0, row == 4 ? size : 0);
    } else {
      double[] along = axes[row < 2 ? 1 + row : 0];
      body.hit(0, 0, 0, size * along[0], size * along[1], size * along[2]);
    }
  }

  @Override
  void begin(double stepS) {
    double[] pose = body.pose;
    for (int row = 0; row < 2; row++) {
      wanted[row] = -RECOVERY * off(1 + row) / stepS;
      mass[row] = 1 / body.inverseMass;
    }
    for (int k = 0; k < 3; k++) {
      int a = (k + 1) % 3;
      int b = (k + 2) % 3;
      double turned = 0;
      // half the antisymmetric part of the turn from the orientation at first to that of now
      for (int j = 0; j < 3; j++) {
        turned += (start[3 * a + j] * pose[3 * b + j] - start[3 * b + j] * pose[3 * a + j]) / 2;
      }
      wanted[2 + k] = -RECOVERY * turned / stepS;
      mass[2 + k] = 1 / body.inverseInertia[4 * k];
    }
    double place = place();
    wanted[FRICTION] = driven;
    wanted[NEAR_END] = toEnd(-place, stepS);
    wanted[FAR_END] = -toEnd(place - line.travelM(), stepS);
    for (int row = FRICTION; row < ROWS; row++) {
      mass[row] = 1 / body.inverseMass;
    }
    most = stepS * line.frictionN();
    double slowed = 1 / (1 + stepS * line.dampingNSPerM() * body.inverseMass);
    hit(FRICTION, (slowed - 1) * speed(FRICTION) / body.inverseMass);
    for (int row = 0; row < ROWS; row++) {
      hit(row, impulse[row]);
    }
  }

  @Override
  double solve() {
    double change = 0;
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
      for (int row = 0; row < ROWS; row++) {
        double next = bounded(row, impulse[row] + mass[row] * (wanted[row] - speed(row)));
        double more = next - impulse[row];
        impulse[row] = next;
        hit(row, more);
        change += Math.abs(more);
      }
    }
    return change;
  }

  private double bounded(int row, double size) {
    return switch (row) {
      case FRICTION -> Math.clamp(size, -most, most);
      case NEAR_END -> Math.max(0, size);
      case FAR_END -> Math.min(0, size);
      default -> size;
    };
  }
}
