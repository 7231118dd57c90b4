package org.pendant.recording.fit;

import static org.pendant.recording.fit.FitTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Gravity;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.identification.ArmSample;
import org.pendant.recording.compare.Samples;
import org.pendant.recording.compare.StartOfRun;

/**
 * Recorded motion: the columns of recordings that a fit needs. Targets come before what was
 * measured: they have no noise, and the moments and currents of targets belong to them. Rows with
 * another declared payload than the last one are left out, and those in which the drives have no
 * target.
 */
final class RecordedMotion {
  private static final StateQuantity TARGET_Q = StateQuantities.of("target_q");
  private static final StateQuantity TARGET_QD = StateQuantities.of("target_qd");
  private static final StateQuantity TARGET_QDD = StateQuantities.of("target_qdd");
  private static final StateQuantity TARGET_MOMENT = StateQuantities.of("target_torque");
  private static final StateQuantity TARGET_CURRENT = StateQuantities.of("target_current");
  private static final StateQuantity ACTUAL_Q = StateQuantities.of("actual_q");
  private static final StateQuantity ACTUAL_QD = StateQuantities.of("actual_qd");
  private static final StateQuantity PAYLOAD = StateQuantities.of("payload");
  private static final StateQuantity PAYLOAD_COG = StateQuantities.of("payload_cog");
  private static final StateQuantity CURRENT = StateQuantities.of("current");

  /** More rows than these tell nothing new; so many are taken from all over a recording. */
  private static final int MAX_ROWS = 2000;

  private final List<Samples> recordings;
  private final StateQuantity q;
  private final StateQuantity qd;
  private final Optional<StateQuantity> qdd;
  private final List<Row> rows = new ArrayList<>();

  /** A row of a recording. */
  private record Row(Samples of, int row) {
    Joints joints(StateQuantity quantity) {
      return Joints.of(of.values(quantity, row));
    }
  }

  /**
   * @param recordings one or more, with joint speeds
   */
  RecordedMotion(List<Samples> recordings) {
    this.recordings = recordings.stream().map(StartOfRun::withSpeeds).toList();
    boolean targets = all(TARGET_Q) && all(TARGET_QD);
    q = targets ? TARGET_Q : ACTUAL_Q;
    qd = targets ? TARGET_QD : ACTUAL_QD;
    qdd = targets && all(TARGET_QDD) ? Optional.of(TARGET_QDD) : Optional.empty();
    List<Row> usable = new ArrayList<>();
    for (Samples each : this.recordings) {
      for (int row = 0; row < each.rows(); row++) {
        if (hasLastPayload(each, row) && hasTarget(each, row)) {
          usable.add(new Row(each, row));
        }
      }
    }
    int step = 1 + (usable.size() - 1) / MAX_ROWS;
    for (int i = 0; i < usable.size(); i += step) {
      rows.add(usable.get(i));
    }
  }

  /** Whether the declared payload is that of the end; true where it was not recorded. */
  private static boolean hasLastPayload(Samples samples, int row) {
    return Stream.of(PAYLOAD, PAYLOAD_COG)
        .filter(samples::has)
        .allMatch(
            each ->
                Arrays.equals(samples.values(each, row), samples.values(each, samples.rows() - 1)));
  }

  /** Whether the drives had a target: without power, all its moments are 0. */
  private static boolean hasTarget(Samples samples, int row) {
    return !samples.has(TARGET_MOMENT)
        || Arrays.stream(samples.values(TARGET_MOMENT, row)).anyMatch(moment -> moment != 0);
  }

  private boolean all(StateQuantity quantity) {
    return recordings.stream().allMatch(each -> each.has(quantity));
  }

  /** What is missing, as part of a sentence; empty if nothing is. */
  Optional<String> lacks() {
    if (!all(q) || !all(qd)) {
      return Optional.of(text("jointPositions"));
    }
    return current().isPresent() ? Optional.empty() : Optional.of(text("currents"));
  }

  /** Whether the moments of the target were recorded. */
  boolean hasMoments() {
    return q.equals(TARGET_Q) && all(TARGET_MOMENT);
  }

  /** The currents to be explained: of targets if they are there. */
  Optional<StateQuantity> current() {
    if (q.equals(TARGET_Q) && all(TARGET_CURRENT)) {
      return Optional.of(TARGET_CURRENT);
    }
    return all(CURRENT) ? Optional.of(CURRENT) : Optional.empty();
  }

  /** Whether they are what the drives truly took, with friction that holds a resting joint. */
  boolean currentsAreActual() {
    return current().equals(Optional.of(CURRENT));
  }

  /** Motion and recorded moments. */
  List<ArmSample> samples() {
    return rows.stream().map(row -> sample(row, row.joints(TARGET_MOMENT))).toList();
  }

  /** Motion, and the moments that an arm with a payload needs for it. */
  List<ArmSample> samples(ArmDescription arm, Gravity gravity, Payload payload) {
    ArmDynamics dynamics = new ArmDynamics(arm);
    gravity.applyTo(dynamics);
    dynamics.setPayload(payload);
    List<ArmSample> samples = new ArrayList<>();
    double[] torque = new double[Joints.COUNT];
    for (Row row : rows) {
      Joints accelerations = acceleration(row);
      dynamics.inverse(
          row.joints(q).toArray(), row.joints(qd).toArray(), accelerations.toArray(), torque);
      for (int i = 0; i < torque.length; i++) {
        torque[i] += arm.actuators().get(i).rotorInertiaKgM2() * accelerations.get(i);
      }
      samples.add(sample(row, Joints.of(torque)));
    }
    return samples;
  }

  /** The currents of a joint in the same rows, A. */
  double[] currentsA(int joint) {
    StateQuantity current = current().orElseThrow();
    return rows.stream().mapToDouble(row -> row.of.value(current, joint, row.row)).toArray();
  }

  private ArmSample sample(Row row, Joints momentNm) {
    return new ArmSample(row.joints(q), row.joints(qd), acceleration(row), momentNm);
  }

  private Joints acceleration(Row row) {
    return qdd.isPresent() ? row.joints(qdd.get()) : slope(row.of, row.row);
  }

  /** How fast the speeds change between the rows before and behind. */
  private Joints slope(Samples each, int row) {
    int before = Math.max(0, row - 1);
    int after = Math.min(each.rows() - 1, row + 1);
    double timeS = each.timeS(after) - each.timeS(before);
    double[] slopes = new double[Joints.COUNT];
    for (int i = 0; i < slopes.length; i++) {
      slopes[i] = timeS > 0 ? (each.value(qd, i, after) - each.value(qd, i, before)) / timeS : 0;
    }
    return Joints.of(slopes);
  }
}
