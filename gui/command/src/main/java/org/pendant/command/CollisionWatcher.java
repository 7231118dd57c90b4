package org.pendant.command;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.ArmSurroundings;
import org.pendant.controller.world.LinkHit;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;

/**
 * Collision watcher: notes what the links of an arm get into while a program runs, which passes
 * through, and how near they come; links of other arms of its cell are among that. What they are in
 * at first counts when they have left it.
 */
final class CollisionWatcher implements FrameWatcher {
  /** How far apart what touched must be to touch anew, m. */
  private static final double LEFT_M = 1e-3;

  private static final int NONE = -1;
  private static final int EXCUSED = -2;

  /**
   * Another arm of the cell.
   *
   * @param program what it runs; empty for nothing
   * @param state what its controller published in the frame that is being watched
   */
  record Other(String name, Optional<String> program, Supplier<ControllerState> state) {}

  /** A line of the program of another arm. */
  record OtherLine(String program, int line) {}

  /**
   * What a link got into.
   *
   * @param hit what met what, and how deep at most
   * @param line of the program, when it began; the last one where it has ended
   * @param other where the program of the other arm was then, if that is what was hit
   * @param timeS controller time then, s
   * @param untilS when it was out again, or at the end, s
   */
  record Collision(LinkHit hit, int line, Optional<OtherLine> other, double timeS, double untilS) {}

  /**
   * The nearest that any two came.
   *
   * @param pair what, with the distance as a negative depth
   * @param line of the program then
   * @param timeS controller time then, s
   */
  record Nearest(LinkHit pair, int line, double timeS) {}

  private final ArmSurroundings surroundings;
  private final List<Other> others;
  private final double limitS;
  private final double[] q = new double[Joints.COUNT];
  private final double[] othersRad;
  private final List<Collision> collisions = new ArrayList<>();

  /** For each pair which of the collisions it is in. */
  private final int[] open;

  private double nearestM = Double.POSITIVE_INFINITY;
  private Optional<Nearest> nearest = Optional.empty();
  private double timeS;
  private int line;

  /**
   * Watches an arm in a scene.
   *
   * @param limitS controller time after which it has seen enough, s
   */
  CollisionWatcher(ArmDescription arm, Scene scene, double limitS) {
    this(new ArmSurroundings(arm, scene), List.of(), limitS);
  }

  /**
   * Watches an arm among others.
   *
   * @param others in the order in which the surroundings have them
   */
  CollisionWatcher(ArmSurroundings surroundings, List<Other> others, double limitS) {
    this.surroundings = surroundings;
    this.others = List.copyOf(others);
    this.limitS = limitS;
    othersRad = new double[Joints.COUNT * others.size()];
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
    if (state.program().line() > 0) {
      line = state.program().line();
    }
    for (int i = 0; i < others.size(); i++) {
      others.get(i).state().get().arm().actualPositionRad().copyTo(q);
      System.arraycopy(q, 0, othersRad, Joints.COUNT * i, Joints.COUNT);
    }
    surroundings.moveOthers(othersRad);
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
        LinkHit hit = surroundings.hit(pair, -distanceM);
        collisions.add(new Collision(hit, line, otherLine(hit), timeS, timeS));
      }
    }
  }

  private Optional<OtherLine> otherLine(LinkHit hit) {
    for (Other each : others) {
      int at = each.state().get().program().line();
      if (hit.otherArm().equals(Optional.of(each.name())) && at > 0) {
        return each.program().map(program -> new OtherLine(program, at));
      }
    }
    return Optional.empty();
  }

  private void continueIn(int number, int pair, double depthM) {
    Collision begun = collisions.get(number);
    LinkHit hit = depthM > begun.hit().depthM() ? surroundings.hit(pair, depthM) : begun.hit();
    double untilS = depthM > 0 ? timeS : begun.untilS();
    collisions.set(number, new Collision(hit, begun.line(), begun.other(), begun.timeS(), untilS));
  }
}
