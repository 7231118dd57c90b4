package org.pendant.controller.safety;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.world.LinkHit;

/**
 * Safety stop: why the arm was stopped.
 *
 * @param mode the safety mode while the stop lasts
 * @param category how the arm is stopped
 * @param code of the error, the x of CxAy
 * @param argument of the error, the y of CxAy
 * @param joint the joint that it is about, 0 to 5, if it is about one
 * @param timeS controller time of the frame in which it happened, s
 * @param value what was found; 0 where nothing was measured
 * @param limit what would have been right at most (or at least, for a lower limit); 0 where nothing
 *     was measured
 * @param unit of value and limit; empty where nothing was measured
 * @param message all of it as a sentence
 */
public record SafetyStop(
    SafetyMode mode,
    StopCategory category,
    int code,
    int argument,
    OptionalInt joint,
    double timeS,
    double value,
    double limit,
    String unit,
    String message) {
  private static final int JOINT_BEYOND = 0;
  private static final int PLANE_EXCEEDED = 8;
  private static final int TOOL_TILTED = 9;

  /** What happened, without code, time and what was measured. */
  public String sentence() {
    String sentence = message.substring(message.indexOf(": ") + 2);
    return unit.isEmpty() ? sentence : sentence.substring(0, sentence.lastIndexOf(": "));
  }

  /** Whether it is about where the arm should go, and not about where it is. */
  public boolean aboutTarget() {
    return switch (code) {
      case 150, 151, 152, 154, 200, 204 -> true;
      default -> false;
    };
  }

  /** The name of the safety plane that it is about, if it is about one. */
  public Optional<String> plane() {
    boolean about =
        is(StopReason.PLANE_NEAR.code(), argument) || is(StopReason.PLANE.code(), PLANE_EXCEEDED);
    return about
        ? Optional.of(message.substring(message.indexOf('"') + 1, message.lastIndexOf('"')))
        : Optional.empty();
  }

  /** The links of the arm that have hit something, as they are called; of two of its own both. */
  public List<String> hitLinks() {
    String sentence = sentence();
    int end = sentence.indexOf(LinkHit.HAS_HIT);
    if (code != StopReason.LINK_HIT.code() || end < 0) {
      return List.of();
    }
    String link = sentence.substring(LinkHit.THE.length(), end);
    String other = sentence.substring(end + LinkHit.HAS_HIT.length());
    return other.startsWith(LinkHit.THE) && !other.contains(LinkHit.OF)
        ? List.of(link, other.substring(LinkHit.THE.length()))
        : List.of(link);
  }

  /** The link of another arm that a link has hit, as it is called; empty if it is none of that. */
  public Optional<String> hitLinkOf(String arm) {
    String sentence = sentence();
    String other = LinkHit.HAS_HIT + LinkHit.THE;
    int begin = sentence.lastIndexOf(other);
    return code == StopReason.LINK_HIT.code() && begin > 0 && sentence.endsWith(LinkHit.OF + arm)
        ? Optional.of(
            sentence.substring(
                begin + other.length(), sentence.length() - LinkHit.OF.length() - arm.length()))
        : Optional.empty();
  }

  /** Whether it is about the direction of the tool. */
  public boolean aboutToolDirection() {
    return is(StopReason.TOOL_DIRECTION_NEAR.code(), 0)
        || is(StopReason.TOOL_DIRECTION.code(), TOOL_TILTED);
  }

  /** The joint whose range it is about, 0 to 5, if it is about one. */
  public OptionalInt jointAtItsLimit() {
    return is(StopReason.JOINT_LIMIT_NEAR.code(), argument)
            || is(StopReason.JOINT_POSITION.code(), JOINT_BEYOND)
        ? joint
        : OptionalInt.empty();
  }

  private boolean is(int wantedCode, int wantedArgument) {
    return code == wantedCode && argument == wantedArgument;
  }

  /** Code and argument as the log shows them, such as {@code C153A2}. */
  public String codeText() {
    return "C" + code + "A" + argument;
  }
}
