package org.pendant.models.dynamics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Wrench;

class PayloadEstimateTest {
  private static final Payload LOAD = Payload.of(2.5, 0.02, -0.03, 0.12);

  /** Tool down, and tilted from there about both horizontal axes. */
  private static final List<Pose> TILTED =
      List.of(
          new Pose(0.4, 0.1, 0.3, Math.PI, 0, 0),
          new Pose(0.4, 0.1, 0.3, Math.PI - 0.6, 0, 0),
          new Pose(0.4, 0.1, 0.3, Math.PI - 1.2, 0, 0.3),
          new Pose(0.4, 0.1, 0.3, 2.4, 0.9, 0));

  /** What the weight of a load does to the flange, by way of a frame in its centre of gravity. */
  private static Wrench weight(Payload load, Pose flange, double gx, double gy, double gz) {
    Pose rotation = new Pose(0, 0, 0, flange.rx(), flange.ry(), flange.rz());
    Pose cog = Poses.trans(rotation, new Pose(load.cogXM(), load.cogYM(), load.cogZM(), 0, 0, 0));
    double m = load.massKg();
    return new Wrench(-m * gx, -m * gy, -m * gz, 0, 0, 0)
        .seenFrom(new Pose(-cog.x(), -cog.y(), -cog.z(), 0, 0, 0));
  }

  /** A wrench that is constant along the axes of the flange, along those of the base. */
  private static Wrench alongBase(Wrench wrenchInFlange, Pose flange) {
    return wrenchInFlange.seenFrom(
        Poses.inverse(new Pose(0, 0, 0, flange.rx(), flange.ry(), flange.rz())));
  }

  private static Wrench sum(Wrench a, Wrench b) {
    return new Wrench(
        a.fx() + b.fx(),
        a.fy() + b.fy(),
        a.fz() + b.fz(),
        a.mx() + b.mx(),
        a.my() + b.my(),
        a.mz() + b.mz());
  }

  private static List<Wrench> weights(Payload load, List<Pose> flanges) {
    return flanges.stream().map(flange -> weight(load, flange, 0, 0, 9.82)).toList();
  }

  private static PayloadEstimate upright(List<Pose> flanges, List<Wrench> wrenches) {
    return PayloadEstimate.of(flanges, wrenches, 0, 0, 9.82);
  }

  private static Payload found(PayloadEstimate estimate) {
    return assertInstanceOf(PayloadEstimate.Found.class, estimate, estimate::toString).payload();
  }

  private static void near(Payload expected, Payload found, double kg, double m, String what) {
    assertEquals(expected.massKg(), found.massKg(), kg, what);
    assertEquals(expected.cogXM(), found.cogXM(), m, what);
    assertEquals(expected.cogYM(), found.cogYM(), m, what);
    assertEquals(expected.cogZM(), found.cogZM(), m, what);
  }

  private static void refused(String part, PayloadEstimate estimate) {
    String reason = assertInstanceOf(PayloadEstimate.Refused.class, estimate).reason();
    assertTrue(reason.contains(part), reason);
  }

  private static double between(Random random, double low, double high) {
    return low + (high - low) * random.nextDouble();
  }

  /** Orientations all over, each far enough from the others. */
  private static List<Pose> varied(Random random, int count) {
    List<Pose> flanges = new ArrayList<>();
    while (flanges.size() < count) {
      Pose next =
          new Pose(
              between(random, -1, 1),
              between(random, -1, 1),
              between(random, -1, 1),
              between(random, -2, 2),
              between(random, -2, 2),
              between(random, -2, 2));
      if (flanges.stream()
          .allMatch(other -> Poses.rotationAngle(next, other) > Math.PI / (2 * count))) {
        flanges.add(next);
      }
    }
    return flanges;
  }

  @Test
  void exactWeightsGiveMassAndCentreOfGravity() {
    near(LOAD, found(upright(TILTED, weights(LOAD, TILTED))), 1e-9, 1e-9, "four poses");
  }

  @Test
  void anyLoadIsFoundFromAnyVariedPosesWhateverTheMounting() {
    Random random = new Random(7);
    for (int n = 0; n < 1000; n++) {
      Payload load =
          Payload.of(
              between(random, 0.05, 30),
              between(random, -0.5, 0.5),
              between(random, -0.5, 0.5),
              between(random, -0.5, 0.5));
      double gx = between(random, -5, 5);
      double gy = between(random, -5, 5);
      double gz = between(random, 1, 9);
      List<Pose> flanges = varied(random, 4 + n % 5);
      List<Wrench> wrenches =
          flanges.stream().map(flange -> weight(load, flange, gx, gy, gz)).toList();
      PayloadEstimate estimate = PayloadEstimate.of(flanges, wrenches, gx, gy, gz);
      near(load, found(estimate), 1e-8, 1e-8, "case " + n + ": " + load + " at " + flanges);
    }
  }

  @Test
  void whatTheSensorWasZeroedWithDoesNotMatter() {
    // zeroed in the first pose with the load on: it reads 0 there
    Wrench there = weight(LOAD, TILTED.getFirst(), 0, 0, 9.82);
    Pose first = TILTED.getFirst();
    Wrench zero = there.seenFrom(new Pose(0, 0, 0, first.rx(), first.ry(), first.rz()));
    Wrench back =
        new Wrench(-zero.fx(), -zero.fy(), -zero.fz(), -zero.mx(), -zero.my(), -zero.mz());
    List<Wrench> readings = new ArrayList<>();
    for (Pose flange : TILTED) {
      readings.add(sum(weight(LOAD, flange, 0, 0, 9.82), alongBase(back, flange)));
    }
    assertEquals(0, readings.getFirst().fz(), 1e-9);
    near(LOAD, found(upright(TILTED, readings)), 1e-9, 1e-9, "zeroed with the load");
  }

  @Test
  void noiseMovesTheResultLittle() {
    Random random = new Random(11);
    for (int n = 0; n < 200; n++) {
      List<Pose> flanges = varied(random, 12);
      List<Wrench> noisy = new ArrayList<>();
      for (Wrench exact : weights(LOAD, flanges)) {
        double[] error = random.doubles(6, -1, 1).toArray();
        Wrench noise =
            new Wrench(
                0.5 * error[0],
                0.5 * error[1],
                0.5 * error[2],
                0.05 * error[3],
                0.05 * error[4],
                0.05 * error[5]);
        noisy.add(sum(exact, noise));
      }
      near(LOAD, found(upright(flanges, noisy)), 0.1, 0.01, "case " + n);
    }
  }

  @Test
  void anEmptyFlangeIsNoPayload() {
    assertEquals(Payload.NONE, found(upright(TILTED, weights(Payload.of(0, 0, 0, 0), TILTED))));
    assertEquals(Payload.NONE, found(upright(TILTED, weights(Payload.of(0.009, 0, 0, 1), TILTED))));
  }

  @Test
  void tooFewOrUnequalMeasurementsAreRefused() {
    List<Pose> three = TILTED.subList(0, 3);
    refused("there are 3 poses, must be 4 to 500", upright(three, weights(LOAD, three)));
    refused("there are 4 poses and 3 wrenches", upright(TILTED, weights(LOAD, three)));
    refused("there are 0 poses", upright(List.of(), List.of()));
  }

  @Test
  void posesThatAreTurnedTooLittleAreNamed() {
    List<Pose> poses = new ArrayList<>(TILTED);
    // elsewhere, but turned as pose 0 is but for a fifth of a radian
    poses.set(2, new Pose(-0.3, 0.5, 0.1, Math.PI - 0.2, 0, 0));
    refused(
        "poses 0 and 2 are turned against each other by 0.2000 rad, must be at least 0.3927 rad for"
            + " 4 poses",
        upright(poses, weights(LOAD, poses)));
  }

  @Test
  void posesTurnedAboutTheVerticalAloneTellNothing() {
    List<Pose> turned = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      turned.add(new Pose(0, 0, 0, 0, 0, i * 0.9 - 2.5));
    }
    refused("hardly tilt the tool", upright(turned, weights(LOAD, turned)));
  }

  @Test
  void wrenchesOfTheOppositeSignAreRefused() {
    List<Wrench> opposite =
        TILTED.stream().map(flange -> weight(LOAD, flange, 0, 0, -9.82)).toList();
    refused("as a mass of -2.500 kg would", upright(TILTED, opposite));
  }

  @Test
  void withoutGravityNothingHasWeight() {
    refused("no weight", PayloadEstimate.of(TILTED, weights(LOAD, TILTED), 0, 0, 0));
  }
}
