package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.RunTime;
import org.pendant.desktop.session.StateWords;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramState;

/**
 * State changes: what power, brakes and programs did from one snapshot to the next, in the words of
 * the log. Nothing is said of the first one. What the debugger pauses is not told: a user who steps
 * sees it, and would find nothing else in the log.
 */
final class StateChanges {
  private long frame = -1;
  private RobotMode mode = RobotMode.POWER_OFF;
  private ProgramState program = ProgramState.STOPPED;
  private List<ProgramEvent> events = List.of();
  private RunTime time = RunTime.NONE;

  /** What has changed, oldest first; usually nothing. */
  List<String> in(ControllerState state) {
    if (frame < 0 || state.frame() < frame) {
      begin(state);
      return List.of();
    }
    boolean held = state.frame() == frame;
    frame = state.frame();
    if (state.safety().robotMode() == mode
        && state.program().state() == program
        && state.newProgramEvents().isEmpty()) {
      events = held ? events : List.of();
      return List.of();
    }
    List<String> changes = new ArrayList<>();
    robot(state.safety().robotMode(), changes);
    programEvents(state, held ? events : List.of(), changes);
    pause(state, changes);
    events = state.newProgramEvents();
    return changes;
  }

  /** Another controller has been switched on, or stands where this one stood before. */
  private void begin(ControllerState state) {
    frame = state.frame();
    mode = state.safety().robotMode();
    program = state.program().state();
    events = state.newProgramEvents();
    time = program == ProgramState.PAUSED ? RunTime.NONE.paused(state.timeS()) : RunTime.NONE;
  }

  private void robot(RobotMode now, List<String> changes) {
    if (now != mode) {
      changes.add(text("robotModeWas", StateWords.of(now), StateWords.of(mode)));
      mode = now;
    }
  }

  /** Snapshots of a held frame bring its events again. */
  private void programEvents(ControllerState state, List<ProgramEvent> told, List<String> changes) {
    for (ProgramEvent each : state.newProgramEvents()) {
      if (told.contains(each)) {
        continue;
      }
      switch (each) {
        case ProgramEvent.Started started -> {
          time = RunTime.began(state.timeS());
          program = ProgramState.RUNNING;
          changes.add(text("programStarted", started.name()));
        }
        case ProgramEvent.Ended ended -> {
          String how = word(ended.ending());
          changes.add(
              time.known()
                  ? text("programEndedAfter", ended.name(), how, seconds(time.ranS(state.timeS())))
                  : text("programEnded", ended.name(), how));
          program = ProgramState.STOPPED;
        }
        case ProgramEvent.SecondaryFailed failed ->
            changes.add(text("secondaryProgramFailed", failed.name()));
      }
    }
  }

  private static String word(Ending ending) {
    return switch (ending) {
      case Ending.Finished finished -> text("finished");
      case Ending.Halted halted -> text("halted");
      case Ending.Stopped stopped -> text("stopped");
      case Ending.Failed failed -> text("failed");
    };
  }

  private void pause(ControllerState state, List<String> changes) {
    ProgramState now = state.program().state();
    if (now == program) {
      return;
    }
    if (now == ProgramState.PAUSED) {
      time = time.paused(state.timeS());
      changes.add(text("programPaused", state.program().name()));
    } else if (program == ProgramState.PAUSED && now == ProgramState.RUNNING) {
      double pauseS = state.timeS() - time.pauseBeganS();
      time = time.resumed(state.timeS());
      changes.add(text("programResumedAfter", state.program().name(), seconds(pauseS)));
    }
    program = now;
  }

  private static String seconds(double durationS) {
    return String.format(Locale.ROOT, "%.3f s", durationS);
  }
}
