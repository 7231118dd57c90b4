package org.pendant.desktop.session;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StopPlace;
import org.pendant.models.pose.Pose;

/**
 * Stop card: everything to know about the stop that keeps the arm at rest.
 *
 * @param title what it is and its code, such as {@code Protective stop C157A2}
 * @param message what happened, as a sentence without numbers
 * @param facts name and value of what was measured
 * @param line of the program that was reached when the stop began, 0 for none
 * @param suggestion what to look at
 */
public record StopCard(
    String title, String message, List<Fact> facts, int line, String suggestion) {
  private static final List<String> JOINTS =
      List.of("base", "shoulder", "elbow", "wrist 1", "wrist 2", "wrist 3");
  private static final MathContext DIGITS = new MathContext(4);

  /** Codes of stops because the arm could not come to rest before a limit any more. */
  private static final Set<Integer> TRAVEL = Set.of(150, 151, 152);

  /** Something measured, or a limit. */
  public record Fact(String name, String value) {}

  /** Copies the list. */
  public StopCard {
    facts = List.copyOf(facts);
  }

  /** The card of the present stop, if there is one. */
  public static Optional<StopCard> of(ControllerState state) {
    return state.safety().stop().map(stop -> of(stop, state.safety().stopPlace()));
  }

  static StopCard of(SafetyStop stop, Optional<StopPlace> place) {
    List<Fact> facts = new ArrayList<>();
    stop.joint()
        .ifPresent(
            joint ->
                facts.add(
                    new Fact(
                        "Joint",
                        joint
                            + ", "
                            + JOINTS.get(joint)
                            + place.map(each -> at(each, joint)).orElse(""))));
    if (!stop.unit().isEmpty()) {
      String found = TRAVEL.contains(stop.code()) ? "It would come to rest at" : "Found";
      facts.add(new Fact(found, measured(stop.value(), stop.unit())));
      facts.add(new Fact("Limit", measured(stop.limit(), stop.unit())));
    }
    String tcp = stop.aboutTarget() ? "TCP in the base, as commanded" : "TCP in the base";
    place.ifPresent(each -> facts.add(new Fact(tcp, text(each.tcpInBase()))));
    facts.add(
        new Fact("Robot time", BigDecimal.valueOf(Math.round(stop.timeS() * 1000), 3) + " s"));
    return new StopCard(
        StateWords.capital(StateWords.of(stop.mode())) + " " + stop.codeText(),
        StateWords.capital(stop.sentence()),
        facts,
        place.map(StopPlace::line).orElse(0),
        suggestion(stop.code()));
  }

  private static String at(StopPlace place, int joint) {
    return String.format(
        Locale.ROOT, ", at %.1f\u00b0", Math.toDegrees(place.positionRad().get(joint)));
  }

  private static String text(Pose tcpInBase) {
    return String.format(
        Locale.ROOT,
        "%.2f, %.2f, %.2f mm",
        1000 * tcpInBase.x(),
        1000 * tcpInBase.y(),
        1000 * tcpInBase.z());
  }

  /** As people read it on screens. */
  private static String measured(double value, String unit) {
    return switch (unit) {
      case "m" -> rounded(1000 * value, "mm");
      case "m/s" -> rounded(1000 * value, "mm/s");
      case "rad" -> rounded(Math.toDegrees(value), "\u00b0");
      case "rad/s" -> rounded(Math.toDegrees(value), "\u00b0/s");
      default -> number(value) + " " + unit;
    };
  }

  private static String rounded(double value, String unit) {
    // Adding 0 takes the sign from a zero.
    double hundredths = Math.round(100 * value) / 100.0 + 0.0;
    return String.format(Locale.ROOT, "%.2f", hundredths)
        + (unit.startsWith("\u00b0") ? "" : " ")
        + unit;
  }

  private static String number(double value) {
    return Double.isFinite(value)
        ? new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString()
        : Double.toString(value);
  }

  /** What may help against a stop or warning with this code, the x of CxAy. */
  public static String suggestion(int code) {
    return switch (code) {
      case 100 -> "Release the safety input; after an emergency stop switch the arm on again.";
      case 150 -> "Move the joint's target away from the end of its range.";
      case 151 -> "Choose a pose in which the tool is tilted less.";
      case 152 -> "Choose a path that stays clear of the safety plane.";
      case 153, 173 ->
          "The arm could not follow: check payload and centre of gravity, or lower the"
              + " acceleration.";
      case 154 -> "Choose a path that stays clear of the singularity, or a joint move past it.";
      case 155 ->
          "Declare what hangs on the flange with set_target_payload, and let go of the tool until"
              + " freedrive has begun.";
      case 157 ->
          "Something was hit, or the declared payload is wrong: look at the path and at"
              + " set_target_payload.";
      case 191 -> "A safety limit was exceeded: lower speed or force, or change the limits.";
      case 192 -> "A sensor reports no number: restart the safety functions.";
      case 200 -> "Choose a goal that the arm reaches.";
      case 204 -> "The target jumps: check servoj, speedj and the poses that the program computes.";
      case 209 -> "The program asked for this stop.";
      default -> "Look at the log for what happened before.";
    };
  }
}
