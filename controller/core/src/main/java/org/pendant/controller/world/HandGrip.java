package org.pendant.controller.world;

import org.pendant.models.arm.Joints;
import org.pendant.models.json.Range;
import org.pendant.models.time.FrameTime;

/**
 * Hand grip: a hand that holds the arm at a point of one of its links, and pushes it with a force
 * or pulls it towards a place. Pulling is a spring with a damper whose force is bounded, so that it
 * stays calm however far away the place is; the place is followed smoothly, since the client that
 * says where it is may do so a few times a second only. A pull that is not repeated within {@value
 * #DEAD_MAN_S} s lets go.
 *
 * <p>Links are counted by the joint that moves them, 0 to 5, and have the frame of
 * Denavit-Hartenberg after that joint: link 5 is the flange.
 *
 * <p>Belongs to the thread of the frame loop.
 */
public final class HandGrip {
  /** Longest time between two repetitions of a pull, s of robot time. */
  public static final double DEAD_MAN_S = 0.25;

  /** The largest force of a pull, N. */
  public static final double MAX_PULL_N = 100;

  /** Force of the spring for each metre of distance, N/m. */
  static final double STIFFNESS_N_PER_M = 1000;

  /** What the gripped point loses for each m/s of its own speed, N s/m. */
  static final double DAMPING_N_S_PER_M = 40;

  /** How soon the place is followed, s: about the time between two pictures on a screen. */
  private static final double FOLLOWING_S = 0.035;

  /** From here on the place is reached, m. */
  private static final double REACHED_M = 1e-9;

  /** Farthest gripped point from the origin of its link's frame, along each axis. */
  private static final Range POINT = new Range(-4, 4, "m");

  /** Where an arm may be pulled to, along each axis of the base. */
  private static final Range PLACE = new Range(-100, 100, "m");

  private static final long DEAD_MAN_FRAMES = FrameTime.framesFor(DEAD_MAN_S);
  private static final double STEP = 1 - Math.exp(-FrameTime.FRAME_S / FOLLOWING_S);
  private static final int NOWHERE = -1;

  private final double[] point = new double[3];
  private final double[] push = new double[3];
  private final double[] place = new double[3];
  private final double[] goal = new double[3];
  private int link = NOWHERE;
  private boolean pulls;
  private long framesLeft;
  private long changes;

  /** A hand that holds nothing. */
  public HandGrip() {}

  /**
   * Pushes until told otherwise.
   *
   * @param link 0 to 5
   * @param pointInLinkM where, in the frame of the link, -4 to 4 m along each axis
   * @param forceInBaseN along the axes of the base, -10,000 to 10,000 N each; all 0 lets go
   * @throws IllegalArgumentException if a number is outside its range
   */
  public void push(int link, Vector3 pointInLinkM, Vector3 forceInBaseN) {
    requireLink(link);
    pointInLinkM.require("point", POINT);
    forceInBaseN.require("force", ContactWorld.APPLIED);
    if (forceInBaseN.length() == 0) {
      letGo();
      return;
    }
    hold(link, pointInLinkM);
    copy(forceInBaseN, push);
    pulls = false;
  }

  /**
   * Pulls towards a place for as long as this is repeated.
   *
   * @param link 0 to 5
   * @param pointInLinkM where the hand holds, in the frame of the link, -4 to 4 m along each axis
   * @param placeInBaseM where it pulls to, -100 to 100 m along each axis
   * @throws IllegalArgumentException if a number is outside its range
   */
  public void pull(int link, Vector3 pointInLinkM, Vector3 placeInBaseM) {
    requireLink(link);
    pointInLinkM.require("point", POINT);
    placeInBaseM.require("place", PLACE);
    boolean continues = pulls && this.link == link;
    hold(link, pointInLinkM);
    copy(placeInBaseM, goal);
    if (!continues) {
      copy(placeInBaseM, place);
    }
    pulls = true;
    framesLeft = DEAD_MAN_FRAMES;
  }

  /** Holds nothing any more. */
  public void letGo() {
    if (holds()) {
      link = NOWHERE;
      pulls = false;
      changes++;
    }
  }

  private static void requireLink(int link) {
    if (link < 0 || link >= Joints.COUNT) {
      throw new IllegalArgumentException(
          "link is " + link + ", must be 0 to " + (Joints.COUNT - 1));
    }
  }

  private void hold(int held, Vector3 pointInLinkM) {
    link = held;
    copy(pointInLinkM, point);
    changes++;
  }

  private static void copy(Vector3 from, double[] to) {
    to[0] = from.x();
    to[1] = from.y();
    to[2] = from.z();
  }

  /** A frame begins: the place that it pulls to comes nearer to what was asked for. */
  public void beginFrame() {
    if (!pulls) {
      return;
    }
    if (framesLeft-- <= 0) {
      letGo();
      return;
    }
    double left = 0;
    for (int axis = 0; axis < 3; axis++) {
      double way = goal[axis] - place[axis];
      place[axis] += STEP * way;
      left = Math.max(left, Math.abs(way));
    }
    if (left > REACHED_M) {
      changes++;
    }
  }

  /** Whether the hand is on the arm. */
  public boolean holds() {
    return link != NOWHERE;
  }

  /** Whether it pulls, rather than pushes. */
  public boolean pulls() {
    return pulls;
  }

  /** The link that it holds; only while it {@link #holds} one. */
  public int link() {
    return link;
  }

  /** Where it holds the link, along axis 0 to 2 of the link's frame, m. */
  public double pointInLinkM(int axis) {
    return point[axis];
  }

  /** Grows whenever the hand may push otherwise than before. */
  public long changes() {
    return changes;
  }

  /**
   * The force of the hand that holds. Allocates nothing.
   *
   * @param point3 where the gripped point is, in the base frame, m
   * @param velocity3 how fast it moves, m/s
   * @param force3 overwritten, N, along the axes of the base
   */
  public void force(double[] point3, double[] velocity3, double[] force3) {
    if (!pulls) {
      System.arraycopy(push, 0, force3, 0, 3);
      return;
    }
    double squared = 0;
    for (int axis = 0; axis < 3; axis++) {
      double spring = STIFFNESS_N_PER_M * (place[axis] - point3[axis]);
      force3[axis] = spring - DAMPING_N_S_PER_M * velocity3[axis];
      squared += force3[axis] * force3[axis];
    }
    if (squared > MAX_PULL_N * MAX_PULL_N) {
      double share = MAX_PULL_N / Math.sqrt(squared);
      for (int axis = 0; axis < 3; axis++) {
        force3[axis] *= share;
      }
    }
  }
}
