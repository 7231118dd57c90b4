package org.pendant.cell;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.ode4j.ode.DContactGeomBuffer;

/**
 * Body contacts: where bodies of a world touch in a step, and with what impulses.
 *
 * <p>Looks only around bodies that are awake, and wakes those that they touch. All orders are those
 * of the descriptions, so that results are the same in every run.
 */
final class BodyContacts {
  /** A place that is this near one of the step before is the same one, squared, m^2. */
  private static final double SAME_PLACE_M2 = 1e-4;

  private static final int MAX_ROUNDS = 30;

  /** Room for places, to begin with. */
  private static final int MIN_PLACES = 16;

  /** Change of speed below which another round is not worth it, m/s. */
  private static final double ACCURACY_M_PER_S = 3e-7;

  private final List<CellBody> bodies;
  private final List<BodyHold> holds;
  private final List<BodyGuide> guides;
  private final NarrowPhase narrowPhase;
  private final DContactGeomBuffer buffer = NarrowPhase.buffer();

  /** Bodies that are awake, in the order in which they were looked at. */
  private final CellBody[] awake;

  private int awakeCount;
  private final boolean[] seen;

  /** Of each body in this step: the middle and the radius of a ball around it, m; and its kind. */
  private final double[] balls;

  private final boolean[] free;
  private final int[] islandOf;

  /** Places of this step; those of the step before, whose impulses this one begins with. */
  private ContactPlace[] places = new ContactPlace[0];

  private int placeCount;
  private ContactPlace[] before = new ContactPlace[0];
  private int beforeCount;

  /** For each two bodies: the first of their places in the step before and one, 0 for none. */
  private final int[] beforeOf;

  BodyContacts(
      List<CellBody> bodies,
      List<BodyHold> holds,
      List<BodyGuide> guides,
      NarrowPhase narrowPhase) {
    this.narrowPhase = narrowPhase;
    this.guides = guides;
    this.bodies = bodies;
    this.holds = holds;
    int size = bodies.size();
    awake = new CellBody[size];
    seen = new boolean[size];
    balls = new double[4 * size];
    free = new boolean[size];
    islandOf = new int[size];
    beforeOf = new int[size * size];
  }

  /** Finds all contacts of bodies that are awake, for a step of {@code stepS}. */
  void find(double stepS) {
    remember();
    awakeCount = 0;
    for (int i = 0; i < awake.length; i++) {
      CellBody body = bodies.get(i);
      body.touched = body.hold != null || body.guide != null;
      body.kinematicTouched = body.hold != null;
      seen[i] = false;
      islandOf[i] = i;
      free[i] = body.free();
      System.arraycopy(body.pose, 9, balls, 4 * i, 3);
      balls[4 * i + 3] = body.present ? body.reachM : Double.NEGATIVE_INFINITY;
      if (body.awake && body.present) {
        awake[awakeCount++] = body;
      }
    }
    for (int i = 0; i < awakeCount; i++) {
      CellBody one = awake[i];
      seen[one.index] = true;
      meetAll(one, stepS);
    }
  }

  /** Looks at all bodies, in one go over plain numbers: most of them are far away. */
  private void meetAll(CellBody one, double stepS) {
    int index = 4 * one.index;
    double x = balls[index];
    double y = balls[index + 1];
    double z = balls[index + 2];
    double reach = balls[index + 3];
    boolean all = free[one.index];
    for (int other = 0, at = 0; other < free.length; other++, at += 4) {
      if (seen[other] || !(all || free[other])) {
        continue;
      }
      double dx = x - balls[at];
      double dy = y - balls[at + 1];
      double dz = z - balls[at + 2];
      double both = reach + balls[at + 3];
      if (both > 0 && dx * dx + dy * dy + dz * dz <= both * both) {
        meet(one, bodies.get(other), stepS);
      }
    }
  }

  /** Bodies that are awake; those woken by {@link #find} too. */
  int awakeCount() {
    return awakeCount;
  }

  /** One of these. */
  CellBody awake(int i) {
    return awake[i];
  }

  /** Finds the impulses, and gives the bodies the speeds that they have after them. */
  void solve(double stepS) {
    for (int i = 0; i < placeCount; i++) {
      beginWithBefore(places[i]);
    }
    for (int i = 0; i < holds.size(); i++) {
      holds.get(i).begin(stepS);
    }
    boolean again = placeCount > 0 || !holds.isEmpty();
    for (int i = 0; i < guides.size(); i++) {
      if (guides.get(i).active()) {
        guides.get(i).begin(stepS);
        again = true;
      }
    }
    for (int i = 0; i < awakeCount; i++) {
      awake[i].stirred = 0;
    }
    for (int round = 0; round < MAX_ROUNDS && again; round++) {
      again = correct(round);
    }
    for (int i = 0; i < holds.size(); i++) {
      holds.get(i).end(stepS);
    }
    for (int i = 0; i < placeCount; i++) {
      ContactPlace place = places[i];
      if (place.second.kinematic()) {
        place.addWrench(stepS);
      }
    }
  }

  /** Corrects all impulses where a body was stirred in this round or the one before it. */
  private boolean correct(int round) {
    boolean again = false;
    for (int i = 0; i < placeCount; i++) {
      ContactPlace place = places[round % 2 == 0 ? i : placeCount - 1 - i];
      if ((place.first.stirred >= round - 1 || place.second.stirred >= round - 1)
          && place.solve() * place.first.inverseMass > ACCURACY_M_PER_S) {
        place.first.stirred = round;
        if (place.second.free()) {
          place.second.stirred = round;
        }
        again = true;
      }
    }
    for (int i = 0; i < holds.size(); i++) {
      BodyHold hold = holds.get(i);
      if (hold.solve() * hold.body.inverseMass > ACCURACY_M_PER_S) {
        hold.body.stirred = round;
        again = true;
      }
    }
    for (int i = 0; i < guides.size(); i++) {
      BodyGuide guide = guides.get(i);
      if (guide.active() && guide.solve() * guide.body.inverseMass > ACCURACY_M_PER_S) {
        guide.body.stirred = round;
        again = true;
      }
    }
    return again;
  }

  /** Puts groups of bodies to sleep that hold one another and have all rested for a while. */
  void sleepAfter(double restS) {
    for (int i = 0; i < awakeCount; i++) {
      CellBody body = awake[i];
      if (body.free() && (body.restS < restS || body.kinematicTouched)) {
        seen[island(body.index)] = false;
      }
    }
    for (int i = 0; i < awakeCount; i++) {
      CellBody body = awake[i];
      if (body.free() && seen[island(body.index)]) {
        body.sleep();
      }
    }
  }

  /** What touched in the latest step, with the force between each two bodies. */
  List<BodyContact> list(double stepS) {
    List<BodyContact> list = new ArrayList<>();
    for (int i = 0; i < placeCount; i++) {
      ContactPlace place = places[i];
      list.add(
          new BodyContact(
              place.first.description.name(),
              place.second.description.name(),
              place.impulse() / stepS));
    }
    return list;
  }

  private void meet(CellBody one, CellBody other, double stepS) {
    CellBody first = one.free() ? one : other;
    CellBody second = one.free() ? other : one;
    if (first.hold != null && first.hold.ignores(second)) {
      return;
    }
    if (second.free() && second.index < first.index) {
      CellBody later = first;
      first = second;
      second = later;
    }
    int earlier = placeCount;
    for (int i = 0; i < first.parts.length; i++) {
      for (int j = 0; j < second.parts.length; j++) {
        meet(first, i, second, j, stepS);
      }
    }
    if (placeCount == earlier) {
      return;
    }
    if (other.free() && !other.awake) {
      other.wake();
      awake[awakeCount++] = other;
    }
    first.touched = true;
    second.touched = true;
    if (second.free()) {
      islandOf[island(second.index)] = island(first.index);
    } else if (second.kinematic() || second.runs()) {
      first.kinematicTouched = true;
    }
  }

  private void meet(CellBody first, int part, CellBody second, int otherPart, double stepS) {
    BodyPart one = first.parts[part];
    BodyPart other = second.parts[otherPart];
    int count = one.apart(other) ? 0 : narrowPhase.find(one, other, buffer);
    for (int i = 0; i < count; i++) {
      if (placeCount == places.length) {
        grow();
      }
      ContactPlace place = places[placeCount++];
      place.set(first, second, buffer.get(i), count, stepS);
      place.parts = part * BodyShape.Compound.MAX_PARTS + otherPart;
    }
  }

  private void grow() {
    places = Arrays.copyOf(places, Math.max(MIN_PLACES, 2 * placeCount));
    for (int i = placeCount; i < places.length; i++) {
      places[i] = new ContactPlace();
    }
  }

  private void remember() {
    for (int i = 0; i < beforeCount; i++) {
      beforeOf[pair(before[i])] = 0;
    }
    ContactPlace[] old = before;
    before = places;
    beforeCount = placeCount;
    places = old;
    placeCount = 0;
    for (int i = beforeCount - 1; i >= 0; i--) {
      beforeOf[pair(before[i])] = i + 1;
    }
  }

  private void beginWithBefore(ContactPlace place) {
    int pair = pair(place);
    ContactPlace nearest = null;
    double least = SAME_PLACE_M2;
    for (int i = beforeOf[pair] - 1; i >= 0 && i < beforeCount && pair(before[i]) == pair; i++) {
      double square = place.squareTo(before[i]);
      if (square < least && place.parts == before[i].parts) {
        least = square;
        nearest = before[i];
      }
    }
    if (nearest != null) {
      place.beginWith(nearest);
    }
  }

  private int pair(ContactPlace place) {
    return place.first.index * awake.length + place.second.index;
  }

  private int island(int body) {
    int root = body;
    while (islandOf[root] != root) {
      root = islandOf[root];
    }
    islandOf[body] = root;
    return root;
  }
}
