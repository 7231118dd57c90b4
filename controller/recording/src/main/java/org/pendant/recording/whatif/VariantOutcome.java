package org.pendant.recording.whatif;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Variant outcome: what came of a variant.
 *
 * @param end how it ended
 * @param words the same for people, with the reason
 * @param timeS robot time from the moment to the end, s
 * @param cycleS what one cycle takes, s: from the start of the program to its end, or a round of
 *     one that did not end; empty where there is neither
 * @param roundOf the line at which rounds were counted; 0 where the whole program is meant
 * @param torque the highest torque of a joint, as a share of what that can do; empty if no frame
 *     went by
 * @param jointSpeed the highest speed of a joint, as a share of what that can do
 * @param energyJ what the arm took from its supply, J
 * @param way of the tool centre point
 * @param track of the joints, by the frames of the run that it is a variant of
 */
public record VariantOutcome(
    Variant variant,
    End end,
    String words,
    double timeS,
    OptionalDouble cycleS,
    int roundOf,
    Optional<Peak> torque,
    Optional<Peak> jointSpeed,
    double energyJ,
    TcpWay way,
    JointTrack track) {

  /** How a variant ended. */
  public enum End {
    /** The program ran to its end. */
    FINISHED,
    /** A runtime error. */
    FAILED,
    /** A safety function, or the program itself, has stopped the arm for good. */
    STOPPED,
    /** The program would have gone on. */
    LIMIT,
    /** The program asks people something that nobody answered in the run that is repeated. */
    QUESTION,
    /** Speed, load or program were refused. */
    REFUSED
  }
}
