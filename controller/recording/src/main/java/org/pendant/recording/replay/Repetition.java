package org.pendant.recording.replay;

import static org.pendant.recording.replay.ReplayTexts.text;

import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import org.pendant.controller.Controller;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramEvent;

/**
 * Repetition: controllers that repeat the run of others, command by command, and can stand at any
 * frame on its way. They are compared with the others before each command, and reach nothing
 * outside before {@link #connect}. One thread at a time leads them.
 */
public final class Repetition {
  private final RunJournal original;
  private final Controllers fresh;
  private final List<AtomicReference<Connectors>> outside;

  /** The first command that they have not got yet. */
  private int next;

  private long turn;

  /** The frame in which each of them has started a program last; 0 before the first. */
  private final long[] startedFrames;

  private Repetition(
      RunJournal original, Controllers fresh, List<AtomicReference<Connectors>> outside) {
    this.original = original;
    this.fresh = fresh;
    this.outside = outside;
    startedFrames = new long[fresh.all().size()];
  }

  /**
   * One that stands where the run began.
   *
   * @param switchOn that of the run that is repeated
   */
  static Repetition begin(RunJournal original, SwitchOn switchOn) {
    List<AtomicReference<Connectors>> outside = nowhere(original.controllers());
    Controllers fresh =
        switchOn.with(outside.stream().map(each -> Connectors.by(each::get)).toList());
    return new Repetition(original, fresh, outside);
  }

  private static List<AtomicReference<Connectors>> nowhere(Controllers controllers) {
    return controllers.all().stream().map(_ -> new AtomicReference<>(Connectors.NONE)).toList();
  }

  /** As {@link #begin}, with controllers that were switched on in the same way. */
  static Repetition with(RunJournal original, Controllers fresh) {
    long frame = fresh.frame();
    if (frame != 0) {
      throw new IllegalArgumentException(
          "the controller is in frame " + frame + ", must not have run yet");
    }
    return new Repetition(original, fresh, nowhere(fresh));
  }

  /** The controllers, in their order. */
  public Controllers controllers() {
    return fresh;
  }

  /** The frame that they stand in; any thread. */
  public long frame() {
    return fresh.frame();
  }

  /** The frame in which a controller has started a program last; empty if it has not. */
  public OptionalLong startedFrame(int member) {
    return startedFrames[member] == 0
        ? OptionalLong.empty()
        : OptionalLong.of(startedFrames[member]);
  }

  /** Has a controller reach other computers by {@code connectors} from now on. */
  public void connect(int member, Connectors connectors) {
    outside.get(member).set(connectors);
  }

  /**
   * Has them go on as a run of its own.
   *
   * @return its commands so far, and those to come
   */
  RunJournal goOn() {
    return RunJournal.continuing(original, next, fresh);
  }

  /**
   * Leads them on to the end of a frame, or up to where a debugger pauses that.
   *
   * @param frame not before the one that they stand in
   * @param commands of the other run that are known; all of those up to that frame
   * @param each runs after each step on the way
   * @throws RerunRefused if it came out otherwise
   * @throws CancellationException as soon as {@code cancelled} says so; they can be led on after
   *     that
   */
  void lead(long frame, int commands, Runnable each, BooleanSupplier cancelled)
      throws RerunRefused {
    while (!arrived(frame, commands)) {
      if (cancelled.getAsBoolean()) {
        throw new CancellationException(text("rerunCancelled"));
      }
      long before = fresh.frame();
      boolean begins = !fresh.frames().held() && !isIn(before, commands);
      turn = begins ? 0 : turn + 1;
      long step = before + (begins ? 1 : 0);
      submit(step, commands);
      if (begins) {
        fresh.frames().advance();
      } else {
        fresh.frames().applyCommands();
      }
      seePrograms();
      each.run();
      if (isIn(step, commands)) {
        refuseUnlessHeld(original.entry(next));
      }
    }
  }

  private void seePrograms() {
    for (int i = 0; i < startedFrames.length; i++) {
      ControllerState state = fresh.all().get(i).state();
      for (ProgramEvent event : state.newProgramEvents()) {
        if (event instanceof ProgramEvent.Started) {
          startedFrames[i] = state.frame();
        }
      }
    }
  }

  /** What came while a debugger had paused a program must come so again. */
  private void refuseUnlessHeld(RunJournal.Entry entry) throws RerunRefused {
    if (entry.held() && !fresh.all().get(entry.member()).held()) {
      throw otherwise(entry.frame(), fresh.told(entry.member(), text("debuggerDidNotPause")));
    }
  }

  private boolean arrived(long frame, int commands) throws RerunRefused {
    long stands = fresh.frame();
    if (isIn(stands, commands)) {
      return false;
    }
    if (!fresh.frames().held()) {
      return stands == frame;
    }
    if (stands < frame) {
      throw otherwise(stands, text("debuggerPaused"));
    }
    return true;
  }

  /** Whether the next command belongs to a frame. */
  private boolean isIn(long wanted, int commands) {
    return next < commands && original.entry(next).frame() == wanted;
  }

  /** Leaves the commands of the next step. */
  private void submit(long begun, int commands) throws RerunRefused {
    while (isIn(begun, commands) && original.entry(next).turn() == turn) {
      RunJournal.Entry entry = original.entry(next);
      Controller controller = fresh.all().get(entry.member());
      if (entry.before() != Fingerprint.of(controller.state())) {
        throw otherwise(begun - 1, fresh.told(entry.member(), text("stateNotAsBefore")));
      }
      if (controller.submit(entry.command()).isDone()) {
        // never so for as many as come into force in a frame, but a debugger may be asked for more
        throw otherwise(begun, text("tooManyCommandsInFrame"));
      }
      next++;
    }
  }

  static RerunRefused otherwise(long frame, String what) {
    return new RerunRefused(text("cameOutOtherwise", RunJournal.seconds(frame), what));
  }
}
