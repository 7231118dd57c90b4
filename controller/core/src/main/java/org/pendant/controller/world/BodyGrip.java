package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.Optional;
import org.pendant.cell.BodyHold;
import org.pendant.cell.HoldLimits;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Transforms;
import org.pendant.models.time.FrameTime;

/**
 * Body grip: the hand of a person that holds an object with a mass at a point and carries it
 * somewhere, upright as it was. What is heavier than the hand can lift is dragged. A pull that is
 * not repeated within {@link HandGrip#DEAD_MAN_S} lets go.
 *
 * <p>Belongs to the thread of the frame loop.
 */
final class BodyGrip {
  /** The largest force of the hand, N. */
  static final double MAX_FORCE_N = 250;

  private static final double MAX_TORQUE_NM = 10;

  /** As fast as a hand moves things that it places, m/s. */
  private static final double MAX_SPEED_M_PER_S = 1.5;

  private static final Range PLACE = new Range(-100, 100, "m");
  private static final long DEAD_MAN_FRAMES = FrameTime.framesFor(HandGrip.DEAD_MAN_S);
  private static final HoldLimits LIMITS =
      new HoldLimits(2, MAX_FORCE_N, MAX_FORCE_N, MAX_FORCE_N, MAX_TORQUE_NM, MAX_TORQUE_NM);

  private final FreeBodies among;
  private final double[] frame12 = new double[Transforms.SIZE];
  private final double[] twist6 = new double[6];
  private final double[] goal = new double[3];
  private Optional<BodyHold> hold = Optional.empty();
  private String name = "";
  private long framesLeft;

  BodyGrip(FreeBodies among) {
    this.among = among;
  }

  /**
   * Carries an object towards a place for as long as this is repeated.
   *
   * @param object its name, or that of a copy
   * @param pointInBaseM where the hand takes it; counts only when it does not hold it yet
   * @param placeInBaseM where that point shall go
   * @throws IllegalArgumentException if there is no such object, a gripper holds it, or a number is
   *     outside its range
   */
  void pull(String object, Vector3 pointInBaseM, Vector3 placeInBaseM) {
    pointInBaseM.require("point", PLACE);
    placeInBaseM.require("place", PLACE);
    if (hold.isEmpty() || !name.equals(object)) {
      letGo();
      frame12[0] = 1;
      frame12[4] = 1;
      frame12[8] = 1;
      frame12[9] = pointInBaseM.x();
      frame12[10] = pointInBaseM.y();
      frame12[11] = pointInBaseM.z();
      int body = among.there(object);
      if (among.bodies().held(body)) {
        throw new IllegalArgumentException(text("heldByGripper", object));
      }
      hold = Optional.of(among.bodies().hold(body, frame12, LIMITS));
      name = object;
    }
    goal[0] = placeInBaseM.x();
    goal[1] = placeInBaseM.y();
    goal[2] = placeInBaseM.z();
    framesLeft = DEAD_MAN_FRAMES;
  }

  /** Holds nothing any more. */
  void letGo() {
    hold.ifPresent(among.bodies()::release);
    hold = Optional.empty();
  }

  boolean holds() {
    return hold.isPresent();
  }

  /** Moves the hand through a step. */
  void step(double stepS) {
    if (hold.isEmpty()) {
      return;
    }
    if (framesLeft-- <= 0) {
      letGo();
      return;
    }
    double x = goal[0] - frame12[9];
    double y = goal[1] - frame12[10];
    double z = goal[2] - frame12[11];
    double farM = Math.sqrt(x * x + y * y + z * z);
    double share = farM == 0 ? 0 : Math.min(1, MAX_SPEED_M_PER_S * stepS / farM);
    twist6[0] = x * share / stepS;
    twist6[1] = y * share / stepS;
    twist6[2] = z * share / stepS;
    for (int axis = 0; axis < 3; axis++) {
      frame12[9 + axis] += twist6[axis] * stepS;
    }
    hold.get().move(frame12, twist6);
  }
}
