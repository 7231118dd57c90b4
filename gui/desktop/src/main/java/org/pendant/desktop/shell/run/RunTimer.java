package org.pendant.desktop.shell.run;

import java.util.Locale;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/** Run timer: how long the program has run, in robot time. */
final class RunTimer {
  private ProgramState before = ProgramState.STOPPED;
  private double startS;
  private double elapsedS;

  /** Takes a snapshot; returns the time as text. */
  String take(ControllerState state) {
    ProgramState now = state.program().state();
    if (before == ProgramState.STOPPED && now != ProgramState.STOPPED) {
      startS = state.timeS();
    }
    if (state.timeS() < startS) {
      // Another controller.
      startS = state.timeS();
      elapsedS = 0;
    }
    if (now != ProgramState.STOPPED) {
      elapsedS = state.timeS() - startS;
    }
    before = now;
    return text(elapsedS);
  }

  static String text(double seconds) {
    long tenths = Math.round(seconds * 10);
    return String.format(Locale.ROOT, "%d:%02d.%d", tenths / 600, tenths / 10 % 60, tenths % 10);
  }
}
