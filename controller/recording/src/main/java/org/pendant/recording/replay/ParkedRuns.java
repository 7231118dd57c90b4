package org.pendant.recording.replay;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import org.pendant.controller.Controller;
import org.pendant.models.time.FrameTime;
import org.pendant.script.value.Value;

/**
 * Parked runs: repetitions of a run that stand at several of its frames, so that a branch or a
 * variant need not go all the way from the switch-on. What one of them takes from here is its own;
 * the next one that is led there takes its place.
 *
 * <p>They are led in the background, one at a time, when somebody {@linkplain #look looks} at a
 * moment of the past or {@link #follow} is called. At most {@value ParkingPlaces#MOST} are kept,
 * and fewer where programs have large values. A run that comes out otherwise once more is not
 * parked any more at all.
 */
public final class ParkedRuns implements AutoCloseable {
  /** What a controller takes that has run a program of moves, without the program's values. */
  private static final long BYTES_EACH = 1L << 20;

  private static final long MAX_BYTES = 48L << 20;

  private static final Comparator<Repetition> BY_FRAME =
      Comparator.comparingLong(Repetition::frame);

  private final RunJournal journal;
  private final SwitchOn switchOn;
  private final Executor background;
  private final ParkingPlaces places;
  private final Object lock = new Object();
  private final List<Repetition> parked = new ArrayList<>();
  private Optional<Repetition> led = Optional.empty();
  private OptionalLong looked = OptionalLong.empty();

  /** The first frame that people can look at. */
  private long oldest;

  private boolean working;
  private boolean ended;

  /** How many wait for the one that is led. */
  private int takers;

  /** About what the largest has taken so far. */
  private long largestBytes = BYTES_EACH;

  private volatile boolean interrupted;

  /**
   * Something to be done.
   *
   * @param goal where a run is missing
   * @param free those that are not needed where they are, or less so
   */
  private record Gap(long goal, List<Repetition> free) {
    /** The closest to where it is missing. */
    Optional<Repetition> nearest() {
      return free.stream().filter(each -> each.frame() <= goal).max(BY_FRAME);
    }
  }

  private record Work(Repetition run, long goal) {}

  /**
   * None yet.
   *
   * @param switchOn that of the run
   * @param background leads them, until nothing is to be done
   */
  public ParkedRuns(RunJournal journal, SwitchOn switchOn, Executor background) {
    this(journal, switchOn, background, new ParkingPlaces(FrameTime.FRAMES_PER_SECOND));
  }

  /** As above, at other places. */
  ParkedRuns(RunJournal journal, SwitchOn switchOn, Executor background, ParkingPlaces places) {
    this.places = places;
    this.journal = journal;
    this.switchOn = switchOn;
    this.background = background;
  }

  /** Never keeps any: all ways go from the switch-on. */
  public static ParkedRuns none(RunJournal journal, SwitchOn switchOn) {
    return new ParkedRuns(journal, switchOn, work -> {});
  }

  /** None yet of a run that goes on from a moment of this one. */
  public ParkedRuns branch(RunJournal branch) {
    return new ParkedRuns(branch, switchOn, background, places);
  }

  /** The commands of the run. */
  public RunJournal journal() {
    return journal;
  }

  /**
   * Somebody looks at a frame, and may want to go on from there; empty for now. Any thread, at next
   * to no cost.
   */
  public void look(OptionalLong frame) {
    synchronized (lock) {
      if (looked.equals(frame)) {
        return;
      }
      looked = frame;
    }
    if (frame.isPresent()) {
      follow();
    }
  }

  /** Has them follow the run, which has gone on. Any thread, at next to no cost. */
  public void follow() {
    follow(0);
  }

  /**
   * As {@link #follow()}.
   *
   * @param recordedFrom the first frame that people can look at
   */
  public void follow(long recordedFrom) {
    synchronized (lock) {
      oldest = Math.max(oldest, recordedFrom);
      if (working || gap().isEmpty()) {
        return;
      }
      working = true;
    }
    background.execute(this::work);
  }

  /**
   * The repetition that is closest before the end of a frame, and if there is none one that was
   * just switched on. It belongs to the caller. Waits for a frame at most.
   */
  public Repetition before(long frame) {
    synchronized (lock) {
      if (closerIsLed(frame)) {
        takeBackLed();
      }
      Optional<Repetition> best = closest(frame);
      best.ifPresent(parked::remove);
      return best.orElseGet(() -> Repetition.begin(journal, switchOn));
    }
  }

  /** Whether what is led just now is closer to a frame than what is parked. */
  private boolean closerIsLed(long frame) {
    long best = closest(frame).map(Repetition::frame).orElse(0L);
    return led.isPresent() && led.get().frame() < frame && led.get().frame() > best;
  }

  /** Has it parked where it is. */
  private void takeBackLed() {
    boolean woken = false;
    takers++;
    interrupted = true;
    while (led.isPresent()) {
      try {
        lock.wait();
      } catch (InterruptedException e) {
        woken = true;
      }
    }
    takers--;
    lock.notifyAll();
    if (woken) {
      Thread.currentThread().interrupt();
    }
  }

  private Optional<Repetition> closest(long frame) {
    // one in the same frame may have got commands that the caller does not know
    return parked.stream().filter(each -> each.frame() < frame).max(BY_FRAME);
  }

  private void work() {
    try {
      Optional<Work> work = begin();
      while (work.isPresent()) {
        lead(work.get());
        work = begin();
      }
    } catch (InterruptedException e) {
      close();
    }
  }

  private Optional<Work> begin() throws InterruptedException {
    synchronized (lock) {
      while (takers > 0) {
        lock.wait();
      }
      interrupted = false;
      Optional<Gap> gap = gap();
      Optional<Work> work = gap.map(each -> new Work(taken(each), each.goal()));
      led = work.map(Work::run);
      working = work.isPresent();
      return work;
    }
  }

  private Repetition taken(Gap gap) {
    Optional<Repetition> nearest = gap.nearest();
    // all that are free are beyond: the last of them is worth least
    nearest
        .or(() -> gap.free().stream().max(BY_FRAME).filter(each -> parked.size() >= most()))
        .ifPresent(parked::remove);
    return nearest.orElseGet(() -> Repetition.begin(journal, switchOn));
  }

  private void lead(Work work) {
    boolean good = false;
    try {
      // asked after the goal was chosen: the commands of all frames up to it are there
      work.run().lead(work.goal(), journal.size(), () -> {}, () -> interrupted);
      good = true;
    } catch (CancellationException e) {
      good = true;
    } catch (RerunRefused e) {
      // whoever wants to branch is told why, by the way from the switch-on
      close();
    } finally {
      park(work.run(), good);
    }
  }

  private void park(Repetition run, boolean good) {
    synchronized (lock) {
      led = Optional.empty();
      if (good && !ended) {
        largestBytes = Math.max(largestBytes, bytes(run));
        parked.add(run);
        while (parked.size() > most()) {
          parked.removeFirst();
        }
      }
      lock.notifyAll();
    }
  }

  private static long bytes(Repetition run) {
    return run.controllers().all().stream().mapToLong(ParkedRuns::bytes).sum();
  }

  private static long bytes(Controller controller) {
    return BYTES_EACH + controller.globals().values().stream().mapToLong(Value::sizeBytes).sum();
  }

  private int most() {
    return (int) Math.min(ParkingPlaces.MAX, MAX_BYTES / largestBytes);
  }

  /** What is to be done next; empty when all stand where they should. */
  private Optional<Gap> gap() {
    if (ended) {
      return Optional.empty();
    }
    List<Repetition> free = new ArrayList<>(parked);
    List<ParkingPlaces.Place> wanted = places.of(oldest, journal.lastRepeatable(), looked);
    for (ParkingPlaces.Place place : wanted.subList(0, Math.min(most(), wanted.size()))) {
      Optional<Repetition> there = free.stream().filter(each -> place.fits(each.frame())).findAny();
      if (there.isEmpty()) {
        return Optional.of(new Gap(place.goal(), free));
      }
      free.remove(there.get());
    }
    return Optional.empty();
  }

  /** The frames of those that are parked, in their order. */
  List<Long> frames() {
    synchronized (lock) {
      return parked.stream().map(Repetition::frame).sorted().toList();
    }
  }

  /** Gives all of them up. */
  @Override
  public void close() {
    synchronized (lock) {
      ended = true;
      interrupted = true;
      parked.clear();
    }
  }
}
