package org.pendant.script.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.ProgramState;

/**
 * Time that a program is held does not pass for it: blends, sleeps and threads continue unharmed.
 */
class HeldTimeTest {
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
        while i < 2:
          q[0] = q[0] + 0.1
          movej(q, a=3, v=1, r=0.02)
          q[1] = q[1] + 0.05
          movej(q, a=3, v=1, r=0.02)
          textmsg(get_actual_tcp_pose())
          i = i + 1
        end
        movej(q)
        kill h
      end
      """;

  /** The arm and the outputs at the end of each frame. */
  private record Moment(Joints positionRad, DigitalLevels levels) {}

  private static Moment moment(DebugFixture fixture) {
    return new Moment(
        fixture.box.drive().actualPositionRad(), fixture.box.signals().digital().levels());
  }

  private static List<Moment> freeRun(DebugFixture fixture) {
    List<Moment> moments = new ArrayList<>();
    fixture.start(PROGRAM);
    while (fixture.machine.state() == ProgramState.RUNNING) {
      fixture.advance(1);
      moments.add(moment(fixture));
    }
    return moments;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void theArmMovesAsIfItHadNeverBeenHeld(long seed) {
    DebugFixture free = new DebugFixture();
    List<Moment> expected = freeRun(free);
    DebugFixture fixture = new DebugFixture();
    Debugger debugger = fixture.debugger;
    Random random = new Random(seed);
    for (int line = 4; line < 20; line++) {
      debugger.set(Breakpoint.at(line));
    }
    fixture.start(PROGRAM);
    List<Moment> moments = new ArrayList<>();
    int stops = 0;
    while (fixture.machine.state() == ProgramState.RUNNING) {
      if (!debugger.state().held() && random.nextInt(8) == 0) {
        debugger.pause();
      }
      if (fixture.advance()) {
        moments.add(moment(fixture));
        continue;
      }
      stops++;
      long heldInFrame = fixture.box.clock().frame();
      fixture.advance();
      assertEquals(heldInFrame, fixture.box.clock().frame());
      if (random.nextBoolean()) {
        debugger.stepOver(fixture.stop().thread());
      } else {
        debugger.resume();
      }
    }
    assertTrue(stops > 50, stops + " stops");
    assertEquals(expected, moments);
    assertEquals(free.messages(), fixture.messages());
  }

  @Test
  void whatIsTakenUpWhileHeldStaysInItsFrame() {
    DebugFixture fixture = new DebugFixture();
    fixture.debugger.set(Breakpoint.at(2));
    fixture.start("def prog():\n  textmsg(1)\n  sync()\n  textmsg(2)\nend\n").go();
    assertEquals(0, fixture.frames);
    fixture.advance();
    fixture.advance();
    assertEquals(0, fixture.frames);
    fixture.resume();
    assertEquals(2, fixture.frames);
  }
}
