package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.util.function.Supplier;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;

/** Past actions: what people can do by key to go back and on through what a program did. */
public final class PastActions {
  private PastActions() {}

  /** Adds them. */
  public static void addTo(ActionTable actions, PastSteps steps) {
    add(actions, "step-back", text("stepBack"), "control F11", steps::whyNoBack, steps::stepBack);
    add(
        actions,
        "reverse-continue",
        text("reverseContinueToTheBreakpointBefore"),
        "alt F5",
        steps::whyNoBack,
        steps::breakpointBefore);
    add(
        actions,
        "step-on",
        text("nextStatementOfTheRecording"),
        "control shift F11",
        steps::whyNoOn,
        steps::stepOn);
    add(
        actions,
        "continue",
        text("nextBreakpointOfTheRecording"),
        "alt shift F5",
        steps::whyNoOn,
        steps::breakpointAfter);
    add(
        actions,
        "change-before",
        text("lastChangeOfTheSelectedVariable"),
        "control F8",
        steps::whyNoChange,
        steps::changeBefore);
    add(
        actions,
        "change-after",
        text("nextChangeOfTheSelectedVariable"),
        "control shift F8",
        () -> steps.back() ? steps.whyNoChange() : steps.whyNoOn(),
        steps::changeAfter);
  }

  private static void add(
      ActionTable actions,
      String name,
      String title,
      String keys,
      Supplier<String> whyNot,
      Runnable run) {
    actions.add(new Action("past." + name, title, keys, () -> whyNot.get().isEmpty(), run), whyNot);
  }
}
