package org.pendant.desktop.shell.run;

import static org.pendant.desktop.shell.run.RunTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.RunTime;
import org.pendant.desktop.session.StateWords;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
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
 * @param line number of the line that was reached and its text, or why the last run has failed;
 *     empty when there is neither
 * @param waiting how many popups and questions are open; empty for none
 * @param tcp position and rotation of the TCP in the base, six texts
 * @param joints joint positions, six texts
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
  /** With which the names of joints' components end, base first. */
  static final List<String> JOINT_WORDS =
      List.of("base", "shoulder", "elbow", "wrist-1", "wrist-2", "wrist-3");

  /** Names of the joints, base first. */
  static final List<String> JOINTS =
      List.of(
          text("base"),
          text("shoulder"),
          text("elbow"),
          text("wrist1"),
          text("wrist2"),
          text("wrist3"));

  /** Names of a pose's components where they are not read. */
  static final List<String> POSE = List.of("x", "y", "z", "rx", "ry", "rz");

  RunFacts {
    tcp = List.copyOf(tcp);
    joints = List.copyOf(joints);
  }

  /**
   * The facts of a snapshot.
   *
   * @param run the program that runs in it, or ran last
   * @param form how people read positions
   */
  static RunFacts of(ControllerState state, RunProgram run, PoseForm form) {
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
        program.failed() && !left
            ? failure(program)
            : line(run.shownLine(line), line == 0 ? "" : run.lineText(line)),
        waiting(state.openPopups().size(), state.openQuestions().size()),
        form.readings(state.arm().actualTcpInBase()),
        joints(state, form.angle()));
  }

  private static String title(ControllerState state, RunProgram run) {
    boolean stopped = ProgramPhase.of(state) == ProgramPhase.STOPPED;
    return run.next()
        .filter(next -> stopped)
        .map(next -> text("willRun", next))
        .orElse(run.name(state));
  }

  private static String pausedText(double pausedS) {
    if (pausedS < 1) {
      return "";
    }
    return pausedS < 60 ? text("pausedSeconds", (int) pausedS) : text("paused", clock(pausedS));
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
        ? text("line", line)
        : text("lineAndText", line, ByteText.decoded(text.strip()));
  }

  /** Why the last run has failed, in place of a line that is not reached any more. */
  private static String failure(ProgramStatus program) {
    return program.ending().stream()
        .filter(Ending.Failed.class::isInstance)
        .map(Ending.Failed.class::cast)
        .map(failed -> Messages.shown(ByteText.decoded(failed.failure().message())))
        .collect(Collectors.joining());
  }

  private static String waiting(int popups, int questions) {
    String popup = popups == 1 ? text("onePopup") : text("popupCount", popups);
    String question = questions == 1 ? text("oneQuestion") : text("questionCount", questions);
    if (popups > 0 && questions > 0) {
      return StateWords.capital(text("bothOpen", popup, question));
    }
    return popups == 0 && questions == 0
        ? ""
        : StateWords.capital(text("open", popups > 0 ? popup : question));
  }

  private static String stateText(ControllerState state, RunProgram run) {
    ProgramPhase phase = ProgramPhase.of(state);
    String word = StateWords.capital(phase.word());
    return switch (phase) {
      case RUNNING -> word;
      case PAUSED -> pausedAt(state, run).map(place -> text("pausedAt", place)).orElse(word);
      case STOPPED ->
          state
              .program()
              .ending()
              .filter(ending -> !run.left(state))
              .map(ending -> text("lastRun", run.name(state), ended(ending, run)))
              .orElse(word);
    };
  }

  private static Optional<String> pausedAt(ControllerState state, RunProgram run) {
    int line = state.debug().stop().map(DebugState.Stop::line).orElse(state.program().line());
    return Optional.of(place(line, run)).filter(place -> !place.isEmpty());
  }

  /** A node where there is one: people who build programs of nodes know no lines. */
  private static String place(int line, RunProgram run) {
    int shown = run.shownLine(line);
    return run.nodeAt(line).map(RunNode::words).orElse(shown == 0 ? "" : text("inLine", shown));
  }

  private static String ended(Ending ending, RunProgram run) {
    return switch (ending) {
      case Ending.Finished finished -> text("finished");
      case Ending.Halted halted -> text("endedByHalt");
      case Ending.Stopped stopped -> text("stopped");
      case Ending.Failed failed -> text("failedIn", place(failed.failure().line(), run));
    };
  }

  private static List<String> joints(ControllerState state, DisplayUnit unit) {
    List<String> texts = new ArrayList<>();
    for (int i = 0; i < JOINTS.size(); i++) {
      texts.add(unit.reading(state.arm().actualPositionRad().get(i)));
    }
    return texts;
  }
}
