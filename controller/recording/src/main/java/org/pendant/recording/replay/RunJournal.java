package org.pendant.recording.replay;

import static org.pendant.recording.replay.ReplayTexts.text;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import org.pendant.controller.CommandJournal;
import org.pendant.controller.box.Determinism.Loss;
import org.pendant.controller.command.Command;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.time.FrameTime;

/**
 * Run journal: every command that has changed the controllers of a run since they were switched on,
 * with the place where it did. With it and what they were {@linkplain SwitchOn switched on} with,
 * {@link Rerun} makes others that stand at any frame.
 *
 * <p>It is bounded, and it is never thinned out: when it is full, the frames from then on cannot be
 * repeated any more, those before can. The thread that drives the controllers writes it; any thread
 * may ask. A frame without commands costs nothing.
 */
public final class RunJournal {
  private static final int CHUNK = 1024;

  private final Controllers controllers;
  private final JournalLimits limits;
  private final Entry[][] chunks;
  private long bytes;
  private volatile int size;
  private volatile OptionalLong fullFrame = OptionalLong.empty();

  /**
   * A command at its place.
   *
   * @param member number of the controller that got it
   * @param frame that had begun
   * @param turn as in {@link CommandJournal#note}
   * @param held whether a debugger paused the program of this controller then
   * @param before fingerprint of the last snapshot before it
   */
  record Entry(int member, long frame, long turn, boolean held, Command command, long before) {}

  private RunJournal(Controllers controllers, JournalLimits limits) {
    this.controllers = controllers;
    this.limits = limits;
    chunks = new Entry[Math.ceilDiv(limits.mostCommands(), CHUNK)][];
  }

  /** As {@link #of(Controllers, JournalLimits)}, with the standard limits. */
  public static RunJournal of(Controllers controllers) {
    return of(controllers, JournalLimits.STANDARD);
  }

  /**
   * Begins to keep the commands of controllers, which must not have run a frame yet. Only for the
   * thread that will drive them.
   *
   * @throws IllegalArgumentException if they have
   */
  public static RunJournal of(Controllers controllers, JournalLimits limits) {
    long frame = controllers.frame();
    if (frame != 0) {
      throw new IllegalArgumentException(
          "the controller is in frame " + frame + ", must not have run yet");
    }
    RunJournal journal = new RunJournal(controllers, limits);
    journal.begin();
    return journal;
  }

  /**
   * Continues with controllers that have repeated the first {@code count} commands of the run of
   * others. Only for the thread that drives them.
   */
  static RunJournal continuing(RunJournal original, int count, Controllers repeated) {
    RunJournal journal = new RunJournal(repeated, original.limits);
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
    journal.begin();
    return journal;
  }

  private void begin() {
    for (int i = 0; i < controllers.all().size(); i++) {
      int member = i;
      controllers
          .all()
          .get(i)
          .noteCommandsIn((frame, turn, command) -> note(member, frame, turn, command));
    }
  }

  /** Whose commands these are. */
  public Controllers controllers() {
    return controllers;
  }

  /** The commands of one of the controllers. */
  public Journal of(int member) {
    return new Journal(this, member);
  }

  JournalLimits limits() {
    return limits;
  }

  private void note(int member, long frame, long turn, Command command) {
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
    ControllerState before = controllers.all().get(member).state();
    int place = count % CHUNK;
    if (place == 0) {
      chunks[count / CHUNK] = new Entry[CHUNK];
    }
    chunks[count / CHUNK][place] =
        new Entry(
            member,
            frame,
            turn,
            turn > 0 && before.debug().held(),
            kept.get().command(),
            Fingerprint.of(before));
    // last, so that a reader that sees the number sees the command
    size = count + 1;
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
    long newest = controllers.frame();
    long lost = firstLoss().map(Loss::frame).orElse(Long.MAX_VALUE);
    return Math.min(newest, Math.min(lost, fullFrame.orElse(Long.MAX_VALUE)) - 1);
  }

  /** Whether it is full: it does not know the newest commands. */
  boolean full() {
    return fullFrame.isPresent();
  }

  /**
   * Why the run cannot be repeated up to the end of a frame; empty if it can.
   *
   * @param frame 0 for controllers that were just switched on
   */
  public Optional<String> refusal(long frame) {
    long newest = controllers.frame();
    if (frame < 0 || frame > newest) {
      return Optional.of(text("frameOutside", frame, newest));
    }
    Optional<Loss> loss = firstLoss();
    if (loss.isPresent() && loss.get().frame() <= frame) {
      return Optional.of(
          refused(loss.get().frame(), text("mayComeOutOtherwise", loss.get().reason())));
    }
    OptionalLong full = fullFrame;
    if (full.isPresent() && full.getAsLong() <= frame) {
      return Optional.of(
          refused(
              full.getAsLong(),
              text("tooManyCommands", limits.mostCommands(), limits.mostBytes() >> 20)));
    }
    return Optional.empty();
  }

  /** What any of the controllers has lost first. */
  private Optional<Loss> firstLoss() {
    Optional<Loss> first = Optional.empty();
    for (int i = 0; i < controllers.all().size(); i++) {
      Optional<Loss> loss = controllers.all().get(i).determinism().loss();
      if (loss.isPresent() && (first.isEmpty() || loss.get().frame() < first.get().frame())) {
        first = Optional.of(new Loss(loss.get().frame(), controllers.told(i, loss.get().reason())));
      }
    }
    return first;
  }

  private static String refused(long since, String why) {
    return text("onlyBefore", seconds(since), why);
  }

  /** The time of a frame, s, as messages have it. */
  static String seconds(long frame) {
    return String.format(Locale.ROOT, "%.3f", frame * FrameTime.FRAME_S);
  }
}
