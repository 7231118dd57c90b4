package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.function.BooleanSupplier;
import java.util.function.IntSupplier;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.Actions;

/** Debugger actions: what people can do about a program that is paused, or is to be paused. */
public final class DebugActions {
  private DebugActions() {}

  /**
   * Adds them to a workbench.
   *
   * @param list where conditions are edited
   * @param caretLine where the caret stands in the program in front, from 1
   */
  public static void addTo(
      Workbench workbench, DebugPresenter debug, BreakpointsView list, IntSupplier caretLine) {
    Actions actions = workbench.actions();
    Stepping steps = debug.steps();
    add(actions, "pause", text("pauseInTheDebugger"), "shift F6", steps::canPause, steps::pause);
    add(actions, "step-over", text("stepOverCalls"), "", steps::canStep, steps::over);
    add(actions, "step-into", text("stepIntoCalls"), "F11", steps::canStep, steps::into);
    add(actions, "step-out", text("stepOutToTheCaller"), "shift F11", steps::canStep, steps::out);
    add(
        actions,
        "run-to-line",
        text("runToTheLineOfThe"),
        "control F10",
        steps::canStep,
        () -> steps.runTo(caretLine.getAsInt()));
    add(
        actions,
        "show-held",
        text("showWhereTheDebuggerHasPaused"),
        "alt F10",
        debug::held,
        debug::showHeld);
    OpenBreakpoints breakpoints = debug.breakpoints();
    add(
        actions,
        "conditional-breakpoint",
        text("breakpointWithACondition"),
        "shift F9",
        () -> true,
        () -> list.editCondition(caretLine.getAsInt()));
    add(
        actions,
        "logpoint",
        text("logpointLogAMessage"),
        "alt F9",
        () -> true,
        () -> list.editMessage(caretLine.getAsInt()));
    add(
        actions,
        "enable-breakpoint",
        text("breakpointAtTheCaretOnOr"),
        "control F9",
        () -> breakpoints.at(caretLine.getAsInt()).isPresent(),
        () ->
            breakpoints
                .at(caretLine.getAsInt())
                .ifPresent(each -> breakpoints.change(each.enabled(!each.enabled()))));
    add(
        actions,
        "remove-breakpoints",
        text("removeAllBreakpoints"),
        "control shift F9",
        () -> !breakpoints.all().isEmpty(),
        breakpoints::removeAll);
    actions.add(
        Action.of(
                "debug.break-on-errors",
                text("stopAtErrors"),
                "",
                () -> breakpoints.setOnErrors(!breakpoints.onErrors()))
            .checked(breakpoints::onErrors));
  }

  private static void add(
      Actions actions,
      String name,
      String title,
      String keys,
      BooleanSupplier enabled,
      Runnable run) {
    actions.add(new Action("debug." + name, title, keys, enabled, run));
  }
}
