package org.pendant.desktop.shell.run;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StopPlace;
import org.pendant.desktop.session.StateWords;
import org.pendant.desktop.session.StopAdvice;
import org.pendant.desktop.unit.PoseForm;

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
    return of(state, PoseForm.STANDARD);
  }

  /** As {@link #of(ControllerState)}, with numbers in the units that people have chosen. */
  public static Optional<StopCard> of(ControllerState state, PoseForm form) {
    return state.safety().stop().map(stop -> of(stop, state.safety().stopPlace(), form));
  }

  static StopCard of(SafetyStop stop, Optional<StopPlace> place, PoseForm form) {
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
                            + place.map(each -> at(each, joint, form)).orElse(""))));
    if (!stop.unit().isEmpty()) {
      String found = TRAVEL.contains(stop.code()) ? "It would come to rest at" : "Found";
      facts.add(new Fact(found, measured(stop.value(), stop.unit(), form)));
      facts.add(new Fact("Limit", measured(stop.limit(), stop.unit(), form)));
    }
    String tcp = stop.aboutTarget() ? "TCP in the base, as commanded" : "TCP in the base";
    place.ifPresent(each -> facts.add(new Fact(tcp, form.place(each.tcpInBase()))));
    facts.add(
        new Fact("Robot time", BigDecimal.valueOf(Math.round(stop.timeS() * 1000), 3) + " s"));
    return new StopCard(
        StateWords.capital(StateWords.of(stop.mode())) + " " + stop.codeText(),
        StateWords.capital(stop.sentence()),
        facts,
        place.map(StopPlace::line).orElse(0),
        StopAdvice.of(stop.code()));
  }

  private static String at(StopPlace place, int joint, PoseForm form) {
    return ", at " + form.angle().reading(place.positionRad().get(joint));
  }

  /** As people read it on screens. */
  private static String measured(double value, String unit, PoseForm form) {
    return switch (unit) {
      case "m" -> form.length().reading(value);
      case "m/s" -> form.length().reading(value) + "/s";
      case "rad" -> form.angle().reading(value);
      case "rad/s" -> form.angle().reading(value) + "/s";
      default -> number(value) + " " + unit;
    };
  }

  private static String number(double value) {
    return Double.isFinite(value)
        ? new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString()
        : Double.toString(value);
  }
}
