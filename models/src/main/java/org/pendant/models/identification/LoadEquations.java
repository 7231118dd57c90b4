package org.pendant.models.identification;

import static org.pendant.models.identification.IdentificationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.ejml.data.DMatrixRMaj;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Gravity;
import org.pendant.models.dynamics.Payload;

/** Load equations: the linear system of {@link LoadFit} for one arm and its samples. */
final class LoadEquations {
  private static final int N = Joints.COUNT;
  private static final int OF_PAYLOAD = 4;
  private static final int ROUNDS = 4;

  /** A joint that is never accelerated by more does not tell its rotor's inertia, rad/s². */
  private static final double MIN_RAD_PER_S2 = 0.2;

  private final ArmDescription arm;
  private final List<ArmSample> samples;
  private final ArmDynamics dynamics;
  private final List<Integer> accelerated = new ArrayList<>();

  LoadEquations(ArmDescription arm, Gravity gravity, List<ArmSample> samples) {
    this.arm = arm;
    this.samples = samples;
    dynamics = new ArmDynamics(arm);
    gravity.applyTo(dynamics);
    for (int i = 0; i < N; i++) {
      int joint = i;
      if (samples.stream()
          .anyMatch(each -> Math.abs(each.accelerationRadPerS2().get(joint)) > MIN_RAD_PER_S2)) {
        accelerated.add(i);
      }
    }
  }

  LoadFit solve(Optional<Payload> given, Payload assumed) {
    if (samples.isEmpty()) {
      return new LoadFit.Refused(text("noSamples"));
    }
    Payload before = given.orElse(assumed);
    int ofPayload = given.isPresent() ? 0 : OF_PAYLOAD;
    DMatrixRMaj system = system(ofPayload);
    double rmsBefore =
        LeastSquares.rms(new DMatrixRMaj(N * samples.size(), 0), new double[0], rest(before, true));
    if (system.numCols == 0) {
      return new LoadFit.Refused(text("hardlyAccelerated"));
    }
    if (!LeastSquares.determined(system)) {
      return new LoadFit.Refused(ofPayload == 0 ? text("hardlyAccelerated") : text("payloadOpen"));
    }
    Payload payload = before;
    double[] unknowns = {};
    DMatrixRMaj measured = system;
    for (int round = 0; round < (ofPayload == 0 ? 1 : ROUNDS); round++) {
      measured = ofPayload == 0 ? rest(payload, false) : rest(extent(payload), false);
      unknowns = LeastSquares.solve(system, measured);
      if (ofPayload > 0) {
        if (unknowns[0] < -LoadFit.MIN_MASS_KG) {
          return new LoadFit.Refused(
              IdentificationTexts.text(
                  "negativePayload", String.format(Locale.ROOT, "%.3f", unknowns[0])));
        }
        payload = payload(unknowns);
      }
    }
    return new LoadFit.Found(
        payload,
        inertias(unknowns, ofPayload),
        rmsBefore,
        LeastSquares.rms(system, unknowns, measured));
  }

  private static Payload payload(double[] unknowns) {
    double m = unknowns[0];
    return m < LoadFit.MIN_MASS_KG
        ? Payload.NONE
        : Payload.of(m, unknowns[1] / m, unknowns[2] / m, unknowns[3] / m);
  }

  private List<OptionalDouble> inertias(double[] unknowns, int first) {
    List<OptionalDouble> inertias = new ArrayList<>();
    for (int i = 0; i < N; i++) {
      int at = accelerated.indexOf(i);
      inertias.add(
          at >= 0 && unknowns[first + at] > 0
              ? OptionalDouble.of(unknowns[first + at])
              : OptionalDouble.empty());
    }
    return inertias;
  }

  /** What unit mass, unit moments and unit inertias need, in columns. */
  private DMatrixRMaj system(int ofPayload) {
    DMatrixRMaj system = new DMatrixRMaj(N * samples.size(), ofPayload + accelerated.size());
    double[] links = torques(Payload.NONE);
    if (ofPayload > 0) {
      double[] mass = torques(Payload.of(1, 0, 0, 0));
      double[][] moments = {
        torques(withoutExtent(1, 0, 0)),
        torques(withoutExtent(0, 1, 0)),
        torques(withoutExtent(0, 0, 1))
      };
      for (int row = 0; row < system.numRows; row++) {
        system.set(row, 0, mass[row] - links[row]);
        for (int axis = 0; axis < moments.length; axis++) {
          system.set(row, 1 + axis, moments[axis][row] - mass[row]);
        }
      }
    }
    for (int sample = 0; sample < samples.size(); sample++) {
      Joints qdd = samples.get(sample).accelerationRadPerS2();
      for (int k = 0; k < accelerated.size(); k++) {
        int joint = accelerated.get(k);
        system.set(N * sample + joint, ofPayload + k, qdd.get(joint));
      }
    }
    return system;
  }

  /** A kilogram at a place, whose inertia about the flange is 0. */
  private static Payload withoutExtent(double x, double y, double z) {
    return new Payload(
        1, x, y, z, -(y * y + z * z), -(x * x + z * z), -(x * x + y * y), x * y, x * z, y * z);
  }

  /** The part of a payload that is not linear: inertia about the flange without any mass. */
  private static Payload extent(Payload payload) {
    double m = payload.massKg();
    double x = payload.cogXM();
    double y = payload.cogYM();
    double z = payload.cogZM();
    return new Payload(
        0,
        0,
        0,
        0,
        m * (y * y + z * z),
        m * (x * x + z * z),
        m * (x * x + y * y),
        -m * x * y,
        -m * x * z,
        -m * y * z);
  }

  /**
   * What links and a payload leave of the moments.
   *
   * @param allRotors whether the description's inertias of all rotors are taken off too, or those
   *     alone that are not looked for
   */
  private DMatrixRMaj rest(Payload payload, boolean allRotors) {
    double[] known = torques(payload);
    DMatrixRMaj rest = new DMatrixRMaj(known.length, 1);
    for (int sample = 0; sample < samples.size(); sample++) {
      for (int i = 0; i < N; i++) {
        double rotor =
            allRotors || !accelerated.contains(i)
                ? arm.actuators().get(i).rotorInertiaKgM2()
                    * samples.get(sample).accelerationRadPerS2().get(i)
                : 0;
        int row = N * sample + i;
        rest.set(row, 0, samples.get(sample).momentNm().get(i) - known[row] - rotor);
      }
    }
    return rest;
  }

  private double[] torques(Payload payload) {
    dynamics.setPayload(payload);
    double[] all = new double[N * samples.size()];
    double[] torque = new double[N];
    for (int sample = 0; sample < samples.size(); sample++) {
      ArmSample each = samples.get(sample);
      dynamics.inverse(
          each.positionRad().toArray(),
          each.speedRadPerS().toArray(),
          each.accelerationRadPerS2().toArray(),
          torque);
      System.arraycopy(torque, 0, all, N * sample, N);
    }
    return all;
  }
}
