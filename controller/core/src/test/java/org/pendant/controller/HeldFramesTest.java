package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramState;

/** A debugger that holds the frame, through the controller's commands and snapshots. */
final class HeldFramesTest {
  private static final String PROGRAM =
      """
      def prog():
        thread blink():
          while True:
            set_standard_digital_out(0, not get_standard_digital_out(0))
            sleep(0.05)
          end
        end
        h = run blink()
        q = get_target_joint_positions()
        i = 0
        while i < 3:
          q[0] = q[0] + 0.1
          movej(q, a=3, v=1)
          q[1] = q[1] + 0.05
          movej(q, a=3, v=1)
          textmsg(get_actual_tcp_pose())
          i = i + 1
        end
        kill h
      end
      """;

  private final Controller controller = new Controller(ControllerOptions.headless());

  /** What a frame brings, without what a held frame hands out early. */
  private static String facts(ControllerState state) {
    return state.frame() + " " + state.arm().actualPositionRad() + state.io() + state.program();
  }

  private void start() {
    send(new ProgramCommand.StartProgram(TestController.program(controller, PROGRAM)));
  }

  private void ask(Consumer<Debugger> request) {
    send(new DebugCommand.Debug(request));
  }

  /** Leaves a command; that it was carried out shows in what follows. */
  private void send(Command command) {
    assertFalse(controller.submit(command).isDone());
  }

  private boolean held() {
    return controller.state().debug().held();
  }

  @Test
  void manyHoldsLeaveTheRunAsItWouldHaveBeen() {
    List<String> free = run(false);
    List<String> interrupted = new HeldFramesTest().run(true);
    assertEquals(free, interrupted);
  }

  private List<String> run(boolean holds) {
    SplittableRandom random = new SplittableRandom(5);
    List<String> frames = new ArrayList<>();
    int stops = 0;
    if (holds) {
      for (int line : new int[] {4, 5, 12, 13, 15, 16}) {
        ask(debugger -> debugger.set(Breakpoint.at(line)));
      }
    }
    start();
    boolean started = false;
    while (!started || controller.state().program().state() != ProgramState.STOPPED) {
      controller.advance();
      started |= controller.state().program().state() == ProgramState.RUNNING;
      if (held()) {
        stops++;
        long frame = controller.state().frame();
        controller.advance();
        assertEquals(frame, controller.state().frame(), "time stands still");
        boolean step = random.nextInt(3) == 0;
        ask(
            debugger -> {
              if (step) {
                debugger.stepOver(debugger.state().stop().orElseThrow().thread());
              } else {
                debugger.resume();
              }
            });
      } else {
        frames.add(facts(controller.state()));
      }
    }
    assertTrue(!holds || stops > 50, stops + " stops");
    return frames;
  }

  @Test
  void theSnapshotSaysWhereAndStopEndsTheProgramThatIsHeld() {
    ask(debugger -> debugger.set(Breakpoint.at(12)));
    start();
    assertTrue(controller.runUntil(this::held, 1000));
    assertEquals(12, controller.state().debug().stop().orElseThrow().line());
    send(new ProgramCommand.StopProgram());
    controller.advance();
    assertFalse(held());
    assertEquals(ProgramState.STOPPED, controller.state().program().state());
  }

  @Test
  void aRequestThatIsNotPossibleIsRefusedWithItsReason() {
    CompletableFuture<Reply> reply =
        controller.submit(new DebugCommand.Debug(debugger -> debugger.set(Breakpoint.at(0))));
    controller.advance();
    assertInstanceOf(Reply.Refused.class, reply.join());
  }
}
