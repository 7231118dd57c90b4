package org.pendant.testing.remote;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.io.DigitalLevels;

/** Target state: what a target has told of one moment. Quantities have the names of RTDE. */
public final class TargetState {
  /** Time of the target, s. */
  public static final String TIME = "timestamp";

  /** How its program is, see {@link RunState}. */
  public static final String RUN_STATE = "runtime_state";

  /** 7 where the arm has power and may move. */
  public static final String ROBOT_MODE = "robot_mode";

  /** How the safety functions are; older software has {@link #SAFETY_MODE} alone. */
  public static final String SAFETY_STATUS = "safety_status";

  /** How the safety functions are. */
  public static final String SAFETY_MODE = "safety_mode";

  /** Levels of digital inputs, as {@link #OUTPUTS}. */
  public static final String INPUTS = "actual_digital_input_bits";

  /** Levels of digital outputs: 8 standard ones, 8 configurable ones, 2 of the tool. */
  public static final String OUTPUTS = "actual_digital_output_bits";

  /** Where the speed slider is. */
  public static final String SPEED = "target_speed_fraction";

  private static final int BANK_BITS = 8;
  private static final int BANK_MASK = 0xFF;

  private final Map<String, double[]> values;

  /**
   * A state.
   *
   * @param values numbers of each quantity, by its name; no longer changed by the caller
   */
  public TargetState(Map<String, double[]> values) {
    this.values = new HashMap<>(values);
  }

  /** How a program is, by the numbers of RTDE. */
  public enum RunState {
    STOPPING,
    STOPPED,
    PLAYING,
    PAUSING,
    PAUSED,
    RESUMING
  }

  /** All numbers of a quantity; empty where the target does not tell it. */
  public Optional<double[]> numbers(String name) {
    return Optional.ofNullable(values.get(name)).map(double[]::clone);
  }

  /** The only number of a quantity, or {@code otherwise} where the target does not tell it. */
  public double number(String name, double otherwise) {
    double[] numbers = values.get(name);
    return numbers == null ? otherwise : numbers[0];
  }

  /** Time of the target, s. */
  public double timeS() {
    return number(TIME, 0);
  }

  /** How its program is. */
  public RunState runState() {
    int number = (int) number(RUN_STATE, 1);
    RunState[] all = RunState.values();
    return number >= 0 && number < all.length ? all[number] : RunState.STOPPED;
  }

  /** The number of its safety mode, from 1. */
  public int safety() {
    return (int) number(SAFETY_STATUS, number(SAFETY_MODE, 1));
  }

  /** The levels of its digital signals. */
  public DigitalLevels levels() {
    long in = (long) number(INPUTS, 0);
    long out = (long) number(OUTPUTS, 0);
    return new DigitalLevels(
        bank(in, 0), bank(out, 0), bank(in, 1), bank(out, 1), bank(in, 2), bank(out, 2), 0);
  }

  private static int bank(long bits, int which) {
    return (int) (bits >> (which * BANK_BITS)) & BANK_MASK;
  }
}
