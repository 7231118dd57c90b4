package org.pendant.desktop.timeline;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Moment;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingMark;
import org.pendant.script.debug.DebugState;

/**
 * Look back: which moment people look at: the current one, one of what the controller has just
 * done, or one of a file. The controller continues meanwhile. Only the dispatch thread calls it.
 *
 * <p>What is in memory is shown at once. A moment of a file that is not is read outside of that
 * thread: until it is there, views show the moment before, while the timeline is at the new one
 * already ({@link #timeS}).
 */
public final class LookBack {
  /** How much the timeline shows at first, s. */
  private static final double FIRST_WIDTH_S = 60;

  private final Supplier<Recording> ring;
  private final Consumer<String> tell;
  private final RecordingReader<ControllerState> reader;
  private final List<Runnable> listeners = new ArrayList<>();
  private Optional<Opened> file = Optional.empty();
  private Recording recording;
  private Optional<Moment> moment = Optional.empty();
  private Optional<ControllerState> past = Optional.empty();

  /** What is being read and people point at; empty where they point at the moment itself. */
  private Optional<Moment> pending = Optional.empty();

  /** Numbers of the moment that was asked for last, and of the one that is shown. */
  private long askedNumber;

  private long shownNumber;
  private double liveS;
  private TimeRange range = new TimeRange(0, FIRST_WIDTH_S);
  private boolean following = true;

  /** A recording of a file. */
  private record Opened(Recording recording, Path path, List<LogEntry> log) {}

  /**
   * Looks at now.
   *
   * @param ring gives what the controller did, as it is now
   * @param tell hears what went wrong
   */
  public LookBack(Supplier<Recording> ring, Consumer<String> tell) {
    this(ring, tell, RecordingReader.ofWindow("moment"));
  }

  /** As the other one, with a reader of what is not in memory. */
  LookBack(
      Supplier<Recording> ring, Consumer<String> tell, RecordingReader<ControllerState> reader) {
    this.ring = ring;
    this.tell = tell;
    this.reader = reader;
    recording = ring.get();
  }

  /** Has {@code listener} run after each change of the moment or of what the timeline shows. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void changed() {
    listeners.forEach(Runnable::run);
  }

  /** Takes the newest snapshot; about 30 times a second. */
  public void take(ControllerState live) {
    liveS = live.timeS();
    if (file.isPresent()) {
      return;
    }
    recording = ring.get();
    if (moment.isPresent() && moment.get().frame() < recording.firstFrame()) {
      // The bound of memory has caught up: the oldest that is left is shown.
      lookAt(Moment.endOf(recording.firstFrame()));
    }
    if (following) {
      follow(range.widthS());
    }
  }

  /** Has the newest moment at the right end, or where it comes in an early recording. */
  private void follow(double widthS) {
    double toS = Math.max(recording.lastS(), recording.firstS() + widthS);
    range = new TimeRange(toS - widthS, toS);
  }

  /** Has {@link #recording} be what there is now, and answers the moment that people look at. */
  Moment newest(ControllerState live) {
    if (file.isEmpty()) {
      recording = ring.get();
    }
    return pointedAt().orElseGet(() -> Moment.of(live));
  }

  /** What the timeline is about. */
  public Recording recording() {
    return recording;
  }

  /** Whether the views show something other than now. */
  public boolean back() {
    return moment.isPresent();
  }

  /** The moment that people look at; empty for now. */
  public Optional<Moment> moment() {
    return moment;
  }

  /** Whether that is of a file. */
  public boolean ofFile() {
    return file.isPresent();
  }

  /** The file that is looked at. */
  Optional<Path> path() {
    return file.map(Opened::path);
  }

  /** The log of the file that is looked at; empty for none. */
  public Optional<List<LogEntry>> log() {
    return file.map(Opened::log);
  }

  /** What views shall show: {@code live}, or the moment that people look at. */
  public ControllerState shown(ControllerState live) {
    return past.orElse(live);
  }

  /** The snapshot of the moment that people look at; empty for now. */
  public Optional<ControllerState> past() {
    return past;
  }

  /** The moment that people point at, which may still have to be read; empty for now. */
  Optional<Moment> pointedAt() {
    return pending.or(() -> moment);
  }

  /** When the moment is that people point at, robot time in s; empty for now. */
  public OptionalDouble timeS() {
    return pointedAt()
        .map(each -> OptionalDouble.of(seconds(each.frame())))
        .orElse(OptionalDouble.empty());
  }

  /** The line that the program had reached then, from 1; 0 while none ran, and for now. */
  public int line() {
    return past.map(LookBack::lineOf).orElse(0);
  }

  private static int lineOf(ControllerState state) {
    return state.debug().stop().map(DebugState.Stop::line).orElse(state.program().line());
  }

  private static double seconds(long frame) {
    return frame / (double) FrameTime.FRAMES_PER_SECOND;
  }

  /** The text of the program that ran then; empty while none ran, and for now. */
  public Optional<RecordedProgram> program() {
    return past.filter(state -> state.program().line() > 0)
        .flatMap(state -> recording.programAt(seconds(state.frame())));
  }

  /** What must be read before the past can be taken for the present; empty for now. */
  public String banner() {
    if (moment.isEmpty()) {
      return "";
    }
    String at = text(seconds(moment.get().frame()));
    return file.map(
            opened ->
                TimelineTexts.text(
                    "lookingAtRecording", at, opened.path.getFileName(), text(liveS)))
        .orElseGet(() -> TimelineTexts.text("lookingAt", at, text(liveS)));
  }

  /** A time as people read it. */
  static String text(double timeS) {
    return String.format(Locale.ROOT, "%.3f s", timeS);
  }

  // --- moving through time

  /** Looks at a time. */
  public void scrub(double timeS) {
    if (lookAt(Moment.endOf(recording.frameAt(timeS)))) {
      following = false;
      changed();
    }
  }

  /** Looks at a moment of the recording that {@link #recording} answers, and shows it. */
  void jump(Moment wanted) {
    if (lookAt(wanted)) {
      following = false;
      show(seconds(wanted.frame()));
    }
  }

  /** As {@link #scrub}, and has the timeline show it. */
  public void jump(double timeS) {
    scrub(timeS);
    show(timeS);
  }

  private void show(double timeS) {
    range = range.showing(timeS).within(recording.firstS(), recording.lastS());
    changed();
  }

  private boolean lookAt(Moment wanted) {
    long frame = Math.clamp(wanted.frame(), recording.firstFrame(), recording.lastFrame());
    Moment inside = frame == wanted.frame() ? wanted : Moment.endOf(frame);
    if (past.isPresent() && moment.equals(Optional.of(inside))) {
      settle();
      return true;
    }
    if (past.isPresent() && !recording.inMemory(inside)) {
      pending = Optional.of(inside);
      read(recording, inside, ++askedNumber);
      return true;
    }
    try {
      past = Optional.of(recording.at(inside));
      moment = Optional.of(inside);
      settle();
      return true;
    } catch (UncheckedIOException e) {
      unreadable(e.getCause().getMessage());
      return false;
    }
  }

  /** What is still being read is not shown any more. */
  private void settle() {
    shownNumber = ++askedNumber;
    pending = Optional.empty();
    reader.forget();
  }

  private void unreadable(String why) {
    tell.accept(TimelineTexts.text("theRecordingCanNoLongerBe", why));
    live();
  }

  /** Shows a moment when it is read, unless something newer is shown then. */
  private void read(Recording from, Moment wanted, long number) {
    reader.read(
        () -> from.at(wanted),
        state -> {
          if (number > shownNumber) {
            shownNumber = number;
            past = Optional.of(state);
            moment = Optional.of(wanted);
            if (shownNumber == askedNumber) {
              pending = Optional.empty();
            }
            changed();
          }
        },
        why -> {
          if (number > shownNumber) {
            unreadable(why);
          }
        });
  }

  /** Moves by so many frames of 2 ms, back for fewer than none. */
  public void step(long frames) {
    move(frame() + frames);
  }

  private long frame() {
    return pointedAt().map(Moment::frame).orElse(recording.lastFrame());
  }

  private void move(long wanted) {
    long inside = Math.clamp(wanted, recording.firstFrame(), recording.lastFrame());
    jump(seconds(inside));
  }

  /** To the oldest moment. */
  public void first() {
    move(recording.firstFrame());
  }

  /** To the newest moment, which is the past a moment later. */
  public void last() {
    move(recording.lastFrame());
  }

  /**
   * To the next of {@code marks} after, or the last before, the moment.
   *
   * @param marks in the order of time
   * @return whether there is one
   */
  boolean toMark(List<RecordingMark> marks, boolean forward) {
    long from = frame();
    Optional<RecordingMark> found =
        forward
            ? marks.stream().filter(mark -> mark.frame() > from).findFirst()
            : marks.reversed().stream().filter(mark -> mark.frame() < from).findFirst();
    found.ifPresent(mark -> move(mark.frame()));
    return found.isPresent();
  }

  /** Back to now: a file is closed. */
  public void live() {
    moment = Optional.empty();
    past = Optional.empty();
    settle();
    following = true;
    if (file.isPresent()) {
      file = Optional.empty();
      range = new TimeRange(0, FIRST_WIDTH_S);
      recording = ring.get();
    }
    changed();
  }

  /**
   * Looks at the beginning of a recording of a file.
   *
   * @param log all of its log
   */
  public void open(Recording opened, Path path, List<LogEntry> log) {
    file = Optional.of(new Opened(opened, path, log));
    recording = opened;
    past = Optional.empty();
    following = false;
    range = new TimeRange(opened.firstS(), Math.max(opened.lastS(), opened.firstS() + 1));
    lookAt(Moment.endOf(opened.firstFrame()));
    changed();
  }

  // --- what the timeline shows

  /** The stretch that is shown. */
  TimeRange range() {
    return range;
  }

  /** Shows {@code factor} times as much around a time. */
  void zoom(double factor, double timeS) {
    double most = Math.max(FIRST_WIDTH_S, recording.lastS() - recording.firstS());
    double within = Math.min(factor, most / range.widthS());
    TimeRange wanted = range.zoomed(within, timeS);
    if (following) {
      follow(wanted.widthS());
    } else {
      range = wanted.within(recording.firstS(), recording.lastS());
    }
    changed();
  }

  /** Shows what is earlier or later. */
  void pan(double byS) {
    TimeRange wanted = range.moved(byS).within(recording.firstS(), recording.lastS());
    following = !back() && wanted.toS() >= recording.lastS() - wanted.widthS() / 100;
    range = wanted;
    changed();
  }

  /** Shows all there is. */
  void showAll() {
    range =
        new TimeRange(
            recording.firstS(), Math.max(recording.lastS(), recording.firstS() + TimeRange.MIN_S));
    changed();
  }

  /** Why there is nothing to branch from; empty if that is for the controller to say. */
  String whyNoBranch() {
    if (ofFile()) {
      return TimelineTexts.text("aRecordingOfAFileCannot");
    }
    return back() ? "" : TimelineTexts.text("chooseAMomentOnTheTimeline");
  }

  /**
   * Where a branch from the moment begins: at the end of its frame, or of the frame before where
   * the moment is a stop of the debugger that the frame has gone on from. Empty for now.
   */
  Optional<ControllerState> branchStart() {
    if (moment.isEmpty() || moment.get().stop() == 0) {
      return past;
    }
    long frame = moment.get().frame();
    return Moment.of(recording.atFrame(frame)).equals(moment.get())
        ? past
        : Optional.of(recording.atFrame(frame - 1));
  }
}
