package org.pendant.sweep.run;

import java.util.List;
import org.pendant.sweep.plan.SweepVariant;

/**
 * Result of one run of a sweep. The same variant gives the same result to the last bit, whatever
 * ran before or beside it.
 *
 * @param variant what ran
 * @param outcome how it ended
 * @param reason why, for people; empty where the program ended by itself
 * @param line of the program where it stopped, or the last that it reached; 0 where none ran
 * @param durationS robot time from the start of the program to its end, s
 * @param torque of the drives, Nm
 * @param speed of the joints, rad/s
 * @param current of the motors, A; without shares
 * @param toolSpeedMPerS the highest speed of the tool centre point, m/s
 * @param toolSpeedShare the same as a share of the safety limit
 * @param jointLimitRad how near a joint came to the end of its range, rad
 * @param planeM how near tool or elbow came to a safety plane, m; infinite where there is none
 * @param singularity how near the arm came to a singularity: 0 in it, about 1 far from it
 * @param forceN the largest force from outside at the flange, N
 * @param torqueNm the largest torque from outside at the flange, Nm
 * @param energyJ what the arm took, J
 * @param endTcpInBase where the tool centre point was at the end: x, y, z, m, in the base frame
 * @param lines that the program was in, by their numbers
 * @param outputs changes of digital outputs in their order, the first of them where there are many
 * @param variables the last values of those that the plan names, in its order; empty text where
 *     there is none
 * @param digest of all frames: joints, lines and signals
 */
public record SweepResult(
    SweepVariant variant,
    RunOutcome outcome,
    String reason,
    int line,
    double durationS,
    JointLoads torque,
    JointLoads speed,
    JointLoads current,
    double toolSpeedMPerS,
    double toolSpeedShare,
    double jointLimitRad,
    double planeM,
    double singularity,
    double forceN,
    double torqueNm,
    double energyJ,
    List<Double> endTcpInBase,
    List<LineTime> lines,
    List<OutputChange> outputs,
    List<String> variables,
    long digest) {
  /** Copies the lists. */
  public SweepResult {
    endTcpInBase = List.copyOf(endTcpInBase);
    lines = List.copyOf(lines);
    outputs = List.copyOf(outputs);
    variables = List.copyOf(variables);
  }
}
