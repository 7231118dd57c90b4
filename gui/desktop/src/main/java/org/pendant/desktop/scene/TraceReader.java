package org.pendant.desktop.scene;

import static org.pendant.desktop.scene.SceneTexts.text;

import java.awt.EventQueue;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.fault.Faults;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Recording;
import org.pendant.recording.lines.Margin;

/**
 * Trace reader: where the arm was, read from recordings, so that no frame is missing however few of
 * them are seen: up to now, or around the moment that people look back at. Only the dispatch thread
 * calls it; what takes long is read outside of that thread and shown when it is there.
 */
public final class TraceReader {
  /** So many frames are read at once: a millisecond. */
  private static final long AT_ONCE_FRAMES = FrameTime.FRAMES_PER_SECOND / 2;

  /** So far before and after a moment that people look back at. */
  private static final long AROUND_FRAMES = 30 * FrameTime.FRAMES_PER_SECOND;

  private final int capacity;
  private final Function<ControllerState, SafetyConfiguration> safety;
  private final Consumer<String> tell;
  private final Executor reading;
  private final Executor dispatch;

  /** What is shown, and what it is of; its trace belongs to the reading while that is busy. */
  private Shown shown;

  private TcpTrace last = TcpTrace.EMPTY;
  private boolean busy;

  /** The way up to now. */
  private Shown live;

  /** Frames before this one are forgotten in it. */
  private long forgotten;

  private Optional<Around> around = Optional.empty();
  private boolean forget;

  /** A trace, and whose it is: a controller, or a recording of a file. */
  private record Shown(Object of, RecordedTrace trace) {}

  /** The trace around the moments from one frame to another. */
  private record Around(Shown shown, long from, long to) {
    boolean holds(Object of, long frame) {
      return shown.of.equals(of) && frame >= from && frame <= to;
    }
  }

  /**
   * Has read nothing.
   *
   * @param capacity points that are remembered, at least 2
   * @param safety limits and planes that hold in a frame; any thread may ask
   * @param tell hears what went wrong
   */
  public TraceReader(
      int capacity, Function<ControllerState, SafetyConfiguration> safety, Consumer<String> tell) {
    this(
        capacity,
        safety,
        tell,
        task -> Thread.ofVirtual().name("trace").start(task),
        EventQueue::invokeLater);
  }

  /**
   * As the other one.
   *
   * @param reading runs what takes long
   * @param dispatch runs what comes of it in the thread that uses this object
   */
  TraceReader(
      int capacity,
      Function<ControllerState, SafetyConfiguration> safety,
      Consumer<String> tell,
      Executor reading,
      Executor dispatch) {
    this.capacity = capacity;
    this.safety = safety;
    this.tell = tell;
    this.reading = reading;
    this.dispatch = dispatch;
    live = new Shown(this, traceFrom(0));
    shown = live;
  }

  private RecordedTrace traceFrom(long frame) {
    return new RecordedTrace(capacity, frame, safety);
  }

  /**
   * Shows where an arm was up to now.
   *
   * @param controller whose arm it is; another one has another past
   * @param recording what that controller did, as it is now
   */
  public void follow(Object controller, Recording recording) {
    if (busy) {
      return;
    }
    if (!live.of.equals(controller)) {
      // what was forgotten stays so where the other one goes on from the same past
      forgotten = Math.min(forgotten, recording.lastFrame());
      live = new Shown(controller, traceFrom(forgotten));
    }
    if (forget) {
      forgetLive();
    }
    readOn(recording, recording.lastFrame());
  }

  /**
   * Shows where an arm was around a moment: all that is shown of now, if the moment is in that.
   *
   * @param of the controller, or the recording of a file
   * @param recording what that has of it
   */
  public void lookAt(Object of, Recording recording, long frame) {
    if (busy) {
      return;
    }
    if (forget) {
      long to = Math.max(frame, shown.trace.next() - 1);
      around = Optional.of(new Around(new Shown(of, traceFrom(to)), shown.trace.oldest(), to));
      forgetLive();
    }
    if (around.isPresent() && around.get().holds(of, frame)) {
      show(around.get().shown);
    } else if (live.of.equals(of) && frame >= live.trace.oldest()) {
      readOn(recording, frame);
    } else {
      readAround(of, recording, frame);
    }
  }

  private void forgetLive() {
    forget = false;
    live.trace.clear();
    forgotten = live.trace.next();
  }

  private void readOn(Recording recording, long to) {
    Shown wanted = live;
    long frames = to - Math.max(recording.firstFrame() - 1, wanted.trace.next() - 1);
    if (frames <= AT_ONCE_FRAMES) {
      try {
        wanted.trace.readTo(recording, to);
      } catch (UncheckedIOException e) {
        unreadable(e);
      }
      show(wanted);
    } else {
      read(wanted, () -> wanted.trace.readTo(recording, to), () -> show(wanted));
    }
  }

  private void readAround(Object of, Recording recording, long frame) {
    long from = Math.max(recording.firstFrame(), frame - AROUND_FRAMES);
    long to = Math.min(recording.lastFrame(), frame + AROUND_FRAMES);
    Shown wanted = new Shown(of, traceFrom(from));
    read(
        wanted,
        () -> wanted.trace.readAround(recording, frame, to),
        () -> {
          // nearer to its ends another one is read, which has more before and after
          long enough = (wanted.trace.oldest() + frame) / 2;
          around = Optional.of(new Around(wanted, enough, (frame + wanted.trace.next()) / 2));
          show(wanted);
        });
  }

  private void read(Shown wanted, Runnable work, Runnable done) {
    if (!shown.of.equals(wanted.of)) {
      last = TcpTrace.EMPTY;
    }
    busy = true;
    reading.execute(
        () -> {
          Runnable told = told(work);
          dispatch.execute(
              () -> {
                busy = false;
                told.run();
                done.run();
              });
        });
  }

  private Runnable told(Runnable work) {
    try {
      work.run();
      return () -> {};
    } catch (UncheckedIOException e) {
      return () -> unreadable(e);
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
      return () -> {};
    }
  }

  private void unreadable(UncheckedIOException e) {
    tell.accept(text("theWayOfTheToolCannot", e.getCause().getMessage()));
  }

  private void show(Shown wanted) {
    shown = wanted;
  }

  /** Forgets what is shown. */
  public void clear() {
    forget = true;
  }

  /**
   * What is shown; the same object until there is something else.
   *
   * @param withElbow whether the way of the elbow is part of it
   * @param colouring the margin that it is coloured by; empty for the speed
   */
  public TcpTrace trace(boolean withElbow, Optional<Margin> colouring) {
    if (!busy) {
      shown.trace.trace().colourBy(colouring);
      last = shown.trace.trace().trace(withElbow);
    }
    return last;
  }
}
