package org.pendant.cell;

import java.util.ArrayList;
import java.util.List;
import org.ode4j.math.DVector3;
import org.ode4j.math.DVector3C;
import org.ode4j.ode.DContact;
import org.ode4j.ode.DContactBuffer;
import org.ode4j.ode.DContactJoint;
import org.ode4j.ode.DJoint;
import org.ode4j.ode.DJointGroup;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeHelper;

/**
 * Body contacts: where bodies of a world touch in a step, and with what forces.
 *
 * <p>Looks only around bodies that are awake, and wakes those that they touch. All orders are those
 * of the descriptions, so that results are the same in every run.
 */
final class BodyContacts {
  /** Places at which two bodies hold each other at most; a box on a table needs four. */
  private static final int MOST_PLACES = 4;

  private final List<RigidBody> bodies;
  private final DWorld world;
  private final DJointGroup joints = OdeHelper.createJointGroup();
  private final DContactBuffer buffer = new DContactBuffer(MOST_PLACES);
  private final ContactTuning tuning = new ContactTuning();

  /** Bodies that are awake, in the order in which they were looked at. */
  private final RigidBody[] awake;

  private final boolean[] seen;
  private final int[] islandOf;
  private final int[] placesOfIsland;
  private final List<Place> places = new ArrayList<>();
  private int awakeCount;
  private int placeCount;
  private int largestIsland;

  /** A place where two bodies touch; used again in later steps. */
  private static final class Place {
    private RigidBody first;
    private RigidBody second;
    private final DVector3 at = new DVector3();
    private final DJoint.DJointFeedback forces = new DJoint.DJointFeedback();
  }

  BodyContacts(DWorld world, List<RigidBody> bodies) {
    this.world = world;
    this.bodies = bodies;
    awake = new RigidBody[bodies.size()];
    seen = new boolean[bodies.size()];
    islandOf = new int[bodies.size()];
    placesOfIsland = new int[bodies.size()];
  }

  /** Finds all contacts of bodies that are awake, for a step of {@code stepS}. */
  void find(double stepS) {
    joints.empty();
    placeCount = 0;
    awakeCount = 0;
    for (int i = 0; i < awake.length; i++) {
      RigidBody body = bodies.get(i);
      body.touched = false;
      seen[i] = false;
      islandOf[i] = i;
      placesOfIsland[i] = 0;
      if (body.awake()) {
        awake[awakeCount++] = body;
      }
    }
    for (int i = 0; i < awakeCount; i++) {
      RigidBody one = awake[i];
      seen[one.index] = true;
      for (int other = 0; other < awake.length; other++) {
        if (!seen[other]) {
          meet(one, bodies.get(other), stepS);
        }
      }
    }
    largestIsland = 0;
    for (int i = 0; i < placeCount; i++) {
      int island = island(places.get(i).first.index);
      largestIsland = Math.max(largestIsland, ++placesOfIsland[island]);
    }
  }

  /** Bodies that are awake; those woken by {@link #find} too. */
  int awakeCount() {
    return awakeCount;
  }

  /** One of these. */
  RigidBody awake(int i) {
    return awake[i];
  }

  /** Places in the largest group of free bodies that hold one another. */
  int largestIsland() {
    return largestIsland;
  }

  /** Adds the forces of the step that was made to the wrenches of bodies that are guided. */
  void readForces() {
    for (int i = 0; i < placeCount; i++) {
      Place place = places.get(i);
      if (place.second.guided()) {
        addForce(place.second, place.at, place.forces.f1);
      }
    }
  }

  /** What touched in the latest step, with the force between each two bodies. */
  List<BodyContact> list() {
    List<BodyContact> list = new ArrayList<>();
    for (int i = 0; i < placeCount; i++) {
      Place place = places.get(i);
      list.add(
          new BodyContact(
              place.first.description.name(),
              place.second.description.name(),
              place.forces.f1.length()));
    }
    return list;
  }

  private void meet(RigidBody one, RigidBody other, double stepS) {
    RigidBody first = one.free() ? one : other;
    RigidBody second = one.free() ? other : one;
    if (!first.free() || first.geom.getAABB().isDisjoint(second.geom.getAABB())) {
      return;
    }
    int count = OdeHelper.collide(first.geom, second.geom, MOST_PLACES, buffer.getGeomBuffer());
    if (count == 0) {
      return;
    }
    if (other.free() && !other.awake()) {
      other.body.enable();
      awake[awakeCount++] = other;
    }
    first.touched = true;
    second.touched = true;
    if (second.free()) {
      islandOf[island(second.index)] = island(first.index);
    } else if (second.guided()) {
      first.body.setAutoDisableFlag(false);
    }
    for (int i = 0; i < count; i++) {
      add(buffer.get(i), first, second, count, stepS);
    }
  }

  private void add(DContact contact, RigidBody first, RigidBody second, int count, double stepS) {
    tuning.set(contact, first, second, count, stepS);
    DContactJoint joint = OdeHelper.createContactJoint(world, joints, contact);
    if (placeCount == places.size()) {
      places.add(new Place());
    }
    Place place = places.get(placeCount++);
    place.first = first;
    place.second = second;
    place.at.set(contact.geom.pos);
    place.forces.f1.setZero();
    joint.setFeedback(place.forces);
    joint.attach(first.body, second.body);
  }

  private int island(int body) {
    int root = body;
    while (islandOf[root] != root) {
      root = islandOf[root];
    }
    islandOf[body] = root;
    return root;
  }

  /** Adds what answers the force {@code onOther}, N, which acts at {@code at}. */
  private static void addForce(RigidBody body, DVector3C at, DVector3C onOther) {
    DVector3C origin = body.body.getPosition();
    double fx = -onOther.get0();
    double fy = -onOther.get1();
    double fz = -onOther.get2();
    double x = at.get0() - origin.get0();
    double y = at.get1() - origin.get1();
    double z = at.get2() - origin.get2();
    double[] wrench = body.wrench;
    wrench[0] += fx;
    wrench[1] += fy;
    wrench[2] += fz;
    wrench[3] += y * fz - z * fy;
    wrench[4] += z * fx - x * fz;
    wrench[5] += x * fy - y * fx;
  }
}
