package org.pendant.gui.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import org.pendant.controller.Command;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.Reply;
import org.pendant.controller.WallClock.Lateness;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.machine.Loaded;
import org.pendant.controller.machine.Program;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.protocols.toolserial.ToolSerialLine;

/**
 * The controller that the desktop works with, and the thread that drives it at the chosen pace. Any
 * thread may call it; no call waits for a frame except {@link #restart} and {@link #close}.
 *
 * <p>What is chained to a reply runs in the frame loop unless an executor is named: views chain
 * with {@code SwingUtilities::invokeLater}.
 */
public final class Session implements AutoCloseable {
  private final List<FrameListener> listeners = new CopyOnWriteArrayList<>();
  private final List<SwitchListener> switchListeners = new CopyOnWriteArrayList<>();
  private final ProgramOrigin origin = new ProgramOrigin();
  private volatile DrivenController driven;

  private Session(ControllerOptions options) {
    listeners.add(origin);
    driven = new DrivenController(SwitchedOn.with(options), Pace.REAL_TIME, listeners);
  }

  /**
   * Switches a controller on, in real time.
   *
   * @throws IllegalArgumentException if the robot or an input is not known
   */
  public static Session start(ControllerOptions options) {
    return new Session(options);
  }

  /** How the controller was switched on. */
  public ControllerOptions options() {
    return driven.options();
  }

  /** The controller; another one after {@link #restart}, so nobody should keep it. */
  public Controller controller() {
    return driven.controller();
  }

  /**
   * The newest snapshot. After {@link #restart} frames, log lines and popups count from 0 again.
   */
  public ControllerState state() {
    return driven.controller().state();
  }

  /** Leaves a command for the next frame; there is one for it even while robot time is paused. */
  public CompletableFuture<Reply> submit(Command command) {
    return driven.submit(command);
  }

  /** Parses, checks and compiles a program; slow, so not for the dispatch thread. */
  public Loaded load(Source source) {
    return driven.controller().load(source);
  }

  /**
   * Starts a program from its beginning; a secondary one runs to its end beside the present one.
   */
  public CompletableFuture<Reply> run(Program program) {
    var _ = submit(new Command.SetProgramsFolder(ProgramsFolder.of(program.source().name())));
    return program.secondary()
        ? submit(new Command.RunSecondary(program))
        : origin.expect(submit(new Command.StartProgram(program)));
  }

  /** How many programs have started that {@link #run} did not start: others have sent them. */
  public long strangersStarted() {
    return origin.strangers();
  }

  /** Whether the program that runs, or ran last, came from others. */
  public boolean strangerLast() {
    return origin.strangerLast();
  }

  /** Pauses the program. */
  public CompletableFuture<Reply> pause() {
    return submit(new Command.PauseProgram());
  }

  /** Goes on with a paused program. */
  public CompletableFuture<Reply> resume() {
    return submit(new Command.ResumeProgram());
  }

  /** Ends the program. */
  public CompletableFuture<Reply> stop() {
    return submit(new Command.StopProgram());
  }

  /** How robot time goes by. */
  public Pace pace() {
    return driven.clock().pace();
  }

  /** Changes how robot time goes by. */
  public void setPace(Pace pace) {
    driven.clock().setPace(pace);
  }

  /** Lets one frame of 2 ms pass while robot time is paused; otherwise nothing happens. */
  public void stepFrame() {
    driven.clock().grant(1);
  }

  /** How punctual the frames are, since the controller was switched on. */
  public Lateness lateness() {
    return driven.clock().lateness();
  }

  /** Has {@code listener} see every frame, also those of controllers to come. */
  public void addFrameListener(FrameListener listener) {
    listeners.add(listener);
  }

  /** Ends {@link #addFrameListener}. */
  public void removeFrameListener(FrameListener listener) {
    listeners.remove(listener);
  }

  /** Has {@code listener} told when the controller is switched off and another one on. */
  public void addSwitchListener(SwitchListener listener) {
    switchListeners.add(listener);
  }

  /** The serial line of the tool connector; another one after {@link #restart}. */
  public ToolSerialLine toolSerial() {
    return driven.tool();
  }

  /** What ended the frame loop although nobody asked for it: a fault of ours. */
  public Optional<Throwable> failure() {
    return driven.loop().failure();
  }

  /**
   * Switches the controller off and another one on, such as for a different robot. Programs end.
   * Waits for the running frame, so not for the dispatch thread.
   *
   * @throws IllegalArgumentException if the robot or an input is not known; nothing has changed
   */
  public void restart(ControllerOptions options) {
    // Made first: where that fails, the old one goes on.
    SwitchedOn next = SwitchedOn.with(options);
    switchListeners.forEach(SwitchListener::switchingOff);
    driven.close();
    driven = new DrivenController(next, pace(), listeners);
    switchListeners.forEach(SwitchListener::switchedOn);
  }

  /** Switches the controller off. */
  @Override
  public void close() {
    switchListeners.forEach(SwitchListener::switchingOff);
    driven.close();
  }
}
