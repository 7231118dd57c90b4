package org.pendant.editors.dryrun;

import java.util.List;
import java.util.Optional;
import org.pendant.language.source.SourceRange;
import org.pendant.recording.lines.LineStatistics;

/**
 * What a dry run came to.
 *
 * @param outcome how it ended
 * @param trouble what stopped the program; empty when nothing did
 * @param timeS robot time that the program took, without pauses, s
 * @param lines what each line took
 */
public record DryRunResult(
    Outcome outcome, Optional<Trouble> trouble, double timeS, List<LineStatistics> lines) {

  /** How a dry run ends. */
  public enum Outcome {
    /** The program has ended by itself. */
    FINISHED,
    /** A run-time error has ended it. */
    FAILED,
    /** A safety function has stopped the arm. */
    STOPPED,
    /** It was still running at a time limit, or asked for something that is not there. */
    GIVEN_UP,
    /** It cannot be run alone, such as a secondary program. */
    NOT_RUN,
  }

  /**
   * What stopped the program.
   *
   * @param line where, from 1
   * @param range the expression or statement, where it is known
   * @param message what happened, as bytes, one {@code char} a byte
   */
  public record Trouble(int line, Optional<SourceRange> range, String message) {}

  /** Copies the list. */
  public DryRunResult {
    lines = List.copyOf(lines);
  }

  static DryRunResult notRun() {
    return new DryRunResult(Outcome.NOT_RUN, Optional.empty(), 0, List.of());
  }

  /** What a line took, if it was reached. */
  public Optional<LineStatistics> line(int line) {
    return lines.stream().filter(each -> each.line() == line).findFirst();
  }
}
