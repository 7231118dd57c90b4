package org.pendant.cell;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.ode4j.ode.DContactGeomBuffer;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Transforms;

/**
 * Rigid body world: bodies that fall, collide, slide, stack and press, in steps of fixed length.
 *
 * <p>The same descriptions and the same calls give the same bits in every run, whatever other
 * worlds do meanwhile. Bodies at rest for half a second sleep and cost next to nothing; what
 * touches them wakes them.
 *
 * <p>Belongs to one thread at a time.
 */
public final class RigidBodyWorld {
  /** Most bodies. */
  public static final int MAX_BODIES = 220;

  /** So many more may be added. */
  private static final int MAX_MORE = 300;

  /** What a step may take. */
  private static final Range STEP = new Range(1e-5, 0.01, "s");

  /** How gravity may be along each axis: that of any planet people work on, and none. */
  private static final Range GRAVITY = new Range(-30, 30, "m/s^2");

  /** Bodies may be this deep in one another at first, m. */
  private static final double MAX_OVERLAP_M = 1e-3;

  /** What has not moved for so long sleeps, s. */
  private static final double REST_TIME_S = 0.5;

  private final List<CellBody> bodies = new ArrayList<>();
  private final List<BodyHold> holds = new ArrayList<>();
  private final List<BodyGuide> guides = new ArrayList<>();
  private final BodyRay ray = new BodyRay();
  private final NarrowPhase narrowPhase = new NarrowPhase();
  private BodyContacts contacts;
  private final double[] gravity = new double[3];
  private double latestStepS = 1;
  private long changes;

  /**
   * Sets bodies up.
   *
   * @param gravityX gravity in the base's frame, m/s^2, which may be mounted at any angle
   * @param gravityY the same along y
   * @param gravityZ the same along z; -9.82 where the base stands upright
   * @throws IllegalArgumentException if there are more than {@link #MAX_BODIES}, two of one name,
   *     or free ones that overlap others that are not kinematic by more than 1 mm
   */
  public RigidBodyWorld(
      List<BodyDescription> descriptions, double gravityX, double gravityY, double gravityZ) {
    if (descriptions.size() > MAX_BODIES) {
      throw new IllegalArgumentException(
          "bodies: are " + descriptions.size() + ", may be at most " + MAX_BODIES);
    }
    setGravity(gravityX, gravityY, gravityZ);
    Set<String> names = new HashSet<>();
    for (BodyDescription description : descriptions) {
      if (!names.add(description.name())) {
        throw new IllegalArgumentException("bodies: " + description.name() + " is there twice");
      }
      bodies.add(new CellBody(description, bodies.size()));
    }
    requireApart();
    contacts = new BodyContacts(bodies, holds, guides, narrowPhase);
  }

  /**
   * Adds a body: one more tool, or one that is {@link #setPresent put away} until it is needed.
   *
   * @return its number
   * @throws IllegalArgumentException if there are too many, or one has its name
   */
  public int add(BodyDescription description) {
    if (bodies.size() >= MAX_BODIES + MAX_MORE) {
      throw new IllegalArgumentException("bodies: may be at most " + (MAX_BODIES + MAX_MORE));
    }
    for (CellBody body : bodies) {
      if (body.description.name().equals(description.name())) {
        throw new IllegalArgumentException("bodies: " + description.name() + " is there twice");
      }
    }
    bodies.add(new CellBody(description, bodies.size()));
    contacts = new BodyContacts(bodies, holds, guides, narrowPhase);
    return bodies.size() - 1;
  }

  /** Puts a body away, or back where it was: what is away touches nothing. */
  public void setPresent(int body, boolean present) {
    CellBody of = bodies.get(body);
    of.present = present;
    Arrays.fill(of.wrench, 0);
    changes++;
    if (of.free() && present) {
      of.wake();
    } else if (of.free()) {
      of.sleep();
    }
  }

  /** Whether a body is there. */
  public boolean present(int body) {
    return bodies.get(body).present;
  }

  /**
   * Puts a body that is away back where it was at first, unless another one is in the way.
   *
   * @return whether it is there
   */
  public boolean putBack(int body) {
    CellBody of = bodies.get(body);
    of.putBack();
    for (CellBody other : bodies) {
      if (other != of && other.present && overlap(of, other)) {
        return false;
      }
    }
    setPresent(body, true);
    return true;
  }

  /**
   * Has the surface of a fixed body run along itself, as that of a belt does; what lies on it is
   * taken along by friction.
   *
   * @param x m/s along the base's x, as the others; what is at right angles to a face does nothing
   *     there
   */
  public void runSurface(int body, double x, double y, double z) {
    CellBody of = bodies.get(body);
    if (of.description.motion() != BodyMotion.FIXED) {
      throw new IllegalArgumentException(of.description.name() + ": is not fixed");
    }
    of.belt[0] = x;
    of.belt[1] = y;
    of.belt[2] = z;
    for (CellBody other : bodies) {
      if (other.free() && other.present && other.near(of)) {
        other.wake();
      }
    }
  }

  private boolean overlap(CellBody one, CellBody other) {
    return one.near(other) && narrowPhase.depthM(one, other, NarrowPhase.buffer()) > MAX_OVERLAP_M;
  }

  /**
   * Holds a free body as it is now. It passes through some bodies meanwhile.
   *
   * @param frame12 what carries it, in the base frame; {@link BodyHold#move} says where it goes
   * @param untouched numbers of the bodies that it passes through
   * @throws IllegalArgumentException if it is not free, or is held
   */
  public BodyHold hold(int body, double[] frame12, HoldLimits limits, int... untouched) {
    CellBody of = bodies.get(body);
    if (!of.free() || of.hold != null) {
      throw new IllegalArgumentException(of.description.name() + ": is not free, or held already");
    }
    of.hold = new BodyHold(of, frame12, limits, untouched);
    holds.add(of.hold);
    of.wake();
    return of.hold;
  }

  /** Lets a body go. */
  public void release(BodyHold hold) {
    if (holds.remove(hold)) {
      hold.body.hold = null;
      hold.body.wake();
    }
  }

  /**
   * Puts a free body on a rail, which begins where the body is.
   *
   * @throws IllegalArgumentException if it is not free, or is guided
   */
  public BodyGuide rail(int body, BodyRail.Line line) {
    return guide(new BodyRail(unguided(body), line));
  }

  /**
   * Puts a free body on a hinge, which begins as the body is turned.
   *
   * @throws IllegalArgumentException if it is not free, or is guided
   */
  public BodyGuide hinge(int body, BodyHinge.Axis axis) {
    return guide(new BodyHinge(unguided(body), axis));
  }

  private CellBody unguided(int body) {
    CellBody of = bodies.get(body);
    if (!of.free() || of.guide != null) {
      throw new IllegalArgumentException(
          of.description.name() + ": is not free, or guided already");
    }
    return of;
  }

  private BodyGuide guide(BodyGuide guide) {
    guide.body.guide = guide;
    guides.add(guide);
    guide.body.wake();
    return guide;
  }

  /** Takes a body off what guides it. */
  public void unguide(BodyGuide guide) {
    if (guides.remove(guide)) {
      guide.body.guide = null;
      guide.body.wake();
    }
  }

  /** Whether something holds a body. */
  public boolean held(int body) {
    return bodies.get(body).hold != null;
  }

  /**
   * How far a ray goes until it enters a body.
   *
   * @param from3 where it begins, in the base frame, m
   * @param along3 its direction, of length 1
   * @param lengthM how far it goes at most
   * @return m; infinite where it does not meet it, or begins inside
   */
  public double enters(int body, double[] from3, double[] along3, double lengthM) {
    CellBody of = bodies.get(body);
    if (!of.present) {
      return Double.POSITIVE_INFINITY;
    }
    double least = Double.POSITIVE_INFINITY;
    for (BodyPart part : of.parts) {
      double way =
          part.hull()
              ? part.solid().enters(from3, along3, lengthM)
              : ray.enters(part.geom, from3, along3, lengthM);
      least = Math.min(least, way);
    }
    return least;
  }

  /** Whether a body may be as near as that to a place of the base frame: its bounds are. */
  public boolean near(int body, double x, double y, double z, double withinM) {
    CellBody of = bodies.get(body);
    if (of.present) {
      for (BodyPart part : of.parts) {
        if (BodyRay.near(part.geom, x, y, z, withinM)) {
          return true;
        }
      }
    }
    return false;
  }

  /** Sets gravity, m/s^2, each -30 to 30, along the base's axes; another one wakes all bodies. */
  public void setGravity(double x, double y, double z) {
    GRAVITY.require("gravity[0]", x);
    GRAVITY.require("gravity[1]", y);
    GRAVITY.require("gravity[2]", z);
    if (x == gravity[0] && y == gravity[1] && z == gravity[2]) {
      return;
    }
    gravity[0] = x;
    gravity[1] = y;
    gravity[2] = z;
    for (CellBody body : bodies) {
      if (body.free()) {
        body.wake();
      }
    }
  }

  /**
   * Watches whether a free body is within a ball that is swept along a line.
   *
   * @param from3 one end, in the base frame, m
   * @param to3 the other; the same one for a ball
   */
  public BodyProbe watchLine(double[] from3, double[] to3, double radiusM) {
    return new BodyProbe(
        PhysicsLibrary.line(from3, to3, radiusM),
        HullProbe.line(from3, to3, radiusM),
        bodies,
        () -> changes);
  }

  /** Watches whether a free body is within a box along the axes of the base, m. */
  public BodyProbe watchBox(double[] min3, double[] max3) {
    return new BodyProbe(
        PhysicsLibrary.block(min3, max3), HullProbe.block(min3, max3), bodies, () -> changes);
  }

  /** How many bodies there are; they are numbered from 0 in the order of their descriptions. */
  public int size() {
    return bodies.size();
  }

  /** What a body was at first. */
  public BodyDescription description(int body) {
    return bodies.get(body).description;
  }

  /**
   * Lets time go on.
   *
   * @param stepS how long, s, 0.00001 to 0.01
   */
  public void advance(double stepS) {
    STEP.require("step", stepS);
    latestStepS = stepS;
    contacts.find(stepS);
    int count = contacts.awakeCount();
    changes++;
    for (int i = 0; i < count; i++) {
      CellBody body = contacts.awake(i);
      if (body.free()) {
        body.fall(gravity, stepS);
      } else {
        Arrays.fill(body.wrench, 0);
      }
    }
    contacts.solve(stepS);
    for (int i = 0; i < count; i++) {
      contacts.awake(i).move(stepS);
    }
    contacts.sleepAfter(REST_TIME_S);
  }

  /** Where a body is, as {@link Transforms} has it, in the base frame. */
  public void pose(int body, double[] transform) {
    System.arraycopy(bodies.get(body).pose, 0, transform, 0, Transforms.SIZE);
  }

  /** How a body moves: m/s of its origin and rad/s, along the base's axes, six numbers. */
  public void velocity(int body, double[] twist) {
    System.arraycopy(bodies.get(body).twist, 0, twist, 0, 6);
  }

  /** Whether a body rests, and nothing is reckoned of it. */
  public boolean sleeping(int body) {
    return !bodies.get(body).awake;
  }

  /**
   * Says where a kinematic body is and how it moves; it goes on so until told otherwise.
   *
   * @param transform its pose in the base frame at the beginning of the next step
   * @param twist m/s of its origin and rad/s, along the base's axes
   * @throws IllegalArgumentException if it is not kinematic
   */
  public void moveKinematic(int body, double[] transform, double[] twist) {
    CellBody of = bodies.get(body);
    if (!of.kinematic()) {
      throw new IllegalArgumentException(of.description.name() + ": is not kinematic");
    }
    System.arraycopy(transform, 0, of.pose, 0, Transforms.SIZE);
    System.arraycopy(twist, 0, of.twist, 0, 6);
    of.moved();
  }

  /** Gives a free body a speed: m/s of its origin and rad/s, along the base's axes. */
  public void throwBody(int body, double[] twist) {
    CellBody of = bodies.get(body);
    if (!of.free()) {
      throw new IllegalArgumentException(of.description.name() + ": is not free");
    }
    System.arraycopy(twist, 0, of.twist, 0, 6);
    of.wake();
  }

  /**
   * What contacts did to a kinematic body in the latest step.
   *
   * @param wrench overwritten with force, N, and torque about its origin, Nm, along the base's axes
   */
  public void wrench(int body, double[] wrench) {
    System.arraycopy(bodies.get(body).wrench, 0, wrench, 0, 6);
  }

  /** Where bodies that are awake touched in the latest step. */
  public List<BodyContact> contacts() {
    return contacts.list(latestStepS);
  }

  private void requireApart() {
    DContactGeomBuffer found = NarrowPhase.buffer();
    for (CellBody one : bodies) {
      for (CellBody other : bodies) {
        if (one.free()
            && !other.kinematic()
            && (!other.free() || other.index > one.index)
            && !one.farFrom(other)) {
          double depthM = narrowPhase.depthM(one, other, found);
          if (depthM > MAX_OVERLAP_M) {
            throw new IllegalArgumentException(
                "bodies: %s and %s overlap by %s mm"
                    .formatted(
                        one.description.name(),
                        other.description.name(),
                        Range.number(Math.rint(depthM * 1e4) / 10)));
          }
        }
      }
    }
  }
}
