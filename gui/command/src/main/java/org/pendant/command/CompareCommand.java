package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.pendant.command.comparison.ComparedRun;
import org.pendant.command.comparison.ComparisonJson;
import org.pendant.command.comparison.ComparisonPage;
import org.pendant.command.comparison.FidelityPage;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.protocols.externalcontrol.NoScript;
import org.pendant.recording.compare.Difference;

/**
 * Command {@code pendant compare RECORDING PROGRAM}: runs the program that a robot ran while it was
 * recorded, and says what differs; with two recordings, {@link ExactComparison} or {@link
 * GoldenFileComparison}.
 */
final class CompareCommand implements Subcommand {
  private static final String RECORDING = "theRecording";

  private static final Option JSON =
      Option.output("--json", "FILE")
          .explained("--json.compare")
          .documented("diff.json", "write all differences, with all digits, as JSON");
  private static final Option HTML =
      Option.output("--html", "FILE")
          .explained("--html.compare")
          .documented(
              "diff.html",
              "write a page with the tables and a chart of each quantity, which needs no other"
                  + " file");

  private static final Option COLLECTION =
      Option.input("--collection", "FILE")
          .documented(
              "recordings.txt",
              "a list of recordings: a heading (`# ...`), and below it what follows `pendant"
                  + " compare`, with files in the folder of the list; in place of RECORDING and"
                  + " PROGRAM");
  private static final Option MARKDOWN =
      Option.output("--markdown", "FILE.md")
          .explained("--markdown.compare")
          .documented(
              "fidelity.md",
              "the page about them, [fidelity.md](fidelity.md); its charts come into a folder"
                  + " beside it");

  @Override
  public String name() {
    return "compare";
  }

  @Override
  public String operands() {
    return "RECORDING PROGRAM|RECORDING";
  }

  @Override
  public List<Option> options() {
    return Stream.of(
            Stream.of(
                CompareLimit.OPTION,
                JSON,
                HTML,
                OutputFile.FORCE,
                COLLECTION,
                MARKDOWN,
                RecordedFile.FREQUENCY),
            PayloadOptions.ALL.stream(),
            RunOptions.OF_PROGRAM.stream())
        .flatMap(each -> each)
        .toList();
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    // all that is read is named before anything is said of what is written
    Optional<String> list = arguments.value(COLLECTION);
    Optional<byte[]> listed =
        list.isPresent()
            ? Optional.of(arguments.files().bytes("theListOfRecordings", list.get()))
            : Optional.empty();
    List<String> operands = arguments.operands();
    for (int i = 0; i < operands.size(); i++) {
      arguments.files().path(i == 0 ? RECORDING : RunnableFile.PROGRAM, operands.get(i));
    }
    CellFile.refuse(arguments);
    RunOptions.of(arguments);
    Optional<OutputFile> markdown = OutputFile.of(MARKDOWN, arguments);
    Optional<OutputFile> json = OutputFile.of(JSON, arguments);
    Optional<OutputFile> html = OutputFile.of(HTML, arguments);
    boolean golden = GoldenFileComparison.isMeant(operands);
    if (golden || ExactComparison.isMeant(operands)) {
      if (list.isPresent() || markdown.isPresent() || json.isPresent() || html.isPresent()) {
        throw new UsageException(text("recordingsWithoutFiles"));
      }
      String newer = operands.get(0);
      String older = operands.get(1);
      return golden
          ? GoldenFileComparison.run(
              newer, older, CompareLimit.of(arguments), arguments.files(), console)
          : ExactComparison.run(newer, older, arguments.files(), console);
    }
    if (list.isPresent() != markdown.isPresent()) {
      throw new UsageException(text("collectionNeedsMarkdown"));
    }
    if (list.isPresent()) {
      if (!operands.isEmpty() || json.isPresent() || html.isPresent()) {
        throw new UsageException(text("collectionNamesAll"));
      }
      return page(RecordingList.of(list.get(), listed.orElseThrow()), markdown.get(), console);
    }
    Compared compared = compare(arguments, console);
    if (compared.run().isEmpty()) {
      return compared.code();
    }
    ComparedRun run = compared.run().get();
    print(run, console);
    write(json, ComparisonJson.of(run));
    write(html, ComparisonPage.of(run));
    return compared.code().or(run.kept() ? ExitCode.DONE : ExitCode.LIMIT_EXCEEDED);
  }

  /** What came out of one recording and its program. */
  private record Compared(ExitCode code, Optional<ComparedRun> run) {}

  private static Compared compare(Arguments arguments, Console console) throws UsageException {
    List<String> operands = arguments.operands();
    if (operands.size() != 2) {
      throw new UsageException(text("recordingAndProgramExpected", operands.size()));
    }
    List<CompareLimit> limits = CompareLimit.of(arguments);
    PayloadOptions payload = PayloadOptions.of(arguments);
    String name = operands.getFirst();
    Path path = arguments.files().path(RECORDING, name);
    RunnableFile program = RunnableFile.read(arguments, operands.subList(1, 2)).getFirst();
    RecordedFile recorded = RecordedFile.read(name, path, arguments.number(RecordedFile.FREQUENCY));
    RunOptions options =
        RunOptions.of(arguments, program.installation(), program.robot(), recorded.arm());
    InstallationOption.tell(arguments, console);
    program.tell(console);
    PayloadOptions carried = payload.or(recorded.samples());
    ProgramComparison.Outcome outcome;
    try (Interruption interruption = Interruption.listen("theRun");
        WallLimit wall = WallLimit.begin(options.wallTimeoutS(), program.file())) {
      RunnableFile whole = program.asked(options.drivers());
      Console ours = console.toErrors();
      outcome =
          new ProgramComparison(recorded, whole, options, carried).run(interruption, wall, ours);
      ours.flush();
    } catch (NoScript e) {
      console.complain(text("errorIn", program.file(), CommandLanguage.shown(e.getMessage())));
      return new Compared(ExitCode.UNAVAILABLE, Optional.empty());
    }
    if (outcome.comparison().isEmpty()) {
      return new Compared(outcome.code(), Optional.empty());
    }
    List<ComparedRun.Limit> held = new ArrayList<>();
    for (CompareLimit each : limits) {
      held.add(each.in(outcome.comparison().get()));
    }
    ComparedRun run =
        new ComparedRun(
            name,
            program.file(),
            options.controller().robotId(),
            carried.text(),
            outcome.comparison().get(),
            held);
    return new Compared(outcome.code(), Optional.of(run));
  }

  private ExitCode page(RecordingList list, OutputFile file, Console console)
      throws UsageException {
    List<FidelityPage.Entry> entries = new ArrayList<>();
    for (RecordingList.Entry each : list.entries()) {
      Compared compared = compare(Arguments.parse(options(), each.words()), console);
      if (compared.run().isEmpty() || compared.code() != ExitCode.DONE) {
        return compared.code();
      }
      entries.add(new FidelityPage.Entry(each.heading(), each.line(), compared.run().get()));
    }
    String pageName = file.path().getFileName().toString();
    int point = pageName.lastIndexOf('.');
    String chartFolder = point > 0 ? pageName.substring(0, point) : pageName + "-charts";
    FidelityPage.Files files = FidelityPage.of(entries, chartFolder);
    Path folder = file.path().resolveSibling(chartFolder);
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new UsageException(text("cannotBeFolder", folder, FileTrouble.reason(e)));
    }
    for (Map.Entry<String, String> each : new TreeMap<>(files.charts()).entrySet()) {
      Path chart = folder.resolve(each.getKey());
      write(Optional.of(new OutputFile(chart.toString(), chart, file.force())), each.getValue());
    }
    write(Optional.of(file), files.text());
    return ExitCode.DONE;
  }

  private static void write(Optional<OutputFile> file, String text) throws UsageException {
    if (file.isPresent()) {
      file.get().write(out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
  }

  private static void print(ComparedRun run, Console console) {
    run.comparison().notes().forEach(note -> console.print(text("noteIs", note)));
    Table figures =
        new Table()
            .left(text("figure"))
            .left(text("unit"))
            .right(text("recorded"))
            .right("Pendant")
            .right(text("error"));
    Table residuals =
        new Table()
            .left(text("pendantLessRecording"))
            .left(text("unit"))
            .right(text("fromColumn"))
            .right(text("toColumn"))
            .right(text("mean"))
            .right("rms")
            .right(text("largest"));
    for (Difference each : run.comparison().differences()) {
      Table table = each instanceof Difference.Figure ? figures : residuals;
      table.row(ComparisonPage.cells(each).toArray(new String[0]));
    }
    console.print("");
    figures.aligned().forEach(console::print);
    console.print("");
    residuals.aligned().forEach(console::print);
    if (!run.limits().isEmpty()) {
      console.print("");
    }
    for (ComparedRun.Limit each : run.limits()) {
      console.print(
          text(
              each.kept() ? "limitKept" : "limitExceeded",
              each.name(),
              Difference.text(each.size()),
              Difference.text(each.most())));
    }
  }
}
