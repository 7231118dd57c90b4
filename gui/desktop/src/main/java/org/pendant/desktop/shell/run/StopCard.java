package org.pendant.desktop.shell.run;

import static org.pendant.desktop.shell.run.RunTexts.text;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StopPlace;
import org.pendant.controller.world.Contact;
import org.pendant.desktop.session.NumberedJoints;
import org.pendant.desktop.session.StateWords;
import org.pendant.desktop.session.StopAdvice;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.SentenceUnits;
import org.pendant.kit.text.Messages;

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
      List.of(
          text("ofBase"),
          text("ofShoulder"),
          text("ofElbow"),
          text("ofWrist1"),
          text("ofWrist2"),
          text("ofWrist3"));

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
    return of(state, List.of(), form);
  }

  /**
   * As {@link #of(ControllerState)}.
   *
   * @param touched what the tool touched when the stop began
   */
  static Optional<StopCard> of(ControllerState state, List<Contact> touched, PoseForm form) {
    return state.safety().stop().map(stop -> of(stop, state.safety().stopPlace(), touched, form));
  }

  static StopCard of(
      SafetyStop stop, Optional<StopPlace> place, List<Contact> touched, PoseForm form) {
    List<Fact> facts = new ArrayList<>();
    stop.joint()
        .ifPresent(
            joint ->
                facts.add(
                    new Fact(
                        text("joint"),
                        place
                            .map(
                                each ->
                                    text(
                                        "jointAt",
                                        joint,
                                        JOINTS.get(joint),
                                        form.angle().reading(each.positionRad().get(joint))))
                            .orElseGet(() -> joint + ", " + JOINTS.get(joint)))));
    if (!stop.unit().isEmpty()) {
      String found = TRAVEL.contains(stop.code()) ? text("itWouldComeToRestAt") : text("found");
      facts.add(new Fact(found, SentenceUnits.measured(stop.value(), stop.unit(), form)));
      facts.add(new Fact(text("limit"), SentenceUnits.measured(stop.limit(), stop.unit(), form)));
    }
    for (Contact each : touched) {
      facts.add(
          new Fact(
              text("toolTouches"),
              text("deep", each.object(), form.length().reading(each.depthM()))));
    }
    String tcp = stop.aboutTarget() ? text("tcpInTheBaseAsCommanded") : text("tcpInTheBase");
    place.ifPresent(each -> facts.add(new Fact(tcp, form.place(each.tcpInBase()))));
    facts.add(
        new Fact(text("robotTime"), BigDecimal.valueOf(Math.round(stop.timeS() * 1000), 3) + " s"));
    return new StopCard(
        StateWords.capital(StateWords.of(stop.mode())) + " " + stop.codeText(),
        StateWords.capital(words(Messages.shown(stop.sentence()), form)),
        facts,
        place.map(StopPlace::line).orElse(0),
        withWhatItTouched(touched, StopAdvice.of(stop.code())));
  }

  /** What explains a stop better than the joint that was the first to notice. */
  private static String withWhatItTouched(List<Contact> touched, String advice) {
    if (touched.isEmpty()) {
      return advice;
    }
    String objects = touched.stream().map(Contact::object).collect(Collectors.joining(", "));
    return text("theToolRanInto", objects, advice);
  }

  /** A sentence of the controller with joints by name and numbers in the units of the screens. */
  private static String words(String sentence, PoseForm form) {
    return SentenceUnits.in(NumberedJoints.named(sentence, JOINTS::get), form);
  }
}
