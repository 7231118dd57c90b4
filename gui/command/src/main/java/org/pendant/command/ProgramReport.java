package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.Robot;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StopPlace;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.motion.MotionFailure;
import org.pendant.script.vm.Ending;

/** Program report: what a program says while nobody looks at its robot, and how it ended. */
final class ProgramReport {
  private final RunnableFile file;
  private final Source source;
  private final Robot robot;
  private final Console console;
  private final String prefix;
  private Optional<SafetyStop> heldBy = Optional.empty();

  /** What the log says of a safety stop that the program will end with, which tells it then. */
  private Optional<LogEntry> stopEntry = Optional.empty();

  private int lastLine;
  private boolean pendingOutput;

  /**
   * Of a program that has a text.
   *
   * @param prefix stands before each line
   */
  ProgramReport(RunnableFile file, Robot robot, Console console, String prefix) {
    this.file = file;
    source = file.source().orElseThrow();
    this.robot = robot;
    this.console = console;
    this.prefix = prefix;
  }

  /** The text of the program. */
  Source source() {
    return source;
  }

  /** What the log says of switching on. */
  void begin() {
    robot.state().newEntries().forEach(this::print);
  }

  /** The program is in that line; 0 for none. */
  void passes(int line) {
    if (line > 0) {
      lastLine = line;
    }
  }

  /** What a frame has brought. */
  void show(ControllerState state) {
    for (LogEntry entry : state.newEntries()) {
      print(entry);
    }
    for (Popup popup : state.newPopups()) {
      console.complain(prefix + Report.popup(popup));
    }
  }

  /** Whether something has been printed that {@link Console#flush} would hand over. */
  boolean pendingOutput() {
    return pendingOutput;
  }

  /** It has been handed over. */
  void flushed() {
    pendingOutput = false;
  }

  private void print(LogEntry entry) {
    switch (entry.origin()) {
      case SCRIPT -> {
        console.printBytes(prefix + entry.text());
        pendingOutput = true;
      }
      case SAFETY -> {
        if (stopEntry.isEmpty() && tellsOfStop(entry)) {
          stopEntry = Optional.of(entry);
        } else {
          complain(Report.logEntry(source, entry));
        }
      }
      case CONTROLLER, PROTOCOL -> complain(Report.logEntry(source, entry));
      case ENDING -> {
        // Said with its place and call stack when the program has ended.
      }
    }
  }

  private boolean tellsOfStop(LogEntry entry) {
    return robot
        .state()
        .safety()
        .stop()
        .filter(stop -> stop.message().equals(entry.text()))
        .isPresent();
  }

  /** A line about it on standard error. */
  void complain(String text) {
    console.complain(prefix + text);
  }

  /** A complaint about all of the program. */
  void error(String message) {
    complain(Report.error(source, message));
  }

  /** The same by what others have said in English, one {@code char} a byte. */
  void errorFromEnglish(String message) {
    error(CommandLanguage.shown(ByteText.decoded(message)));
  }

  /** It is stopped because of a safety stop. */
  void stoppedBy(SafetyStop stop) {
    heldBy = Optional.of(stop);
  }

  /**
   * It was stopped as its time was over.
   *
   * @param limit says which time
   */
  ExitCode timedOut(String limit) {
    tellStopEntry(Optional.empty());
    error(limit);
    return ExitCode.TIMED_OUT;
  }

  /** Says how it ended. */
  ExitCode ended() {
    Ending ending = robot.state().program().ending().orElseThrow();
    Optional<String> why = stopReason(ending);
    tellStopEntry(why);
    return switch (ending) {
      case Ending.Finished finished -> ExitCode.DONE;
      case Ending.Halted halted -> ExitCode.DONE;
      case Ending.Failed failed -> {
        Report.failure(source, failed.failure())
            .forEach(each -> console.complainInLines(prefix + each));
        file.nodeAt(failed.failure().line())
            .ifPresent(
                node ->
                    complain(
                        node
                            + CommandLanguage.shown(ByteText.decoded(failed.failure().message()))));
        if (failed.failure().code().equals("no-answer")) {
          complain(Report.note(source, text("prepareAnswer")));
        }
        yield failed.failure().code().equals("internal-error")
            ? ExitCode.INTERNAL_ERROR
            : ExitCode.PROGRAM_FAILED;
      }
      case Ending.Stopped stopped -> {
        int line = stoppedInLine();
        why.ifPresent(reason -> error(text("stoppedInLine", line, ByteText.decoded(reason))));
        if (why.isPresent()) {
          file.nodeAt(line).ifPresent(node -> complain(node + text("stoppedHere")));
        }
        yield why.isPresent() ? ExitCode.PROGRAM_FAILED : ExitCode.DONE;
      }
    };
  }

  /** What stopped a program that did not end by itself; empty if somebody wished it. */
  private Optional<String> stopReason(Ending ending) {
    return ending instanceof Ending.Stopped
        ? heldBy
            .or(() -> robot.state().safety().stop())
            .map(SafetyStop::message)
            .or(() -> robot.state().arm().fault().map(MotionFailure::message))
        : Optional.empty();
  }

  /** The line of the log of a safety stop, unless it is told as the reason of the end. */
  private void tellStopEntry(Optional<String> reason) {
    stopEntry
        .filter(entry -> !reason.equals(Optional.of(entry.text())))
        .ifPresent(entry -> complain(Report.logEntry(source, entry)));
  }

  /** The line of the program that a safety stop met, or the last one that it reached. */
  private int stoppedInLine() {
    return robot
        .state()
        .safety()
        .stopPlace()
        .map(StopPlace::line)
        .filter(line -> line > 0)
        .orElse(lastLine);
  }
}
