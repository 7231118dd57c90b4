package org.pendant.sweep.plan;

import java.util.List;

/**
 * Run settings: what is the same for all variants of a sweep.
 *
 * @param timeLimitS robot time after which a run counts as one that never ends, s
 * @param seed of random numbers and noise, where no parameter says otherwise
 * @param idealArm an arm that is always exactly on target
 * @param measuredNoise sensors that err as those of recorded arms
 * @param startRamp programs begin with a ramp, as on real arms
 * @param variables of the script whose last values are columns of the results
 * @param fixed variables of the script whose poses are places in the cell: they stay where they are
 *     when the base stands elsewhere
 * @param inputs levels from the start, each {@code NAME=LEVEL}
 */
public record RunSettings(
    double timeLimitS,
    long seed,
    boolean idealArm,
    boolean measuredNoise,
    boolean startRamp,
    List<String> variables,
    List<String> fixed,
    List<String> inputs) {
  /** Robot time of a run at most, s: a day. */
  public static final double MAX_TIME_S = 86_400;

  /** Where the plan does not say, s. */
  public static final double STANDARD_TIME_S = 600;

  /** Copies the lists. */
  public RunSettings {
    variables = List.copyOf(variables);
    fixed = List.copyOf(fixed);
    inputs = List.copyOf(inputs);
  }
}
