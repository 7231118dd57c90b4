package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.command.service.Version;
import org.pendant.command.text.CommandLanguage;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.mutation.MutationReport;
import org.pendant.testing.mutation.MutationRun;
import org.pendant.testing.mutation.MutationSettings;
import org.pendant.testing.mutation.report.MutationJson;
import org.pendant.testing.mutation.report.MutationTable;
import org.pendant.testing.run.TestRunner;
import org.pendant.testing.run.TestSettings;

/**
 * Test mutation: what {@code pendant test --mutate} does once the tests are green.
 *
 * @param settings which mutants are tried
 * @param json the file for viewers of reports
 * @param leastPercent the score that has to be reached
 */
record TestMutation(
    MutationSettings settings, Optional<OutputFile> json, OptionalDouble leastPercent) {
  private static final int MAX_MUTANTS = 1_000_000;
  private static final long STEPS = 100;
  private static final String CLEARED = "\r" + " ".repeat(40) + "\r";

  private static final Option MUTATE =
      Option.flag("--mutate")
          .documented(
              "make small mistakes in the programs, one at a time, and tell which of them no test"
                  + " notices, see [mutation.md](mutation.md); each option of mutation asks for"
                  + " it");
  private static final Option ONLY =
      Option.text("--mutate-only", "TEXT")
          .repeated()
          .documented(
              "pick", "mutate only programs whose file contains this text; may be repeated");
  private static final Option MUTANTS =
      Option.of("--mutants", new OptionArgument.Whole("N", 0, MAX_MUTANTS))
          .standing(Integer.toString(MutationSettings.STANDARD_MOST))
          .documented(
              "0",
              "how many mistakes are tried, default "
                  + MutationSettings.STANDARD_MOST
                  + " that the seed chooses; 0 for all");
  private static final Option SCORE =
      Option.of("--mutation-score", new OptionArgument.Real("PERCENT", 0, 100, false, "%"))
          .documented("80", "exit with 1 where tests notice a smaller share of the mistakes, in %");
  private static final Option JSON =
      Option.output("--mutation-json", "FILE")
          .documented(
              "mutation.json",
              "write mutants as JSON by the schema of mutation-testing-elements, which viewers"
                  + " read");

  /** All of them. */
  static final List<Option> ALL = List.of(MUTATE, ONLY, MUTANTS, SCORE, JSON);

  /** Whether anything is asked for about mutation. */
  static boolean wanted(Arguments arguments) {
    return ALL.stream().anyMatch(arguments::has);
  }

  /** What is asked for; empty where mutation is not. */
  static Optional<TestMutation> of(Arguments arguments, TestSettings tests) throws UsageException {
    if (!wanted(arguments)) {
      return Optional.empty();
    }
    return Optional.of(
        new TestMutation(
            new MutationSettings(
                arguments.values(ONLY),
                arguments.whole(MUTANTS).orElse(MutationSettings.STANDARD_MOST),
                tests.seed(),
                tests.jobs()),
            TestReports.file(JSON, "\"schemaVersion\"", arguments),
            arguments.number(SCORE)));
  }

  /**
   * Mutates the programs, and tells what comes of it.
   *
   * @param runner that ran the tests
   * @param coverage what they have reached
   * @param interruption by which it is cancelled
   */
  ExitCode run(
      TestFilesOnDisk files,
      TestRunner runner,
      SuiteResult result,
      CoverageReport coverage,
      Interruption interruption,
      Console console)
      throws UsageException {
    if (result.red() || runner.cancelled()) {
      console.complain(text("nothingMutated"));
      return ExitCode.DONE;
    }
    MutationRun run =
        new MutationRun(
            files, runner, result, settings, (tried, all) -> tellProgress(tried, all, console));
    MutationReport report = TestCommand.cancellable(interruption, runner, () -> run.run(coverage));
    if (TestCommand.isTerminal()) {
      console.printPiece(CLEARED);
    }
    console.print("");
    MutationTable.of(report, CommandLanguage.texts(MutationTable.class))
        .lines()
        .forEach(console::print);
    console.flush();
    if (json.isPresent()) {
      json.get().write(out -> MutationJson.write(report, result.results(), Version.number(), out));
    }
    if (leastPercent.isPresent() && report.score().percent() < leastPercent.getAsDouble()) {
      console.complain(
          text("scoreTooLow", report.score().text(), Decimal.text(leastPercent.getAsDouble(), 3)));
      return ExitCode.TESTS_FAILED;
    }
    return ExitCode.DONE;
  }

  /** Where people watch, in one line that is cleared in the end. */
  private static void tellProgress(int tried, int all, Console console) {
    if (TestCommand.isTerminal() && (tried * STEPS / all != (tried - 1) * STEPS / all)) {
      console.printPiece("\r" + text("mutantsDone", tried, all));
      console.flush();
    }
  }
}
