package org.pendant.editors.lsp.provider;

import static org.pendant.editors.lsp.provider.AnswerTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.Diagnostic;
import org.eclipse.lsp4j.DiagnosticSeverity;
import org.eclipse.lsp4j.InlayHint;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.pendant.editors.dryrun.DryRunResult;
import org.pendant.editors.dryrun.DryRunResult.Trouble;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.SourceRange;
import org.pendant.language.source.VisibleText;
import org.pendant.recording.lines.LineStatistics;
import org.pendant.recording.lines.Margin;
import org.pendant.recording.lines.Worst;

/** Dry run answers: what a dry run says of the lines of a text. */
public final class DryRunAnswers {
  /** Who says so, shown beside the message. */
  public static final String SOURCE = "pendant dry run";

  /** How much of a limit is used up where it is worth a word. */
  private static final double NEAR = 0.95;

  private DryRunAnswers() {}

  /** What stopped the program, and lines on which the arm comes near to a limit. */
  public static List<Diagnostic> diagnostics(
      Document document, DryRunResult result, ClientFeatures client) {
    List<Diagnostic> told = new ArrayList<>();
    result.trouble().ifPresent(trouble -> told.add(diagnostic(document, trouble, client)));
    for (LineStatistics line : result.lines()) {
      for (Worst worst : line.worst()) {
        if (worst.margin() != Margin.JOINT_SPEED && worst.used() >= NEAR) {
          Diagnostic near =
              new Diagnostic(range(document, line.line()), client.shown(words(worst)));
          near.setSeverity(DiagnosticSeverity.Information);
          near.setSource(SOURCE);
          near.setCode("near-limit");
          told.add(near);
        }
      }
    }
    return told;
  }

  private static Diagnostic diagnostic(Document document, Trouble trouble, ClientFeatures client) {
    Diagnostic told =
        new Diagnostic(
            trouble.range().map(document::range).orElseGet(() -> range(document, trouble.line())),
            client.shown(VisibleText.of(ByteText.decoded(trouble.message()))));
    told.setSeverity(DiagnosticSeverity.Warning);
    told.setSource(SOURCE);
    told.setCode("dry-run");
    return told;
  }

  private static String words(Worst worst) {
    String of = worst.margin().words();
    if (worst.margin().isShare()) {
      return text("shareUsed", of, worst.part(), whole(worst.value() * 100));
    }
    return worst.margin() == Margin.PLANE
        ? text("distanceLeft", of, worst.part(), whole(worst.value() * 1000))
        : text("angleLeft", of, worst.part(), whole(Math.toDegrees(worst.value())));
  }

  private static String whole(double value) {
    return String.format("%.0f", value);
  }

  /** The time of each line of {@code asked} on which the arm moves, at its end. */
  public static List<InlayHint> hints(
      Document document, Range asked, DryRunResult result, ClientFeatures client) {
    List<InlayHint> hints = new ArrayList<>();
    boolean givenUp = result.outcome() == DryRunResult.Outcome.GIVEN_UP;
    for (LineStatistics line : result.lines()) {
      int index = line.line() - 1;
      boolean wanted =
          line.moved()
              && index >= asked.getStart().getLine()
              && index <= asked.getEnd().getLine()
              && index < document.positions().lineCount();
      if (wanted) {
        InlayHint hint =
            new InlayHint(
                range(document, line.line()).getEnd(),
                Either.forLeft(client.shown(time(line, givenUp))));
        hint.setPaddingLeft(true);
        hint.setTooltip(client.shown(text(givenUp ? "lineTimeGivenUp" : "lineTime")));
        hints.add(hint);
      }
    }
    return hints;
  }

  /** What was not seen to its end took at least that long. */
  private static String time(LineStatistics line, boolean givenUp) {
    String time = (givenUp ? "\u2265 " : "") + seconds(line.timeS());
    return line.executions() > 1 ? text("timeInTurns", time, line.executions()) : time;
  }

  /** How long the whole program took, or that it was given up. */
  public static Optional<String> duration(DryRunResult result) {
    return switch (result.outcome()) {
      case FINISHED -> Optional.of(text("durationInDryRun", seconds(result.timeS())));
      case FAILED, STOPPED -> Optional.of(text("stopsAfter", seconds(result.timeS())));
      case GIVEN_UP, NOT_RUN -> Optional.empty();
    };
  }

  static String seconds(double timeS) {
    return String.format(timeS < 10 ? "%.2f s" : "%.1f s", timeS);
  }

  /** The line without the blanks around it. */
  private static Range range(Document document, int line) {
    int index = Math.clamp(line - 1, 0, document.positions().lineCount() - 1);
    int start = document.positions().lineStart(index);
    int end = document.positions().lineEnd(index);
    String text = document.source().text(new SourceRange(start, end));
    int leading = text.length() - text.stripLeading().length();
    return document.range(new SourceRange(Math.min(end, start + leading), end));
  }
}
