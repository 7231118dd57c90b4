package org.pendant.desktop.session;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Drive;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.Pace;
import org.pendant.controller.Robot;
import org.pendant.controller.SteerableClock;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.fault.Faults;
import org.pendant.models.time.FrameTime;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.replay.Journal;
import org.pendant.script.vm.ProgramState;

/** Driven controller: one controller with the thread that drives it, until it is switched off. */
final class DrivenController implements AutoCloseable {
  private static final int FOLLOWED_FRAMES = 5 * FrameTime.FRAMES_PER_SECOND;

  private final SwitchedOn on;
  private final Robot robot;
  private final Drive drive;
  private final SteerableClock clock;
  private final FrameLoop loop;
  private volatile boolean closed;

  /** Whether there is anything to repeat since the repetitions followed last. */
  private boolean happened;

  /**
   * Starts driving a controller.
   *
   * @param listeners told of every frame; may change at any time, so it must allow that
   */
  DrivenController(SwitchedOn on, Pace pace, List<? extends FrameListener> listeners) {
    this.on = on;
    Controller controller = on.controller();
    robot = controller;
    drive = controller;
    clock = new SteerableClock(pace);
    // made once rather than in each frame
    FrameListener record = on.ring()::take;
    FrameListener follow = this::followBehind;
    loop =
        FrameLoop.start(
            controller,
            clock,
            () -> {
              ControllerState state = drive.state();
              tell(record, state);
              tell(on.guest(), state);
              for (FrameListener each : listeners) {
                tell(each, state);
              }
              tell(follow, state);
            });
  }

  /** A fault here would end the loop, and with it the robot. */
  private static void tell(FrameListener listener, ControllerState state) {
    try {
      listener.frame(state);
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
    }
  }

  /** Has the repetitions follow the run, unless people are in a hurry or nothing happens. */
  private void followBehind(ControllerState state) {
    happened |= state.program().state() == ProgramState.RUNNING || !state.arm().rests();
    if (state.frame() % FOLLOWED_FRAMES == 0
        && happened
        && clock.pace() instanceof Pace.Times(double factor)
        && factor <= 1) {
      happened = false;
      on.parked().follow(on.ring().recording().firstFrame());
    }
  }

  SwitchedOn on() {
    return on;
  }

  ControllerOptions options() {
    return on.options();
  }

  Robot robot() {
    return robot;
  }

  Journal journal() {
    return on.journal();
  }

  RecordingRing ring() {
    return on.ring();
  }

  ToolSerialLine tool() {
    return on.tool();
  }

  SteerableClock clock() {
    return clock;
  }

  FrameLoop loop() {
    return loop;
  }

  CompletableFuture<Reply> submit(Command command) {
    CompletableFuture<Reply> reply = robot.submit(command);
    // What was left too late for the last frame gets its answer here.
    if (closed) {
      reply.complete(
          new Reply.Refused(Refusal.Code.SWITCHED_OFF, "the controller is switched off"));
    } else if (loop.failure().isPresent()) {
      reply.complete(
          new Reply.Refused(
              Refusal.Code.SWITCHED_OFF,
              "the controller has failed: " + loop.failure().get().getMessage()));
    }
    return reply;
  }

  /** Switches off; every command that has arrived has its reply then. */
  @Override
  public void close() {
    loop.close();
    closed = true;
    if (loop.failure().isEmpty()) {
      drive.applyCommands();
    }
    on.close();
  }
}
