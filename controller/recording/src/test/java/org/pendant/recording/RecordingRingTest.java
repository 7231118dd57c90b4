package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.message.LogLines;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.Program;

@Tag("slow")
final class RecordingRingTest {
  private static final String BUSY =
      """
      def busy():
        global count = 0
        global words = ["a", "b"]
        thread blink():
          while True:
            set_standard_digital_out(0, not get_standard_digital_out(0))
            count = count + 1
            sleep(0.05)
          end
        end
        run blink()
        movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=3, v=2)
        textmsg("there ", count)
        write_output_float_register(3, 0.5)
        set_tcp(p[0, 0, 0.1, 0, 0, 0])
        words[1] = "c"
        popup("look", "title", blocking=False)
        movel(pose_add(get_actual_tcp_pose(), p[0, 0, -0.1, 0, 0, 0]), v=0.5)
        sleep(0.5)
      end
      """;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final ControllerState start = controller.state();

  private List<ControllerState> run(String text, int frames) {
    return run(controller, text, frames);
  }

  private static List<ControllerState> run(Controller controller, String text, int frames) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    List<ControllerState> states = new ArrayList<>();
    for (int i = 0; i < frames; i++) {
      controller.advance();
      states.add(controller.state());
    }
    return states;
  }

  @Test
  void goesOnFromAFrameOfAnotherRing() {
    List<ControllerState> states = run(BUSY, 3000);
    RecordingRing whole = new RecordingRing(start, Optional::empty);
    states.forEach(whole::take);
    for (int from : new int[] {1, 700, 2048, 3000}) {
      RecordingRing next =
          RecordingRing.continuing(whole.recording(), states.get(from - 1), Optional::empty);
      states.subList(from, 3000).forEach(next::take);
      Recording expected = whole.recording();
      Recording is = next.recording();
      assertEquals(0, is.firstFrame());
      assertEquals(3000, is.lastFrame());
      assertEquals(expected.log(0, 6), is.log(0, 6));
      for (int frame = 0; frame <= 3000; frame += 50) {
        assertEquals(
            expected.atFrame(frame).arm().targetPositionRad(),
            is.atFrame(frame).arm().targetPositionRad());
        assertEquals(expected.atFrame(frame).io(), is.atFrame(frame).io());
      }
    }
  }

  @Test
  void hasOnlyTheFrameItGoesOnFromWhereTheOtherRingBeginsLater() {
    List<ControllerState> states = run(BUSY, 100);
    RecordingRing late = new RecordingRing(states.get(50), Optional::empty);
    RecordingRing next =
        RecordingRing.continuing(late.recording(), states.get(10), Optional::empty);
    assertEquals(11, next.recording().firstFrame());
    assertEquals(11, next.recording().lastFrame());
  }

  @Test
  void givesBackEveryFrame() {
    List<ControllerState> states = run(BUSY, 3000);
    RecordingRing ring = new RecordingRing(start, Optional::empty);
    states.forEach(ring::take);

    Recording recording = ring.recording();
    assertEquals(0, recording.firstFrame());
    assertEquals(3001, recording.frames());
    SameState.assertSame(start, recording.at(0));
    for (ControllerState each : states) {
      SameState.assertSameButAmbient(each, recording.at(each.timeS()));
      SameState.assertSameButAmbient(each, recording.atFrame(each.frame()));
    }
    assertEquals(6.0, recording.lastS());
  }

  @Test
  void everyNthFrameIsGivenWhetherItChangedSomethingOrNot() {
    List<ControllerState> states = run(BUSY, 4000);
    RecordingRing ring = new RecordingRing(start, Optional::empty);
    states.forEach(ring::take);
    Recording recording = ring.recording();
    for (int each : new int[] {1, 4, 999}) {
      List<Long> frames = new ArrayList<>();
      recording.everyNth(
          each,
          150,
          9000,
          state -> {
            frames.add(state.frame());
            SameState.assertSame(recording.atFrame(state.frame()), state);
          });
      List<Long> expected =
          LongStream.rangeClosed(150, 4000).filter(frame -> frame % each == 0).boxed().toList();
      assertEquals(expected, frames);
    }
    recording.everyNth(4, 4001, 9000, state -> fail("there is no such frame"));
  }

  @Test
  void givesBackEveryBitWhileTheArmMoves() {
    List<ControllerState> states = run(BUSY, 200);
    RecordingRing ring = new RecordingRing(start, Optional::empty);
    states.forEach(ring::take);

    for (ControllerState each : states) {
      if (each.arm().moving()) {
        SameState.assertSame(each, ring.recording().atFrame(each.frame()));
      }
    }
    assertTrue(states.getLast().arm().moving(), "nothing was tested");
  }

  @Test
  void anyPartMayChangeInAnyFrame() {
    RandomStates random = new RandomStates(1);
    ControllerState first = random.next();
    RecordingRing ring = new RecordingRing(first, Optional::empty);
    ControllerState before = first;
    for (int i = 0; i < 1200; i++) {
      ControllerState state = random.next();
      if (state.frame() > before.frame()) {
        SameState.assertSameButAmbient(before, ring.recording().atFrame(before.frame()));
      }
      ring.take(state);
      before = state;
    }
  }

  @Test
  void holdsAtTheEndsAndBetweenFrames() {
    List<ControllerState> states = run(BUSY, 100);
    RecordingRing ring = new RecordingRing(start, Optional::empty);
    states.forEach(ring::take);
    Recording recording = ring.recording();

    assertEquals(0, recording.at(-5).frame());
    assertEquals(100, recording.at(1e300).frame());
    assertEquals(50, recording.at(0.1019).frame());
  }

  @Test
  void dropsTheOldestFramesAtItsBound() {
    RecordingRing ring = new RecordingRing(start, Optional::empty, 4 << 20);
    List<ControllerState> states =
        run(
            """
            while True:
              movej([0, -1.5, -1.5, -1.5, 1.5, 0], a=3, v=2)
              movej([0, -1.2, -1.5, -1.5, 1.5, 0], a=3, v=2)
            end
            """,
            8000);
    for (ControllerState each : states) {
      ring.take(each);
      assertTrue(ring.bytes() <= 4 << 20, ring.bytes() + " bytes");
    }

    Recording recording = ring.recording();
    assertTrue(recording.firstFrame() > 1000, "first " + recording.firstFrame());
    assertTrue(recording.frames() > 3000, recording.frames() + " frames");
    for (ControllerState each : states) {
      if (each.frame() >= recording.firstFrame()) {
        SameState.assertSameButAmbient(each, recording.atFrame(each.frame()));
      }
    }
  }

  @Test
  void anArmAtRestDoesNotPushOutWhatWasBefore() {
    List<ControllerState> states = run(BUSY, 3000);
    RecordingRing ring = new RecordingRing(start, Optional::empty, 4 << 20);
    states.forEach(ring::take);
    long before = ring.bytes();
    int hour = 3600 * 500;
    ControllerState last = states.getLast();
    for (int i = 1; i <= hour; i++) {
      ring.take(warmer(last, i));
    }

    assertEquals(0, ring.recording().firstFrame());
    assertEquals(3000 + hour, ring.recording().lastFrame());
    assertTrue(ring.bytes() - before < 1 << 20, ring.bytes() - before + " bytes in an hour");
    double kept = ring.recording().at(1e9).readings().toolTemperatureC();
    assertEquals(20 + hour * 1e-6, kept, 1e-6 * SnapshotEncoder.AMBIENT_FRAMES);
  }

  @Test
  void noiseOfAnArmAtRestDoesNotPushOutWhatWasBefore() {
    Controller noisy = new Controller(ControllerOptions.headless().withMeasuredNoise(true));
    RecordingRing ring = new RecordingRing(noisy.state(), Optional::empty);
    List<ControllerState> states = run(noisy, BUSY, 3000);
    states.forEach(ring::take);
    for (ControllerState each : states) {
      if (!each.armRests()) {
        SameState.assertSameButAmbient(each, ring.recording().atFrame(each.frame()));
      }
    }
    assertTrue(states.stream().anyMatch(ControllerState::armRests), "nothing was tested");

    long before = ring.bytes();
    int fiveMinutes = 5 * 60 * 500;
    for (int i = 0; i < fiveMinutes; i++) {
      noisy.advance();
      ring.take(noisy.state());
    }
    assertTrue(ring.bytes() - before < 1 << 20, ring.bytes() - before + " bytes in 5 min");
  }

  /** A later frame, in which nothing but a temperature is different. */
  private static ControllerState warmer(ControllerState state, int frames) {
    ArmReadings readings = state.readings();
    long frame = state.frame() + frames;
    return new ControllerState(
        frame,
        frame / 500.0,
        0,
        0,
        false,
        state.arm(),
        new ArmReadings(
            readings.accelerationRadPerS2(),
            readings.torqueNm(),
            readings.externalTorqueNm(),
            readings.targetTorqueNm(),
            readings.currentA(),
            readings.targetCurrentA(),
            readings.temperatureC(),
            20 + frames * 1e-6,
            readings.controllerTemperatureC(),
            readings.toolCurrentA(),
            readings.toolAcceleration(),
            readings.flangeWrenchInBase(),
            readings.rawFlangeWrench(),
            readings.payload(),
            readings.mounting(),
            readings.voltages(),
            readings.robotCurrentA(),
            readings.energyConsumedJ(),
            readings.energyDissipatedJ(),
            readings.momentumKgMPerS(),
            readings.deviationRatio(),
            readings.collisionRatio()),
        state.geometry(),
        state.safety(),
        state.program(),
        state.debug(),
        state.io(),
        state.signals(),
        state.modbus(),
        state.devices(),
        state.moved(),
        state.assemblies(),
        state.encoders(),
        state.freedrive(),
        state.variables(),
        state.traced(),
        state.openPopups(),
        state.openQuestions(),
        LogLines.NONE,
        List.of(),
        List.of(),
        List.of(),
        state.newestEntry());
  }

  @Test
  void aRecordingStaysAsItIsWhileTheRingGoesOn() {
    List<ControllerState> states = run(BUSY, 3000);
    RecordingRing ring = new RecordingRing(start, Optional::empty, 2 << 20);
    states.subList(0, 500).forEach(ring::take);
    Recording then = ring.recording();
    states.subList(500, 3000).forEach(ring::take);

    assertEquals(500, then.lastFrame());
    SameState.assertSameButAmbient(states.get(499), then.at(1000));
    SameState.assertSameButAmbient(states.get(99), then.atFrame(100));
  }

  @Test
  void othersReadWhileTheFrameLoopWrites() throws InterruptedException, ExecutionException {
    List<ControllerState> states = run(BUSY, 3000);
    RecordingRing ring = new RecordingRing(start, Optional::empty, 2 << 20);
    AtomicBoolean done = new AtomicBoolean();
    CompletableFuture<Void> reader =
        CompletableFuture.runAsync(
            () -> {
              Random random = new Random(7);
              while (!done.get()) {
                Recording now = ring.recording();
                long frame = now.firstFrame() + random.nextLong(now.frames());
                if (frame > 0) {
                  SameState.assertSameButAmbient(states.get((int) frame - 1), now.atFrame(frame));
                }
              }
            });
    states.forEach(ring::take);
    done.set(true);
    reader.get();
  }

  @Test
  void ofAHeldFrameTheLastSnapshotIsShown() {
    RecordingRing ring = new RecordingRing(start, Optional::empty);
    Program program = TestController.program(controller, "a = 1\na = 2\nsleep(1)\n");
    var _ = controller.submit(new ProgramCommand.StartProgram(program));
    var _ = controller.submit(new DebugCommand.Debug(debugger -> debugger.set(Breakpoint.at(2))));
    advance(ring, 20);
    long heldFrame = controller.state().frame();
    assertTrue(controller.state().debug().held(), "nothing is held");
    assertEquals(controller.state().debug(), ring.recording().atFrame(heldFrame).debug());

    var _ = controller.submit(new DebugCommand.Debug(Debugger::resume));
    advance(ring, 20);
    assertFalse(ring.recording().atFrame(heldFrame).debug().held());
    assertEquals(3, ring.recording().atFrame(heldFrame).program().line());
  }

  private void advance(RecordingRing ring, int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      ring.take(controller.state());
    }
  }
}
