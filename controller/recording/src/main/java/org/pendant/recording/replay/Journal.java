package org.pendant.recording.replay;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.Controller;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.rtde.RtdeCommand;
import org.pendant.script.vm.Program;

/**
 * Journal: every command that has changed a controller since it was switched on, as its run's
 * {@link RunJournal} has it. Any thread may ask.
 */
public final class Journal {
  private static final int LOOKED_AT = 10_000;

  private final RunJournal run;
  private final int member;

  /** Of the controller {@code member} of a run. */
  Journal(RunJournal run, int member) {
    this.run = run;
    this.member = member;
  }

  /** As {@link #of(Controller, JournalLimits)}, with the standard limits. */
  public static Journal of(Controller controller) {
    return of(controller, JournalLimits.STANDARD);
  }

  /**
   * Begins to keep the commands of a controller that is alone and must not have run a frame yet.
   * Only for the thread that will drive it.
   *
   * @throws IllegalArgumentException if it has
   */
  public static Journal of(Controller controller, JournalLimits limits) {
    return RunJournal.of(Controllers.of(controller), limits).of(0);
  }

  /** All commands of its run. */
  public RunJournal run() {
    return run;
  }

  /** Which controller of its run it is. */
  public int member() {
    return member;
  }

  /** Whose commands these are. */
  public Controller controller() {
    return run.controllers().all().get(member);
  }

  /**
   * The program that was started last; empty if that was before the newest {@value #LOOKED_AT}
   * commands, or if the journal is full and cannot know.
   */
  public Optional<Program> newestProgram() {
    if (run.full()) {
      return Optional.empty();
    }
    int count = run.size();
    for (int i = count - 1; i >= Math.max(0, count - LOOKED_AT); i--) {
      Optional<Program> started = isOwn(i) ? started(run.entry(i).command()) : Optional.empty();
      if (started.isPresent()) {
        return started;
      }
    }
    return Optional.empty();
  }

  /** Whether command {@code index} of the run is one of this controller. */
  private boolean isOwn(int index) {
    return run.entry(index).member() == member;
  }

  private static Optional<Program> started(Command command) {
    return switch (command) {
      case ProgramCommand.StartProgram start -> Optional.of(start.program());
      case ProgramCommand.ReplaceProgram replace -> Optional.of(replace.program());
      default -> Optional.empty();
    };
  }

  /**
   * A command of the controller.
   *
   * @param frame in which it came into force
   */
  public record Noted(long frame, Command command) {}

  /**
   * The command with which the program started that ran last up to the end of a frame; empty if
   * none did.
   */
  public Optional<Noted> programStart(long frame) {
    for (int i = run.size() - 1; i >= 0; i--) {
      RunJournal.Entry entry = run.entry(i);
      if (isOwn(i) && entry.frame() <= frame && started(entry.command()).isPresent()) {
        return Optional.of(new Noted(entry.frame(), entry.command()));
      }
    }
    return Optional.empty();
  }

  /** The commands so far that came into force after the end of a frame, in their order. */
  public List<Noted> after(long frame) {
    int count = run.size();
    List<Noted> after = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      RunJournal.Entry entry = run.entry(i);
      if (isOwn(i) && entry.frame() > frame) {
        // where robot time stood, the next frame is the first that shows what came of it
        boolean stood = entry.turn() > 0 && !entry.held();
        after.add(new Noted(entry.frame() + (stood ? 1 : 0), entry.command()));
      }
    }
    return after;
  }

  /**
   * Those who have taken signals by the commands up to here and have not given them back. After a
   * rerun no client stands for these names: a client that continues may want to release them.
   */
  public Set<String> owners() {
    Set<String> owners = new LinkedHashSet<>();
    int count = run.size();
    for (int i = 0; i < count; i++) {
      if (isOwn(i)) {
        follow(run.entry(i).command(), owners);
      }
    }
    return owners;
  }

  private static void follow(Command command, Set<String> owners) {
    switch (command) {
      case RtdeCommand.ClaimInputs claim -> owners.add(claim.owner());
      case IoCommand.ClaimSignal claim -> owners.add(claim.owner());
      case IoCommand.ReleaseSignals release -> owners.remove(release.owner());
      default -> {
        // has nothing to do with it
      }
    }
  }
}
