package org.pendant.command;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.ArmSurroundings;
import org.pendant.controller.world.LinkHit;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;

/**
 * Collision watcher: notes what the links of the arm get into while a program runs, which passes
 * through, and how near they come. What they are in at first counts when they have left it.
 */
final class CollisionWatcher implements FrameWatcher {
  /** How far apart what touched must be to touch anew, m. */
  private static final double LEFT_M = 1e-3;

  private static final int NONE = -1;
  private static final int EXCUSED = -2;

  /**
   * What a link got into.
   *
   * @param hit what met what, and how deep at most
   * @param line of the program, when it began
   * @param timeS controller time then, s
   * @param untilS when it was out again, or at the end, s
   */
  record Collision(LinkHit hit, int line, double timeS, double untilS) {}

  /**
   * The nearest that any two came.
   *
   * @param pair what, with the distance as a negative depth
   * @param line of the program then
   * @param timeS controller time then, s
   */
  record Nearest(LinkHit pair, int line, double timeS) {}

  private final ArmSurroundings surroundings;
  private final double limitS;
  private final double[] q = new double[Joints.COUNT];
  private final List<Collision> collisions = new ArrayList<>();

  /** For each pair which of the collisions it is in. */
  private final int[] open;

  private double nearestM = Double.POSITIVE_INFINITY;
  private Optional<Nearest> nearest = Optional.empty();
  private double timeS;

  /**
   * Watches an arm in a scene.
   *
   * @param limitS controller time after which it has seen enough, s
   */
  CollisionWatcher(ArmDescription arm, Scene scene, double limitS) {
    surroundings = new ArmSurroundings(arm, scene);
    this.limitS = limitS;
    open = new int[surroundings.pairs()];
    Arrays.fill(open, EXCUSED);
  }

  /** What happened, in its order. */
  List<Collision> collisions() {
    return List.copyOf(collisions);
  }

  /** The nearest that any two came that were apart once; empty where there are none. */
  Optional<Nearest> nearest() {
    return nearest;
  }

  /** The last moment that it has seen, s. */
  double timeS() {
    return timeS;
  }

  @Override
  public boolean enough() {
    return timeS >= limitS;
  }

  @Override
  public void see(ControllerState state) {
    timeS = state.timeS();
    int line = state.program().line();
    state.arm().actualPositionRad().copyTo(q);
    surroundings.at(q);
    boolean bare = surroundings.bareFlange(state.arm().tool().inFlange());
    for (int pair = 0; pair < open.length; pair++) {
      if (bare && surroundings.presses(pair)) {
        open[pair] = EXCUSED;
        continue;
      }
      double distanceM = surroundings.distanceM(pair, Math.max(LEFT_M, nearestM));
      if (distanceM >= LEFT_M) {
        open[pair] = NONE;
      }
      if (open[pair] == EXCUSED) {
        continue;
      }
      if (distanceM < nearestM) {
        nearestM = distanceM;
        nearest = Optional.of(new Nearest(surroundings.hit(pair, -distanceM), line, timeS));
      }
      if (open[pair] != NONE) {
        continueIn(open[pair], pair, -distanceM);
      } else if (distanceM < 0) {
        open[pair] = collisions.size();
        collisions.add(new Collision(surroundings.hit(pair, -distanceM), line, timeS, timeS));
      }
    }
  }

  private void continueIn(int number, int pair, double depthM) {
    Collision begun = collisions.get(number);
    LinkHit hit = depthM > begun.hit().depthM() ? surroundings.hit(pair, depthM) : begun.hit();
    double untilS = depthM > 0 ? timeS : begun.untilS();
    collisions.set(number, new Collision(hit, begun.line(), begun.timeS(), untilS));
  }
}
