package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.world.LinkContact;
import org.pendant.language.source.Source;
import org.pendant.script.vm.Program;

/**
 * Cell check: runs programs in virtual time among the objects of a scene, which links pass through,
 * and tells what they get into.
 */
final class CellCheck {
  static final Option CELL =
      Option.input("--cell", "FILE.json")
          .documented(
              "scene.json",
              "run each program in virtual time in this [scene](scene.md), and tell what links of"
                  + " the arm get into");
  static final Option JSON =
      Option.output("--json", "FILE")
          .explained("--json.check")
          .documented("collisions.json", "write collisions and nearest distances as JSON");

  /** How long a program is watched that nothing is said of, s of robot time. */
  private static final double STANDARD_LIMIT_S = 600;

  private final Arguments arguments;
  private final String cell;

  /** What there is to do where the scene has several controllers, with the programs of all. */
  private final Optional<SharedCellCheck> shared;

  private final Optional<OutputFile> json;
  private final List<String> written = new ArrayList<>();

  private CellCheck(
      Arguments arguments,
      String cell,
      Optional<SharedCellCheck> shared,
      Optional<OutputFile> json) {
    this.arguments = arguments;
    this.cell = cell;
    this.shared = shared;
    this.json = json;
  }

  /**
   * The check that a command line asks for; empty if it names no scene.
   *
   * @throws UsageException if the scene cannot be read, or options lack it
   */
  static Optional<CellCheck> of(Arguments arguments) throws UsageException {
    Optional<String> cell = arguments.value(CELL);
    // all that is read is named before anything is said of what is written
    RunOptions run = RunOptions.of(arguments);
    Optional<SharedCellCheck> shared = Optional.empty();
    if (cell.isPresent()) {
      CellFile file = CellFile.read(cell.get(), arguments.files());
      if (file.alone()) {
        var _ = options(run, cell.get(), arguments);
      } else {
        double limitS = run.timeoutS().orElse(STANDARD_LIMIT_S);
        shared = Optional.of(new SharedCellCheck(file, run, limitS, arguments));
      }
    }
    Optional<OutputFile> json = OutputFile.of(JSON, arguments);
    if (cell.isPresent()) {
      return Optional.of(new CellCheck(arguments, cell.get(), shared, json));
    }
    for (Option option : RunOptions.OF_CHECK) {
      if (arguments.has(option) && !option.equals(InstallationOption.OPTION)) {
        throw new UsageException(text("goesWithCell", option.name()));
      }
    }
    if (json.isPresent()) {
      throw new UsageException(text("jsonGoesWithCell"));
    }
    return Optional.empty();
  }

  private static ControllerOptions options(RunOptions run, String cell, Arguments arguments)
      throws UsageException {
    ControllerOptions placed = SimulationOptions.withScene(run.controller(), cell, arguments);
    return placed.withScene(placed.scene().withLinks(LinkContact.PASS));
  }

  /** The check of all programs at once; empty where the scene has one controller. */
  Optional<SharedCellCheck> shared() {
    return shared;
  }

  /** Runs a program that compiles, in a scene of one controller. */
  ExitCode run(RunnableFile file, Interruption interruption, Console console)
      throws UsageException {
    RunOptions run = RunOptions.of(arguments, file.installation(), file.robot());
    double limitS = run.timeoutS().orElse(STANDARD_LIMIT_S);
    ControllerOptions options = options(run, cell, arguments);
    Source source = file.source().orElseThrow();
    Controller controller = new Controller(options);
    Optional<Program> program = controller.load(source).program();
    if (program.isEmpty() || program.get().secondary()) {
      return ExitCode.DONE;
    }
    CollisionWatcher watcher = new CollisionWatcher(options.arm(), options.scene(), limitS);
    ExitCode code;
    interruption.hold();
    try (WallLimit wall = WallLimit.begin(run.wallTimeoutS(), file.file())) {
      code =
          new HeadlessRun(
                  file,
                  controller,
                  run.withoutTimeout(),
                  interruption,
                  wall,
                  console.withoutOutput(),
                  watcher)
              .run(program.get());
    }
    interruption.release();
    CollisionReport report = new CollisionReport(file, source, Optional.empty(), watcher);
    report.tell(console);
    if (watcher.enough()) {
      report.tellLimit(limitS, console);
    }
    written.add(report.json());
    return watcher.collisions().isEmpty() ? code : ExitCode.DOES_NOT_COMPILE;
  }

  /** Writes what was found, where that is wanted. */
  void write() throws UsageException {
    if (json.isPresent()) {
      List<String> programs = new ArrayList<>(written);
      shared.ifPresent(all -> all.reports().forEach(each -> programs.add(each.json())));
      String text =
          programs.stream()
              .collect(Collectors.joining(",\n", "{\n  \"programs\": [\n", "\n  ]\n}\n"));
      json.get().write(out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
  }
}
