package org.pendant.desktop.shell.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.desktop.session.StateWords;
import org.pendant.language.source.ByteText;
import org.pendant.models.pose.Pose;
import org.pendant.script.debug.DebugState;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;

/**
 * Run facts: what the Run screen says about a snapshot, in words.
 *
 * @param state of the program and how the last one ended
 * @param failed whether the last one ended by an error
 * @param line number of the line that was reached and its text; empty when no program runs
 * @param waiting how many popups and questions are open; empty for none
 * @param tcp position (mm) and rotation vector (rad) of the TCP in the base, six texts
 * @param joints joint positions in degrees, six texts
 */
record RunFacts(
    String state,
    boolean failed,
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
   * @param lineText text of the line that was reached
   * @param shown the line that people see for one of what runs; 0 where they see none
   */
  static RunFacts of(ControllerState state, String lineText, IntUnaryOperator shown) {
    ProgramStatus program = state.program();
    return new RunFacts(
        state
            .debug()
            .stop()
            .map(stop -> heldText(stop, shown))
            .orElseGet(() -> stateText(program, shown)),
        program.failed(),
        line(shown.applyAsInt(program.line()), lineText),
        waiting(state.openPopups().size(), state.openQuestions().size()),
        pose(state.arm().actualTcpInBase()),
        joints(state));
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

  private static String heldText(DebugState.Stop stop, IntUnaryOperator shown) {
    return "Paused before line " + shown.applyAsInt(stop.line());
  }

  private static String stateText(ProgramStatus program, IntUnaryOperator shown) {
    if (program.state() != ProgramState.STOPPED) {
      return StateWords.capital(StateWords.of(program.state()));
    }
    if (program.ending().isEmpty()) {
      return "Stopped; nothing has run yet";
    }
    return switch (program.ending().get()) {
      case Ending.Finished finished -> "Finished";
      case Ending.Halted halted -> "Ended by halt";
      case Ending.Stopped stopped -> "Stopped";
      case Ending.Failed failed ->
          "Failed in line "
              + shown.applyAsInt(failed.failure().line())
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
