package org.pendant.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.command.CollisionWatcher.Other;
import org.pendant.controller.Cell;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.LinkContact;

/**
 * Shared cell check: runs the programs of all controllers of a cell together in virtual time, while
 * links pass through all there is, and looks at each arm: what it gets into of objects, of its own
 * links and of the other arms.
 */
final class SharedCellCheck {
  /** Of a controller without an arm, of which nothing is to be seen. */
  private static final FrameWatcher NOTHING =
      new FrameWatcher() {
        @Override
        public boolean looks() {
          return false;
        }

        @Override
        public void see(ControllerState state) {
          // is shown nothing
        }

        @Override
        public boolean enough() {
          return false;
        }
      };

  private final CellFile file;
  private final RunOptions options;
  private final List<CellFile.Member> members;
  private final double limitS;
  private final List<CollisionReport> reports = new ArrayList<>();

  /**
   * The check of a cell.
   *
   * @param options for the whole run
   * @param limitS how long programs are watched, s of robot time
   * @throws UsageException if a program cannot be read, or an option is for one controller alone
   */
  SharedCellCheck(CellFile file, RunOptions options, double limitS, Arguments arguments)
      throws UsageException {
    CellPrograms.refuse(file, arguments);
    this.file = file.withLinks(LinkContact.PASS);
    this.options = options;
    this.limitS = limitS;
    members =
        this.file.members(
            arguments,
            (installation, robot) -> RunOptions.of(arguments, installation, robot).controller(),
            CellPrograms.only(file, arguments));
  }

  /** What came of the programs of arms. */
  List<CollisionReport> reports() {
    return List.copyOf(reports);
  }

  /** Runs all programs, if they compile. */
  ExitCode run(Interruption interruption, Console console) throws UsageException {
    List<RunnableFile> files =
        members.stream().flatMap(member -> member.program().stream()).toList();
    files.forEach(each -> each.tell(console));
    Optional<CellPrograms> loaded =
        CellPrograms.load(
            file, members, members.stream().map(CellFile.Member::options).toList(), console);
    if (loaded.isEmpty()) {
      return ExitCode.DOES_NOT_COMPILE;
    }
    if (files.stream().anyMatch(RunnableFile::waits)) {
      return ExitCode.DONE;
    }
    ExitCode code;
    interruption.hold();
    try (WallLimit wall = WallLimit.begin(options.wallTimeoutS(), file.name())) {
      Console silent = console.withoutOutput();
      code =
          new CellRun(
                  loaded.get().cell(),
                  loaded.get().parts(watchers(loaded.get()), silent),
                  options.withoutTimeout(),
                  interruption,
                  wall,
                  silent)
              .run();
    }
    interruption.release();
    reports.forEach(each -> each.tell(console));
    Optional<CollisionReport> cut =
        reports.stream().filter(each -> each.watcher().enough()).findFirst();
    cut.ifPresent(each -> each.tellLimit(limitS, console));
    boolean hit = reports.stream().anyMatch(each -> !each.watcher().collisions().isEmpty());
    return hit ? ExitCode.DOES_NOT_COMPILE : code;
  }

  /** One for each member that runs something. */
  private List<FrameWatcher> watchers(CellPrograms programs) {
    List<FrameWatcher> watchers = new ArrayList<>();
    for (int i = 0; i < programs.members().size(); i++) {
      Optional<RunnableFile> runs = programs.members().get(i).program();
      if (runs.isEmpty()) {
        continue;
      }
      Cell.Member member = programs.cell().members().get(i);
      if (member.armless()) {
        watchers.add(NOTHING);
        continue;
      }
      CollisionWatcher watcher =
          new CollisionWatcher(Cell.surroundings(member), others(programs, i), limitS);
      watchers.add(watcher);
      reports.add(
          new CollisionReport(
              runs.get(), runs.get().source().orElseThrow(), Optional.of(member.name()), watcher));
    }
    return watchers;
  }

  private static List<Other> others(CellPrograms programs, int own) {
    List<Other> others = new ArrayList<>();
    for (int i = 0; i < programs.members().size(); i++) {
      Cell.Member member = programs.cell().members().get(i);
      if (i != own && !member.armless()) {
        others.add(
            new Other(
                member.name(),
                programs.members().get(i).program().map(RunnableFile::file),
                member.controller()::state));
      }
    }
    return others;
  }
}
