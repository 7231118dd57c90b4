package org.pendant.recording.replay;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.pendant.controller.CommandJournal;
import org.pendant.controller.Controller;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.Determinism;
import org.pendant.controller.command.Command;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.rtde.RtdeCommand;
import org.pendant.models.time.FrameTime;
import org.pendant.script.vm.Program;

/**
 * Journal: every command that has changed a controller since it was switched on, with the place in
 * its run where it did. With it and the controller's options, {@link Rerun} makes another
 * controller that stands at any frame.
 *
 * <p>It is bounded, and it is never thinned out: when it is full, the frames from then on cannot be
 * repeated any more, those before can. The thread that drives the controller writes it; any thread
 * may ask. A frame without commands costs nothing.
 */
public final class Journal {
  private static final int CHUNK = 1024;
  private static final int LOOKED_AT = 10_000;

  private final Controller controller;
  private final JournalLimits limits;
  private final Entry[][] chunks;
  private long bytes;
  private volatile int size;
  private volatile OptionalLong fullFrame = OptionalLong.empty();

  /**
   * A command at its place.
   *
   * @param frame that had begun
   * @param turn as in {@link CommandJournal#note}
   * @param held whether a debugger paused the frame then
   * @param before fingerprint of the last snapshot before it
   */
  record Entry(long frame, long turn, boolean held, Command command, long before) {}

  private Journal(Controller controller, JournalLimits limits) {
    this.controller = controller;
    this.limits = limits;
    chunks = new Entry[Math.ceilDiv(limits.mostCommands(), CHUNK)][];
  }

  /** As {@link #of(Controller, JournalLimits)}, with the standard limits. */
  public static Journal of(Controller controller) {
    return of(controller, JournalLimits.STANDARD);
  }

  /**
   * Begins to keep the commands of a controller, which must not have run a frame yet. Only for the
   * thread that will drive it.
   *
   * @throws IllegalArgumentException if it has
   */
  public static Journal of(Controller controller, JournalLimits limits) {
    long frame = controller.state().frame();
    if (frame != 0) {
      throw new IllegalArgumentException(
          "the controller is in frame " + frame + ", must not have run yet");
    }
    Journal journal = new Journal(controller, limits);
    controller.noteCommandsIn(journal::note);
    return journal;
  }

  /**
   * Continues with a controller that has repeated the first {@code count} commands of another one's
   * run. Only for the thread that drives it.
   */
  static Journal continuing(Journal original, int count, Controller repeated) {
    Journal journal = new Journal(repeated, original.limits);
    for (int i = 0; i < Math.ceilDiv(count, CHUNK); i++) {
      int kept = Math.min(CHUNK, count - i * CHUNK);
      // a chunk that is full does not change any more
      journal.chunks[i] =
          kept == CHUNK
              ? original.chunks[i]
              : Arrays.copyOf(Arrays.copyOf(original.chunks[i], kept), CHUNK);
    }
    for (int i = 0; i < count; i++) {
      journal.bytes += KeptCommand.of(journal.entry(i).command()).map(KeptCommand::bytes).orElse(0);
    }
    journal.size = count;
    repeated.noteCommandsIn(journal::note);
    return journal;
  }

  /** Whose commands these are. */
  public Controller controller() {
    return controller;
  }

  JournalLimits limits() {
    return limits;
  }

  private void note(long frame, long turn, Command command) {
    if (fullFrame.isPresent()) {
      return;
    }
    Optional<KeptCommand> kept = KeptCommand.of(command);
    if (kept.isEmpty()) {
      return;
    }
    int count = size;
    if (count == limits.mostCommands() || bytes + kept.get().bytes() > limits.mostBytes()) {
      fullFrame = OptionalLong.of(frame);
      return;
    }
    bytes += kept.get().bytes();
    int place = count % CHUNK;
    if (place == 0) {
      chunks[count / CHUNK] = new Entry[CHUNK];
    }
    chunks[count / CHUNK][place] =
        new Entry(
            frame,
            turn,
            turn > 0 && controller.state().debug().held(),
            kept.get().command(),
            Fingerprint.of(controller.state()));
    // last, so that a reader that sees the number sees the command
    size = count + 1;
  }

  /**
   * The program that was started last; empty if that was before the newest {@value #LOOKED_AT}
   * commands, or if the journal is full and cannot know.
   */
  public Optional<Program> newestProgram() {
    if (fullFrame.isPresent()) {
      return Optional.empty();
    }
    int count = size;
    for (int i = count - 1; i >= Math.max(0, count - LOOKED_AT); i--) {
      switch (entry(i).command()) {
        case ProgramCommand.StartProgram start -> {
          return Optional.of(start.program());
        }
        case ProgramCommand.ReplaceProgram replace -> {
          return Optional.of(replace.program());
        }
        default -> {}
      }
    }
    return Optional.empty();
  }

  /**
   * A command of the run.
   *
   * @param frame in which it came into force
   */
  public record Noted(long frame, Command command) {}

  /**
   * The command with which the program started that ran last up to the end of a frame; empty if
   * none did.
   */
  public Optional<Noted> programStart(long frame) {
    for (int i = size - 1; i >= 0; i--) {
      Entry entry = entry(i);
      boolean starts =
          entry.command() instanceof ProgramCommand.StartProgram
              || entry.command() instanceof ProgramCommand.ReplaceProgram;
      if (starts && entry.frame() <= frame) {
        return Optional.of(new Noted(entry.frame(), entry.command()));
      }
    }
    return Optional.empty();
  }

  /** The commands so far that came into force after the end of a frame, in their order. */
  public List<Noted> after(long frame) {
    int count = size;
    List<Noted> after = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      Entry entry = entry(i);
      if (entry.frame() > frame) {
        // where robot time stood, the next frame is the first that shows what came of it
        boolean stood = entry.turn() > 0 && !entry.held();
        after.add(new Noted(entry.frame() + (stood ? 1 : 0), entry.command()));
      }
    }
    return after;
  }

  /** How many commands it has. */
  public int size() {
    return size;
  }

  /** Command {@code index} of those that {@link #size} has counted. */
  Entry entry(int index) {
    return chunks[index / CHUNK][index % CHUNK];
  }

  /** The last frame so far up to whose end the run can be repeated; below 0 for none. */
  long lastRepeatable() {
    long newest = controller.state().frame();
    long lost = controller.determinism().loss().map(Determinism.Loss::frame).orElse(Long.MAX_VALUE);
    return Math.min(newest, Math.min(lost, fullFrame.orElse(Long.MAX_VALUE)) - 1);
  }

  /**
   * Why the run cannot be repeated up to the end of a frame; empty if it can.
   *
   * @param frame 0 for a controller that was just switched on
   */
  public Optional<String> refusal(long frame) {
    long newest = controller.state().frame();
    if (frame < 0 || frame > newest) {
      return Optional.of("frame is " + frame + ", must be 0 to " + newest);
    }
    Optional<Determinism.Loss> loss = controller.determinism().loss();
    if (loss.isPresent() && loss.get().frame() <= frame) {
      return Optional.of(
          refused(
              loss.get().frame(),
              loss.get().reason() + ", which may come out otherwise the next time"));
    }
    OptionalLong full = fullFrame;
    if (full.isPresent() && full.getAsLong() <= frame) {
      return Optional.of(
          refused(
              full.getAsLong(),
              "there were more commands than are kept, "
                  + limits.mostCommands()
                  + " or "
                  + (limits.mostBytes() >> 20)
                  + " MB"));
    }
    return Optional.empty();
  }

  private static String refused(long since, String why) {
    return String.format(
        Locale.ROOT,
        "only what was before %.3f s can be run again: then %s",
        since * FrameTime.FRAME_S,
        why);
  }

  /**
   * Those who have taken signals by the commands up to here and have not given them back. After a
   * rerun no client stands for these names: a client that continues may want to release them.
   */
  public Set<String> owners() {
    Set<String> owners = new LinkedHashSet<>();
    int count = size;
    for (int i = 0; i < count; i++) {
      switch (entry(i).command()) {
        case RtdeCommand.ClaimInputs claim -> owners.add(claim.owner());
        case IoCommand.ClaimSignal claim -> owners.add(claim.owner());
        case IoCommand.ReleaseSignals release -> owners.remove(release.owner());
        default -> {
          // has nothing to do with it
        }
      }
    }
    return owners;
  }
}
