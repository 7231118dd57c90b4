package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.compare.FirstDifference;

/**
 * Exact comparison of two recordings: whether their last runs did the same in every frame, and
 * where they first did not.
 */
final class ExactComparison {
  private static final String RECORDING = ".rec";

  private ExactComparison() {}

  /** Whether the operands are two recordings. */
  static boolean isMeant(List<String> operands) {
    return operands.size() == 2
        && operands.stream().allMatch(each -> each.toLowerCase(Locale.ROOT).endsWith(RECORDING));
  }

  /**
   * Says what differs first.
   *
   * @param newer name of the file with the run that is looked at
   * @param older name of the one that it is compared with
   */
  static ExitCode run(String newer, String older, SourceFiles files, Console console)
      throws UsageException {
    Recording now = open(newer, files, console);
    Recording before = open(older, files, console);
    Optional<FirstDifference> difference;
    try {
      difference = FirstDifference.between(now, before);
    } catch (IllegalArgumentException e) {
      throw UsageException.fromEnglish(e);
    }
    if (difference.isEmpty()) {
      console.print(text("sameInAllFrames", FirstDifference.framesOfRun(now).orElseThrow()));
      return ExitCode.DONE;
    }
    console.print(newer + " " + difference.get().words());
    return ExitCode.LIMIT_EXCEEDED;
  }

  private static Recording open(String name, SourceFiles files, Console console)
      throws UsageException {
    RecordingFile.Opened opened = RecordedFile.open(name, files.path("theRecording", name));
    opened
        .warning()
        .ifPresent(
            warning -> console.complain(text("warningIn", name, CommandLanguage.shown(warning))));
    return opened.recording();
  }
}
