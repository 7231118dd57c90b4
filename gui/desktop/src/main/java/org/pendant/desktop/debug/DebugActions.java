package org.pendant.desktop.debug;

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
    add(actions, "pause", "Pause in the debugger", "shift F6", steps::canPause, steps::pause);
    add(actions, "step-over", "Step over calls", "", steps::canStep, steps::over);
    add(actions, "step-into", "Step into calls", "F11", steps::canStep, steps::into);
    add(actions, "step-out", "Step out to the caller", "shift F11", steps::canStep, steps::out);
    add(
        actions,
        "run-to-line",
        "Run to the line of the caret",
        "control F10",
        steps::canStep,
        () -> steps.runTo(caretLine.getAsInt()));
    add(
        actions,
        "show-held",
        "Show where the debugger has paused",
        "alt F10",
        debug::held,
        debug::showHeld);
    OpenBreakpoints breakpoints = debug.breakpoints();
    add(
        actions,
        "conditional-breakpoint",
        "Breakpoint with a condition\u2026",
        "shift F9",
        () -> true,
        () -> list.editCondition(caretLine.getAsInt()));
    add(
        actions,
        "logpoint",
        "Logpoint: log a message\u2026",
        "alt F9",
        () -> true,
        () -> list.editMessage(caretLine.getAsInt()));
    add(
        actions,
        "enable-breakpoint",
        "Breakpoint at the caret on or off",
        "control F9",
        () -> breakpoints.at(caretLine.getAsInt()).isPresent(),
        () ->
            breakpoints
                .at(caretLine.getAsInt())
                .ifPresent(each -> breakpoints.change(each.enabled(!each.enabled()))));
    add(
        actions,
        "remove-breakpoints",
        "Remove all breakpoints",
        "control shift F9",
        () -> !breakpoints.all().isEmpty(),
        breakpoints::removeAll);
    actions.add(
        Action.of(
                "debug.break-on-errors",
                "Stop at errors",
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
