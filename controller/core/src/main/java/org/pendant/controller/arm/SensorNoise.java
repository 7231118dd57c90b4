package org.pendant.controller.arm;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.Series;
import org.pendant.models.time.FrameTime;

/**
 * Sensor noise: makes readings of what the sensors of an arm would say exactly. Sizes and steps are
 * those of recorded arms; docs/simulated-arm.md has them. The ripple of speeds and currents is a
 * model: recordings at 25 Hz show how large it is, and not which period it has.
 *
 * <p>Random numbers come from a generator of its own, and a frame always takes as many of them as
 * the state of the joints says, so that a run repeats to the last bit.
 */
final class SensorNoise {
  /** Step of a position reading, rad: 19 bits for a turn. */
  static final double POSITION_STEP_RAD = 2 * Math.PI / (1 << 19);

  /** Step of a speed reading, rad/s. */
  static final double SPEED_STEP_RAD_PER_S = 0x1p-20;

  /** Step of a current reading, A. */
  static final double CURRENT_STEP_A = 0x1p-12;

  /** Step of the accelerometer, m/s²: standard gravity over 512. */
  static final double ACCELERATION_STEP_M_PER_S2 = 9.80665 / 512;

  /** Step of a temperature, K. */
  static final double TEMPERATURE_STEP_K = 1.0 / 16;

  /** Ripple of the speed of each joint in motion, root mean square, rad/s. */
  private static final double[] SPEED_RIPPLE_RAD_PER_S = {
    0.0052, 0.0039, 0.0035, 0.0051, 0.012, 0.0051
  };

  /** The ripple is smaller below this speed, in proportion, rad/s. */
  private static final double FULL_SPEED_RIPPLE_RAD_PER_S = 0.05;

  /** Ripple of the current of a joint of up to {@link #SMALL_JOINT_NM}, root mean square, A. */
  private static final double CURRENT_RIPPLE_A = 0.085;

  /** Larger joints have more ripple, with the root of their largest torque, Nm. */
  private static final double SMALL_JOINT_NM = 56;

  /** The ripple of the current is smaller below this speed, in proportion, rad/s. */
  private static final double FULL_CURRENT_RIPPLE_RAD_PER_S = 0.2;

  /** Turns of the motor for a turn of the joint: the ripple goes with the angle of the motor. */
  private static final double GEAR_RATIO = 101;

  private static final double MOTOR_TURNS_PER_RAD = GEAR_RATIO / (2 * Math.PI);

  /** Amplitude of the periodic part of a ripple of 1: nine tenths of its power. */
  private static final double PERIODIC = Math.sqrt(0.9 * 15 / 8);

  /** Standard deviation of the white part of a ripple of 1. */
  private static final double WHITE = Math.sqrt(0.1);

  /** Standard deviation of a speed reading at the moment of a stop, rad/s. */
  private static final double STOP_RAD_PER_S = 0.00125;

  /** How much of it is left a frame later: e^-3 after 0.3 s. */
  private static final double STOP_SHARE = Math.exp(-FrameTime.FRAME_S / 0.1);

  /** Frames after a stop from which on a speed reads exactly 0: 0.3 s. */
  private static final int SETTLING_FRAMES = (int) FrameTime.framesFor(0.3);

  private static final int FIRST_WRIST = 3;
  private static final int N = Joints.COUNT;

  /**
   * Standard deviations that differ by series.
   *
   * @param positionRad of a position
   * @param armCurrentA of base, shoulder and elbow at rest
   * @param wristCurrentA of the wrists at rest
   * @param forceN of each force
   * @param torqueNm of each torque of the force sensor
   * @param accelerationMPerS2 of each axis of the accelerometer
   */
  private record Sizes(
      double positionRad,
      double armCurrentA,
      double wristCurrentA,
      double forceN,
      double torqueNm,
      double accelerationMPerS2) {
    static final Sizes CB3 = new Sizes(21e-6, 0.019, 0.007, 0.6, 0.135, 0.02);
    static final Sizes E_SERIES = new Sizes(15e-6, 0.028, 0.0095, 0.15, 0.004, 0.054);

    static Sizes of(Series series) {
      return switch (series) {
        case CB3 -> CB3;
        case E_SERIES, UR_SERIES -> E_SERIES;
      };
    }
  }

  private final ReadingNoise noise;
  private final Sizes sizes;
  private final GaussianNoise gaussian;

  /** Of positions with a deviation that was asked for. */
  private final SplittableRandom ownPosition;

  private final double[] constantNmPerA = new double[N];
  private final double[] currentRippleA = new double[N];
  private final double[] phaseTurns = new double[N];
  private final double[] stopRadPerS = new double[N];
  private final int[] stillFrames = new int[N];
  private final double[] periodic = new double[N];
  private final SimulatedSensors readings;

  /**
   * Noise of an arm.
   *
   * @param exact what the sensors would say; they are the readings when there is no noise
   */
  SensorNoise(ArmDescription arm, ReadingNoise noise, long seed, SimulatedSensors exact) {
    this.noise = noise;
    sizes = Sizes.of(arm.series());
    ownPosition = new SplittableRandom(seed);
    gaussian = new GaussianNoise(~seed);
    for (int i = 0; i < N; i++) {
      double larger = Math.max(1, arm.joints().get(i).maxTorqueNm() / SMALL_JOINT_NM);
      currentRippleA[i] = CURRENT_RIPPLE_A * Math.sqrt(larger);
      constantNmPerA[i] = arm.actuators().get(i).torqueConstantNmPerA();
      phaseTurns[i] = gaussian.uniform();
    }
    Arrays.fill(stillFrames, SETTLING_FRAMES);
    readings = errs() ? new SimulatedSensors() : exact;
  }

  /** What the sensors read; the same object always. */
  SimulatedSensors readings() {
    return readings;
  }

  /**
   * Reads the sensors; once a frame.
   *
   * @param exact what they would say exactly
   * @param powered whether the motors have current: noise of brakes is none
   */
  void read(SimulatedSensors exact, boolean powered) {
    if (!errs()) {
      return;
    }
    readings.set(exact);
    readPositions(exact);
    if (!noise.measured()) {
      return;
    }
    for (int i = 0; i < N; i++) {
      periodic[i] =
          exact.speedRadPerS[i] == 0
              ? 0
              : PERIODIC * wave(MOTOR_TURNS_PER_RAD * exact.positionRad[i] + phaseTurns[i]);
      readSpeed(exact, i);
      if (powered) {
        readCurrent(exact, i);
      }
      readings.temperatureC[i] = GaussianNoise.quantized(exact.temperatureC[i], TEMPERATURE_STEP_K);
    }
    readings.toolTemperatureC = GaussianNoise.quantized(exact.toolTemperatureC, TEMPERATURE_STEP_K);
    for (int axis = 0; axis < readings.toolAccelerationMPerS2.length; axis++) {
      readings.toolAccelerationMPerS2[axis] =
          GaussianNoise.quantized(
              exact.toolAccelerationMPerS2[axis] + sizes.accelerationMPerS2() * gaussian.next(),
              ACCELERATION_STEP_M_PER_S2);
    }
    for (int axis = 0; axis < readings.flangeNoise6.length; axis++) {
      double size = axis < 3 ? sizes.forceN() : sizes.torqueNm();
      readings.flangeNoise6[axis] = size * gaussian.next();
    }
  }

  /** Whether readings differ from what the sensors would say exactly. */
  boolean errs() {
    return !noise.equals(ReadingNoise.NONE);
  }

  /** Whether the speeds of an arm that rests read exactly 0. */
  boolean settled() {
    for (int frames : stillFrames) {
      if (frames < SETTLING_FRAMES) {
        return false;
      }
    }
    return true;
  }

  private void readPositions(SimulatedSensors exact) {
    if (noise.positionRad().isPresent()) {
      double deviationRad = noise.positionRad().getAsDouble();
      for (int i = 0; i < N && deviationRad > 0; i++) {
        readings.positionRad[i] += deviationRad * ownPosition.nextGaussian();
      }
    } else {
      for (int i = 0; i < N; i++) {
        readings.positionRad[i] =
            GaussianNoise.quantized(
                exact.positionRad[i] + sizes.positionRad() * gaussian.next(), POSITION_STEP_RAD);
      }
    }
  }

  /** A wave of parabolas between -1 and 1, as good as a sine here at a fraction of its time. */
  private static double wave(double turns) {
    double part = turns - Math.rint(turns);
    return part * (8 - 16 * Math.abs(part));
  }

  private void readSpeed(SimulatedSensors exact, int i) {
    double speed = exact.speedRadPerS[i];
    if (speed != 0) {
      stillFrames[i] = 0;
      stopRadPerS[i] = STOP_RAD_PER_S;
      double share = Math.min(1, Math.abs(speed) / FULL_SPEED_RIPPLE_RAD_PER_S);
      double ripple = share * SPEED_RIPPLE_RAD_PER_S[i] * (periodic[i] + WHITE * gaussian.next());
      readings.speedRadPerS[i] = GaussianNoise.quantized(speed + ripple, SPEED_STEP_RAD_PER_S);
    } else if (stillFrames[i] < SETTLING_FRAMES) {
      stillFrames[i]++;
      stopRadPerS[i] *= STOP_SHARE;
      readings.speedRadPerS[i] =
          GaussianNoise.quantized(stopRadPerS[i] * gaussian.next(), SPEED_STEP_RAD_PER_S);
    }
  }

  /** The torque goes with the current that it is derived from. */
  private void readCurrent(SimulatedSensors exact, int i) {
    double speed = Math.abs(exact.speedRadPerS[i]);
    double ripple = currentRippleA[i] * Math.min(1, speed / FULL_CURRENT_RIPPLE_RAD_PER_S);
    double atRest = i < FIRST_WRIST ? sizes.armCurrentA() : sizes.wristCurrentA();
    double white = Math.sqrt(atRest * atRest + WHITE * WHITE * ripple * ripple);
    double errorA = ripple * periodic[i] + white * gaussian.next();
    double current = GaussianNoise.quantized(exact.currentA[i] + errorA, CURRENT_STEP_A);
    readings.currentA[i] = current;
    readings.torqueNm[i] += constantNmPerA[i] * (current - exact.currentA[i]);
  }
}
