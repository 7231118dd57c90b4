package org.pendant.desktop.shell.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.RunTime;
import org.pendant.desktop.session.StateWords;
import org.pendant.language.source.ByteText;
import org.pendant.models.pose.Pose;
import org.pendant.script.debug.DebugState;
import org.pendant.script.vm.Ending;

/**
 * Run facts: what the Run screen says about a snapshot, in words.
 *
 * @param title the program that runs, or that will
 * @param state of the program, or how the last one ended
 * @param failed whether that was by an error
 * @param elapsed how long the program has run without its pauses; empty where nobody knows
 * @param paused how long the pauses took; empty for less than a second
 * @param line number of the line that was reached and its text; empty when no program runs
 * @param waiting how many popups and questions are open; empty for none
 * @param tcp position (mm) and rotation vector (rad) of the TCP in the base, six texts
 * @param joints joint positions in degrees, six texts
 */
record RunFacts(
    String title,
    String state,
    boolean failed,
    String elapsed,
    String paused,
    String line,
    String waiting,
    List<String> tcp,
    List<String> joints) {
  /** Names of the joints, base first. */
  static final List<String> JOINTS =
      List.of("Base", "Shoulder", "Elbow", "Wrist 1", "Wrist 2", "Wrist 3");

  /** Names of a pose's components. */
  static final List<String> POSE = List.of("x", "y", "z", "rx", "ry", "rz");

  RunFacts {
    tcp = List.copyOf(tcp);
    joints = List.copyOf(joints);
  }

  /**
   * The facts of a snapshot.
   *
   * @param run the program that runs in it, or ran last
   */
  static RunFacts of(ControllerState state, RunProgram run) {
    ProgramStatus program = state.program();
    boolean left = run.left(state);
    RunTime time = left ? RunTime.NONE : run.time();
    int line = program.line();
    return new RunFacts(
        title(state, run),
        stateText(state, run),
        program.failed() && !left,
        time.known() ? clock(time.ranS(state.timeS())) : "",
        pausedText(time.pausedS(state.timeS())),
        line(run.shownLine(line), line == 0 ? "" : run.lineText(line)),
        waiting(state.openPopups().size(), state.openQuestions().size()),
        pose(state.arm().actualTcpInBase()),
        joints(state));
  }

  private static String title(ControllerState state, RunProgram run) {
    boolean stopped = ProgramPhase.of(state) == ProgramPhase.STOPPED;
    return run.next().filter(next -> stopped).map("Will run: "::concat).orElse(run.name(state));
  }

  private static String pausedText(double pausedS) {
    if (pausedS < 1) {
      return "";
    }
    return pausedS < 60
        ? String.format(Locale.ROOT, "paused %d s", (int) pausedS)
        : "paused " + clock(pausedS);
  }

  static String clock(double seconds) {
    long tenths = Math.round(seconds * 10);
    return String.format(Locale.ROOT, "%d:%02d.%d", tenths / 600, tenths / 10 % 60, tenths % 10);
  }

  private static String line(int line, String text) {
    if (line == 0) {
      return "";
    }
    return text.isBlank()
        ? "Line " + line
        : "Line " + line + ":  " + ByteText.decoded(text.strip());
  }

  private static String waiting(int popups, int questions) {
    String open =
        Stream.of(counted(popups, "popup"), counted(questions, "question"))
            .filter(each -> !each.isEmpty())
            .collect(Collectors.joining(" and "));
    return open.isEmpty() ? "" : StateWords.capital(open) + " open";
  }

  private static String counted(int count, String word) {
    return switch (count) {
      case 0 -> "";
      case 1 -> "a " + word;
      default -> count + " " + word + "s";
    };
  }

  private static String stateText(ControllerState state, RunProgram run) {
    ProgramPhase phase = ProgramPhase.of(state);
    String word = StateWords.capital(phase.word());
    return switch (phase) {
      case RUNNING -> word;
      case PAUSED -> word + pausedPlace(state, run);
      case STOPPED ->
          state
              .program()
              .ending()
              .filter(ending -> !run.left(state))
              .map(ending -> "Last run: " + run.name(state) + ", " + ended(ending, run))
              .orElse(word);
    };
  }

  private static String pausedPlace(ControllerState state, RunProgram run) {
    int line =
        run.shownLine(
            state.debug().stop().map(DebugState.Stop::line).orElse(state.program().line()));
    return line == 0 ? "" : " at line " + line;
  }

  private static String ended(Ending ending, RunProgram run) {
    return switch (ending) {
      case Ending.Finished finished -> "finished";
      case Ending.Halted halted -> "ended by halt";
      case Ending.Stopped stopped -> "stopped";
      case Ending.Failed failed ->
          "failed in line "
              + run.shownLine(failed.failure().line())
              + ": "
              + ByteText.decoded(failed.failure().message());
    };
  }

  private static List<String> pose(Pose tcpInBase) {
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < Pose.SIZE; i++) {
      texts.add(
          i < 3
              ? number("%.2f mm", 1000 * tcpInBase.get(i))
              : number("%.4f rad", tcpInBase.get(i)));
    }
    return texts;
  }

  private static List<String> joints(ControllerState state) {
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < JOINTS.size(); i++) {
      texts.add(number("%.2f\u00b0", Math.toDegrees(state.arm().actualPositionRad().get(i))));
    }
    return texts;
  }

  /** Without a sign before a zero. */
  private static String number(String format, double value) {
    String text = String.format(Locale.ROOT, format, value);
    return text.matches("-0\\.0*\\D.*") ? text.substring(1) : text;
  }
}
