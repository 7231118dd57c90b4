package org.pendant.recording.fit;

import static org.pendant.recording.fit.FitTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Confidence;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Gravity;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.identification.ArmSample;
import org.pendant.models.identification.DriveFit;
import org.pendant.models.identification.LoadFit;
import org.pendant.recording.compare.Samples;
import org.pendant.recording.compare.Tracking;

/**
 * Arm fit: the description of an arm with what recordings say of its drives, and what they say of
 * its payload. What they do not tell stays as it was.
 *
 * @param arm the description with the numbers found
 * @param joints what was found of each joint, base first
 * @param load payload and rotor inertias, where moments were recorded and tell them
 * @param payloadFound whether that payload is found, and neither given nor assumed
 * @param notes what people should know, as sentences
 */
public record ArmFit(
    ArmDescription arm,
    List<JointFit> joints,
    Optional<LoadFit.Found> load,
    boolean payloadFound,
    List<String> notes) {

  /**
   * What was found of a joint.
   *
   * @param drive torque constant and friction; empty if the joint hardly turns
   * @param rotorInertiaKgM2 empty if the joint is hardly accelerated or no moments were recorded
   * @param lagS how far it lags behind its target, s; empty if it does not move or has no target
   */
  public record JointFit(
      Optional<DriveFit> drive, OptionalDouble rotorInertiaKgM2, OptionalDouble lagS) {}

  /** Joints are held by dry friction of either sign when they turn more slowly, rad/s. */
  private static final double RESTING_RAD_PER_S = 0.01;

  /** Copies the lists. */
  public ArmFit {
    joints = List.copyOf(joints);
    notes = List.copyOf(notes);
  }

  /** What recordings lack for a fit, as part of a sentence; empty if nothing. */
  public static Optional<String> lacks(List<Samples> recordings) {
    return new RecordedMotion(recordings).lacks();
  }

  /**
   * Fits a description to recordings.
   *
   * @param model the description to begin with
   * @param gravity as the arm is mounted in all recordings
   * @param recordings one or more that lack nothing
   * @param given the payload, if that is known
   * @param assumed the payload that counts where the recordings do not tell it
   */
  public static ArmFit of(
      ArmDescription model,
      Gravity gravity,
      List<Samples> recordings,
      Optional<Payload> given,
      Payload assumed) {
    RecordedMotion motion = new RecordedMotion(recordings);
    List<String> notes = new ArrayList<>();
    Optional<LoadFit.Found> withPayload =
        given.isEmpty() ? load(model, gravity, motion, given, assumed, notes) : Optional.empty();
    Optional<LoadFit.Found> load =
        withPayload.or(
            () -> load(model, gravity, motion, Optional.of(given.orElse(assumed)), assumed, notes));
    if (!motion.hasMoments()) {
      notes.add(text("noMoments"));
    }
    List<Actuator> drives = new ArrayList<>(model.actuators());
    List<OptionalDouble> rotors = new ArrayList<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      OptionalDouble found =
          load.isPresent() ? load.get().rotorInertiaKgM2().get(i) : OptionalDouble.empty();
      rotors.add(found);
      if (found.isPresent()) {
        drives.set(i, withRotor(drives.get(i), found.getAsDouble()));
      }
    }
    Payload payload = load.map(LoadFit.Found::payload).orElse(given.orElse(assumed));
    List<ArmSample> samples =
        motion.hasMoments()
            ? motion.samples()
            : motion.samples(model.withActuators(drives), gravity, payload);
    List<JointFit> joints = new ArrayList<>();
    for (int i = 0; i < Joints.COUNT; i++) {
      Optional<DriveFit> drive = drive(drives.get(i), motion, samples, i);
      OptionalDouble lagS = lagS(recordings, i);
      drives.set(i, drive.map(DriveFit::actuator).orElse(drives.get(i)));
      if (lagS.isPresent()) {
        drives.set(i, withLag(drives.get(i), lagS.getAsDouble(), i, notes));
      }
      joints.add(new JointFit(drive, rotors.get(i), lagS));
    }
    return new ArmFit(model.withActuators(drives), joints, load, withPayload.isPresent(), notes);
  }

  private static Optional<LoadFit.Found> load(
      ArmDescription model,
      Gravity gravity,
      RecordedMotion motion,
      Optional<Payload> given,
      Payload assumed,
      List<String> notes) {
    if (!motion.hasMoments()) {
      return Optional.empty();
    }
    return switch (LoadFit.of(model, gravity, motion.samples(), given, assumed)) {
      case LoadFit.Found found -> Optional.of(found);
      case LoadFit.Refused refused -> {
        notes.add(text(given.isEmpty() ? "payloadNotFound" : "rotorsNotFound", refused.reason()));
        yield Optional.empty();
      }
    };
  }

  private static Optional<DriveFit> drive(
      Actuator model, RecordedMotion motion, List<ArmSample> samples, int joint) {
    double[] currents = motion.currentsA(joint);
    double least = motion.currentsAreActual() ? RESTING_RAD_PER_S : 0;
    int[] rows =
        IntStream.range(0, currents.length)
            .filter(row -> Math.abs(samples.get(row).speedRadPerS().get(joint)) >= least)
            .toArray();
    double[] v = new double[rows.length];
    double[] moments = new double[rows.length];
    double[] chosen = new double[rows.length];
    for (int k = 0; k < rows.length; k++) {
      v[k] = samples.get(rows[k]).speedRadPerS().get(joint);
      moments[k] = samples.get(rows[k]).momentNm().get(joint);
      chosen[k] = currents[rows[k]];
    }
    return DriveFit.of(model, v, moments, chosen);
  }

  /** The mean of all recordings in which a joint moves. */
  private static OptionalDouble lagS(List<Samples> recordings, int joint) {
    return recordings.stream()
        .map(each -> new Tracking(each).lagS(joint))
        .filter(OptionalDouble::isPresent)
        .mapToDouble(OptionalDouble::getAsDouble)
        .average();
  }

  private static Actuator withRotor(Actuator drive, double rotorInertiaKgM2) {
    Actuator.Status status = drive.status();
    return new Actuator(
        rotorInertiaKgM2,
        drive.torqueConstantNmPerA(),
        drive.friction(),
        drive.lagS(),
        new Actuator.Status(Confidence.MEASURED, status.torqueConstant(), status.friction()));
  }

  private static Actuator withLag(Actuator drive, double lagS, int joint, List<String> notes) {
    if (!(lagS >= 0 && lagS <= Actuator.MAX_LAG_S)) {
      notes.add(text("jointLag", joint, 1000 * lagS, 1000 * Actuator.MAX_LAG_S));
      return drive;
    }
    return new Actuator(
        drive.rotorInertiaKgM2(),
        drive.torqueConstantNmPerA(),
        drive.friction(),
        lagS,
        drive.status());
  }
}
