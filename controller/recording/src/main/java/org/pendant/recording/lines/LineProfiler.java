package org.pendant.recording.lines;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recording;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramState;

/**
 * Line profiler: adds up what each line of a program takes, frame by frame, from the start of one
 * program to that of the next. The thread that drives the controller shows it every frame, which
 * allocates nothing but once a line; any thread may ask for the profile.
 *
 * <p>A frame belongs to the line that the main thread is on at its end. A line is executed once
 * more when the thread comes from another line, and where one line moves the arm again and again,
 * when the arm sets off from rest. Passing a line from itself within a frame, as in a loop of one
 * statement without a move, or a blend from a line into itself, is not seen.
 */
public final class LineProfiler {
  private static final String MOVE = "move";

  /** So many starts are remembered, the newest. */
  private static final int MAX_STARTS = 1000;

  private final Supplier<Optional<Source>> programSource;
  private final Supplier<SafetyConfiguration> safety;
  private final ReentrantLock lock = new ReentrantLock();

  /** The number of each run, by the frame in which it started. */
  private final NavigableMap<Long, Long> starts = new TreeMap<>();

  private long started;
  private long run;
  private String name = "";
  private long firstFrame;
  private Optional<FrameMargins> margins = Optional.empty();
  private BitSet moves = new BitSet();
  private LineSums[] sums = new LineSums[0];
  private int line;
  private long frame = Long.MIN_VALUE;

  /** The program ran on {@code line} in the last frame that was seen. */
  private boolean runs;

  /** The arm has moved since the line began, and rests now. */
  private boolean moved;

  private boolean rests;

  /**
   * Knows of nothing yet.
   *
   * @param programSource the text of the running program, asked in the frame in which one starts
   * @param safety limits and planes, asked then as well
   */
  public LineProfiler(
      Supplier<Optional<Source>> programSource, Supplier<SafetyConfiguration> safety) {
    this.programSource = programSource;
    this.safety = safety;
  }

  /**
   * Takes a frame that has ended; the same frame once more, which a debugger holds, counts once.
   */
  public void see(ControllerState state) {
    see(state, programSource, safety);
  }

  private void see(
      ControllerState state,
      Supplier<Optional<Source>> source,
      Supplier<SafetyConfiguration> limits) {
    if (state.frame() == frame) {
      return;
    }
    lock.lock();
    try {
      // a recording leaves out frames in which nothing has changed
      long leftOut = state.frame() - frame - 1;
      if (runs && leftOut > 0) {
        sums[line].passed(leftOut);
      }
      frame = state.frame();
      for (int i = 0; i < state.newProgramEvents().size(); i++) {
        if (state.newProgramEvents().get(i) instanceof ProgramEvent.Started) {
          begin(state, source.get(), limits.get());
        }
      }
      runs = false;
      if (margins.isPresent() && state.program().line() > 0) {
        add(state, margins.get());
      }
    } finally {
      lock.unlock();
    }
  }

  private void begin(ControllerState state, Optional<Source> source, SafetyConfiguration limits) {
    // of a run that is looked at once more the number is known
    run = starts.computeIfAbsent(state.frame(), start -> ++started);
    if (starts.size() > MAX_STARTS) {
      starts.pollFirstEntry();
    }
    name = state.program().name();
    firstFrame = state.frame();
    margins = Optional.of(new FrameMargins(state.arm(), limits));
    sums = new LineSums[0];
    moves = source.map(LineProfiler::moves).orElseGet(BitSet::new);
    line = 0;
  }

  private static BitSet moves(Source source) {
    BitSet found = new BitSet();
    String text = source.text();
    int number = 1;
    int start = 0;
    for (int at = text.indexOf(MOVE); at >= 0; at = text.indexOf(MOVE, at + 1)) {
      for (int i = start; i < at; i++) {
        if (text.charAt(i) == '\n') {
          number++;
        }
      }
      start = at;
      found.set(number);
    }
    return found;
  }

  private void add(ControllerState state, FrameMargins now) {
    int at = state.program().line();
    now.look(state);
    LineSums sum = of(at);
    if (at != line) {
      line = at;
      moved = false;
      rests = false;
      sum.begin();
    }
    if (state.program().state() == ProgramState.RUNNING) {
      runs = true;
      setOff(state.arm(), at, sum);
      sum.passed(1);
    }
    sum.add(now, state.frame());
  }

  /** Notes whether the arm sets off once more. */
  private void setOff(ArmState arm, int at, LineSums sum) {
    if (arm.speedScaling() == 0 || !moves.get(at)) {
      return;
    }
    if (arm.targetSpeedRadPerS().equals(Joints.ZERO)) {
      rests = moved;
      return;
    }
    if (rests) {
      sum.begin();
    }
    moved = true;
    rests = false;
  }

  private LineSums of(int at) {
    if (at >= sums.length) {
      sums = Arrays.copyOf(sums, Math.max(at + 1, 2 * sums.length));
    }
    if (sums[at] == null) {
      sums[at] = new LineSums();
    }
    return sums[at];
  }

  /**
   * The profiler of a run that continues otherwise from the end of {@code past}, a recording of
   * what this one has seen: it knows of the program that was started last by then, under its
   * number, unless the recording begins later. Slow, so not for the dispatch thread.
   *
   * @param limits limits and planes that hold in the past
   */
  public LineProfiler until(Recording past, SafetyConfiguration limits) {
    Optional<Source> source = past.programOf(past.lastFrame()).map(RecordedProgram::source);
    LineProfiler back = new LineProfiler(programSource, safety);
    lock.lock();
    try {
      back.started = started;
      back.starts.putAll(starts.headMap(past.lastFrame(), true));
    } finally {
      lock.unlock();
    }
    if (!back.starts.isEmpty()) {
      past.frames(
          back.starts.lastKey(),
          past.lastFrame(),
          state -> back.see(state, () -> source, () -> limits));
    }
    return back;
  }

  /** Forgets all that it has seen. */
  public void clear() {
    lock.lock();
    try {
      starts.clear();
      margins = Optional.empty();
      sums = new LineSums[0];
      frame = Long.MIN_VALUE;
      runs = false;
    } finally {
      lock.unlock();
    }
  }

  /**
   * The profile of the last program that runs in a recording; slow, so not for the dispatch thread.
   *
   * @param safety limits and planes to compare with: a recording has none
   */
  public static RunProfile of(Recording recording, SafetyConfiguration safety) {
    Optional<RecordedProgram> last = recording.programs().stream().reduce((first, next) -> next);
    long from = last.map(RecordedProgram::frame).orElseGet(recording::firstFrame);
    LineProfiler profiler = new LineProfiler(() -> last.map(RecordedProgram::source), () -> safety);
    recording.frames(from, recording.lastFrame(), profiler::see);
    return profiler.profile();
  }

  /** What the program that was started last has taken so far. */
  public RunProfile profile() {
    lock.lock();
    try {
      if (margins.isEmpty()) {
        return RunProfile.NONE;
      }
      List<LineStatistics> lines = new ArrayList<>();
      for (int i = 0; i < sums.length; i++) {
        if (sums[i] != null) {
          lines.add(sums[i].statistics(i, margins.get()));
        }
      }
      return new RunProfile(run, name, firstFrame, lines);
    } finally {
      lock.unlock();
    }
  }
}
