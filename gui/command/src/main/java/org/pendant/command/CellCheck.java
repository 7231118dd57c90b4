package org.pendant.command;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.command.CollisionWatcher.Collision;
import org.pendant.command.CollisionWatcher.Nearest;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.world.LinkContact;
import org.pendant.controller.world.LinkHit;
import org.pendant.language.source.Source;
import org.pendant.models.json.JsonValues;
import org.pendant.script.vm.Program;

/**
 * Cell check: runs programs in virtual time among the objects of a scene, which links pass through,
 * and tells what they get into.
 */
final class CellCheck {
  static final Option CELL =
      Option.input("--cell", "FILE.json", "run programs in this scene, and tell collisions")
          .documented(
              "scene.json",
              "run each program in virtual time in this [scene](scene.md), and tell what links of"
                  + " the arm get into");
  static final Option JSON =
      Option.output("--json", "FILE", "write collisions as JSON")
          .documented("collisions.json", "write collisions and nearest distances as JSON");

  /** How long a program is watched that nothing is said of, s of robot time. */
  private static final double STANDARD_LIMIT_S = 600;

  private static final double MM = 1000;

  private final Arguments arguments;
  private final String cell;
  private final Optional<OutputFile> json;
  private final List<String> written = new ArrayList<>();

  private CellCheck(Arguments arguments, String cell, Optional<OutputFile> json) {
    this.arguments = arguments;
    this.cell = cell;
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
    if (cell.isPresent()) {
      CellFile.refuse(cell.get(), arguments.files());
      var _ = options(run, cell.get(), arguments);
    }
    Optional<OutputFile> json = OutputFile.of(JSON, arguments);
    if (cell.isPresent()) {
      return Optional.of(new CellCheck(arguments, cell.get(), json));
    }
    for (Option option : RunOptions.OF_CHECK) {
      if (arguments.has(option) && !option.equals(InstallationOption.OPTION)) {
        throw new UsageException(option.name() + " goes with --cell, which is missing");
      }
    }
    if (json.isPresent()) {
      throw new UsageException("--json goes with --cell, which is missing");
    }
    return Optional.empty();
  }

  private static ControllerOptions options(RunOptions run, String cell, Arguments arguments)
      throws UsageException {
    ControllerOptions placed = SimulationOptions.withScene(run.controller(), cell, arguments);
    return placed.withScene(placed.scene().withLinks(LinkContact.PASS));
  }

  /** Runs a program that compiles. */
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
    tell(file, source, watcher, console);
    if (watcher.enough()) {
      console.complain(
          Report.note(source, "looked at its first " + limitS + " s; --timeout says how many"));
    }
    written.add(json(file, watcher));
    return watcher.collisions().isEmpty() ? code : ExitCode.DOES_NOT_COMPILE;
  }

  private static void tell(
      RunnableFile file, Source source, CollisionWatcher watcher, Console console) {
    for (Collision each : watcher.collisions()) {
      String node = file.nodeAt(each.line()).map(place -> " (" + place + ")").orElse("");
      console.complain(
          "%s:%d: error: %s at %s s, %s mm deep, until %s s%s"
              .formatted(
                  source.name(),
                  each.line(),
                  each.hit().sentence(),
                  seconds(each.timeS()),
                  millimetres(each.hit().depthM()),
                  seconds(each.untilS()),
                  node));
    }
    Optional<Nearest> nearest = watcher.nearest();
    if (watcher.collisions().isEmpty() && nearest.isPresent()) {
      Nearest found = nearest.get();
      console.complain(
          Report.note(
              source,
              "nothing is hit; nearest is the %s to %s, %s mm at %s s in line %d"
                  .formatted(
                      found.pair().link(),
                      found.pair().otherWords(),
                      millimetres(-found.pair().depthM()),
                      seconds(found.timeS()),
                      found.line())));
    }
  }

  /** Writes what was found, where that is wanted. */
  void write() throws UsageException {
    if (json.isPresent()) {
      String text =
          written.stream()
              .collect(Collectors.joining(",\n", "{\n  \"programs\": [\n", "\n  ]\n}\n"));
      json.get().write(out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
  }

  private static String json(RunnableFile file, CollisionWatcher watcher) {
    String collisions =
        watcher.collisions().stream()
            .map(
                each ->
                    "        {%s, \"depth\": %s, \"line\": %d, \"time\": %s, \"until\": %s}"
                        .formatted(
                            json(each.hit()),
                            JsonValues.number(each.hit().depthM()),
                            each.line(),
                            JsonValues.number(each.timeS()),
                            JsonValues.number(each.untilS())))
            .collect(Collectors.joining(",\n"));
    String nearest =
        watcher
            .nearest()
            .map(
                each ->
                    ",\n      \"nearest\": {%s, \"distance\": %s, \"line\": %d, \"time\": %s}"
                        .formatted(
                            json(each.pair()),
                            JsonValues.number(-each.pair().depthM()),
                            each.line(),
                            JsonValues.number(each.timeS())))
            .orElse("");
    return "    {\n      \"program\": %s,\n      \"seconds\": %s,\n      \"collisions\": [%s]%s\n    }"
        .formatted(
            JsonValues.text(file.file()),
            JsonValues.number(watcher.timeS()),
            collisions.isEmpty() ? "" : "\n" + collisions + "\n      ",
            nearest);
  }

  private static String json(LinkHit pair) {
    return "\"link\": %s, \"%s\": %s"
        .formatted(
            JsonValues.text(pair.link()),
            pair.object() ? "object" : "other_link",
            JsonValues.text(pair.other()));
  }

  private static String seconds(double seconds) {
    return String.format(Locale.ROOT, "%.3f", seconds);
  }

  private static String millimetres(double metres) {
    return String.format(Locale.ROOT, "%.1f", MM * metres);
  }
}
