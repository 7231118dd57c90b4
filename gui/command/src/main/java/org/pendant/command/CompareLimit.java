package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.pendant.command.comparison.ComparedRun;
import org.pendant.language.check.Nearest;
import org.pendant.recording.compare.RunComparison;

/**
 * Comparison limit that a command line sets.
 *
 * @param name of a difference
 * @param most the largest size that keeps it, in the unit of the tables
 */
record CompareLimit(String name, double most) {
  static final Option OPTION =
      Option.text("--limit", "NAME=VALUE")
          .repeated()
          .documented(
              "duration=0.01",
              "the largest difference that is accepted, by the name and in the unit of the tables:"
                  + " of a figure its error either way, of a quantity its rms; a name without the"
                  + " number of a joint or axis is for the largest of them, such as"
                  + " `target_moment=0.02`. One that is not kept gives the exit code 1; may be"
                  + " repeated");

  static List<CompareLimit> of(Arguments arguments) throws UsageException {
    List<CompareLimit> limits = new ArrayList<>();
    for (String text : arguments.values(OPTION)) {
      int equals = text.indexOf('=');
      double most =
          equals < 0 ? Double.NaN : Arguments.parsed(text.substring(equals + 1)).orElse(Double.NaN);
      if (!(most >= 0)) {
        throw new UsageException(text("limitMustBe", OPTION.name(), text));
      }
      limits.add(new CompareLimit(text.substring(0, equals), most));
    }
    return limits;
  }

  /**
   * Holds it against a comparison.
   *
   * @throws UsageException if that has no such difference
   */
  ComparedRun.Limit in(RunComparison comparison) throws UsageException {
    OptionalDouble size = comparison.size(name);
    if (size.isEmpty()) {
      List<String> names = comparison.names();
      throw new UsageException(
          text(
              "notCompared",
              OPTION.name(),
              name,
              name,
              new Nearest().to(name, () -> names).map(near -> text("didYouMean", near)).orElse(""),
              String.join(", ", names)));
    }
    return new ComparedRun.Limit(name, most, size.getAsDouble());
  }
}
