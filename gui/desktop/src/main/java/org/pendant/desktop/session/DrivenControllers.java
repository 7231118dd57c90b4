package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.ReentrantLock;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.Frames;
import org.pendant.controller.Pace;
import org.pendant.controller.SteerableClock;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.fault.Faults;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.Recording;
import org.pendant.recording.lines.LineProfiler;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.script.vm.ProgramState;

/**
 * Driven controllers: one, or those of a cell, with the thread that drives them, until they are
 * switched off.
 */
final class DrivenControllers implements AutoCloseable {
  private static final int FOLLOWED_FRAMES = 5 * FrameTime.FRAMES_PER_SECOND;

  private final Frames frames;
  private final List<SessionMember> members;
  private final List<FrameListener> listeners;
  private final List<CellListener> cellListeners;
  private final SteerableClock clock;
  private final FrameLoop loop;

  /** Held while a frame runs or is told of: what happens between two frames takes it. */
  private final ReentrantLock frame = new ReentrantLock();

  private volatile int shown;

  /** Whether there is anything to repeat since the repetitions followed last. */
  private boolean happened;

  /**
   * Starts driving.
   *
   * @param members one that is alone, or those of a cell
   * @param shown number of the member whose frames are told
   * @param listeners told of every frame of the member that is shown; may change at any time, so it
   *     must allow that
   * @param cellListeners told of every frame of each member; likewise
   */
  DrivenControllers(
      List<SessionMember> members,
      int shown,
      Pace pace,
      List<FrameListener> listeners,
      List<CellListener> cellListeners) {
    frames = members.getFirst().on().frames();
    this.members = List.copyOf(members);
    this.shown = shown;
    this.listeners = listeners;
    this.cellListeners = cellListeners;
    clock = new SteerableClock(pace);
    loop = FrameLoop.start(new GuardedFrames(frames, frame), clock, this::tell);
  }

  private void tell() {
    frame.lock();
    try {
      for (int i = 0; i < members.size(); i++) {
        SessionMember member = members.get(i);
        ControllerState state = member.on().controller().state();
        tell(member.record(), state);
        tell(member.on().guest(), state);
        tell(member.runs(), state);
        if (i == shown) {
          for (FrameListener each : listeners) {
            tell(each, state);
          }
        }
        for (CellListener each : cellListeners) {
          tell(each, member, state);
        }
      }
      followBehind();
    } finally {
      frame.unlock();
    }
  }

  /** A fault here would end the loop, and with it the robot. */
  private static void tell(FrameListener listener, ControllerState state) {
    try {
      listener.frame(state);
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
    }
  }

  private static void tell(CellListener listener, SessionMember member, ControllerState state) {
    try {
      listener.frame(member, state);
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
    }
  }

  /** Has the repetitions follow the run, unless people are in a hurry or nothing happens. */
  private void followBehind() {
    for (int i = 0; i < members.size() && !happened; i++) {
      ControllerState state = members.get(i).state();
      happened = state.program().state() == ProgramState.RUNNING || !state.arm().rests();
    }
    SessionMember first = members.getFirst();
    if (first.state().frame() % FOLLOWED_FRAMES == 0
        && happened
        && clock.pace() instanceof Pace.Times(double factor)
        && factor <= 1) {
      happened = false;
      try {
        first.on().parked().follow(firstRecorded());
      } catch (RuntimeException | Error fault) {
        Faults.report(fault);
      }
    }
  }

  /** The first frame that people can look at. */
  private long firstRecorded() {
    return members.stream().mapToLong(each -> each.recording().firstFrame()).min().orElseThrow();
  }

  List<SessionMember> members() {
    return members;
  }

  /** The member whose frames are told. */
  SessionMember shown() {
    return members.get(shown);
  }

  /** Its number. */
  int shownNumber() {
    return shown;
  }

  /** What each member is, in their order. */
  List<SwitchedOn> on() {
    return members.stream().map(SessionMember::on).toList();
  }

  /**
   * What programs take in the parts of the runs of the members that others repeat; slow.
   *
   * @param again the others, in the order of the members
   */
  List<LineProfiler> linesUntil(List<SwitchedOn> again) {
    List<LineProfiler> lines = new ArrayList<>();
    for (int i = 0; i < members.size(); i++) {
      lines.add(members.get(i).runs().linesUntil(again.get(i)));
    }
    return List.copyOf(lines);
  }

  /**
   * Others in the places of the members, whose runs they repeat, when nobody drives these any more.
   *
   * @param lines by {@link #linesUntil}
   */
  List<SessionMember> repeatedBy(List<SwitchedOn> next, List<LineProfiler> lines) {
    List<SessionMember> repeated = new ArrayList<>();
    for (int i = 0; i < members.size(); i++) {
      repeated.add(members.get(i).repeatedBy(next.get(i), lines.get(i)));
    }
    return List.copyOf(repeated);
  }

  /**
   * What each member was in a frame, in their order; empty where its recording does not reach.
   *
   * @param recorded what the one was that is shown
   * @throws RerunRefused if a recording can no longer be read
   */
  List<Optional<ControllerState>> recordedBeside(ControllerState recorded) throws RerunRefused {
    List<Optional<ControllerState>> all = new ArrayList<>();
    for (SessionMember each : members) {
      all.add(each == shown() ? Optional.of(recorded) : recorded(each, recorded.frame()));
    }
    return all;
  }

  private static Optional<ControllerState> recorded(SessionMember other, long frame)
      throws RerunRefused {
    Recording recording = other.recording();
    if (frame < recording.firstFrame() || frame > recording.lastFrame()) {
      return Optional.empty();
    }
    try {
      return Optional.of(recording.atFrame(frame));
    } catch (UncheckedIOException e) {
      throw new RerunRefused(
          text("theRecordingOfCanNoLonger", other.name(), e.getCause().getMessage()));
    }
  }

  /** Gives back all signals that clients have taken. */
  void releaseSignals() {
    for (SessionMember each : members) {
      for (String owner : each.journal().owners()) {
        var _ = submit(each, new IoCommand.ReleaseSignals(owner));
      }
    }
  }

  /** Has the frames of another member told from now on. */
  void show(int number) {
    between(() -> shown = number);
  }

  /** Runs something between two frames. */
  void between(Runnable work) {
    frame.lock();
    try {
      work.run();
    } finally {
      frame.unlock();
    }
  }

  SteerableClock clock() {
    return clock;
  }

  FrameLoop loop() {
    return loop;
  }

  /** Leaves a command for the next frame. */
  CompletableFuture<Reply> submit(SessionMember member, Command command) {
    loop.failure().ifPresent(fault -> member.end(text("controllerHasFailed", fault.getMessage())));
    return member.submit(command);
  }

  /** Switches off; every command that has arrived has its reply then. */
  @Override
  public void close() {
    loop.close();
    members.forEach(each -> each.end(text("controllerIsSwitchedOff")));
    if (loop.failure().isEmpty()) {
      frames.applyCommands();
    }
    members.forEach(each -> each.on().close());
  }
}
