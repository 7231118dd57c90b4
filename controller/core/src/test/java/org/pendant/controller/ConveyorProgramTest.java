package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ArmState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;

/** Programs that move along with conveyors, from outside. */
@Tag("slow")
final class ConveyorProgramTest {
  private static final double FRAME_S = 0.002;

  /** 0.1 m/s, ten ticks a frame. */
  private static final double TICKS_PER_S = 5000;

  private static final double BELT_M_PER_S = 0.1;

  private static final String TRACK = "track_conveyor_linear(p[0, 2, 0, 0, 0, 0], 50000)\n";

  private static final String CIRCLE =
      """
      def circle():
        movej([-0.4, -1.4, -1.7, -1.6, 1.57, 0])
        sleep(0.5)
        %s
        sleep(1)
        start = get_target_tcp_pose_along_path()
        textmsg("draws")
        movec(pose_add(start, p[0.05, 0.05, 0, 0, 0, 0]), pose_add(start, p[0.1, 0, 0, 0, 0, 0]), 0.5, 0.1)
        movec(pose_add(start, p[0.05, -0.05, 0, 0, 0, 0]), start, 0.5, 0.1)
        textmsg("drawn")
        sleep(0.1)
      end
      """;

  private static Pose tcp(RunningProgram running) {
    return running.state().arm().targetTcpInBase();
  }

  private static RunningProgram withBelt(double ticksPerS) {
    RunningProgram running = new RunningProgram();
    running.done(new WorldCommand.RunEncoder(0, ticksPerS));
    return running;
  }

  private static List<Pose> drawn(RunningProgram running) {
    running.until("draws");
    List<Pose> poses = new ArrayList<>();
    while (!running.said().contains("drawn")) {
      running.advance(1);
      poses.add(tcp(running));
      assertEquals(ProgramState.RUNNING, running.programState(), () -> "" + running.reported());
    }
    return poses;
  }

  @Test
  void aCircleDrawnOnAMovingBeltIsACircleOnTheBelt() {
    RunningProgram still = new RunningProgram();
    still.start(CIRCLE.formatted(""));
    List<Pose> circle = drawn(still);
    RunningProgram moving = withBelt(TICKS_PER_S);
    moving.start(CIRCLE.formatted(TRACK));
    List<Pose> carried = drawn(moving);
    assertEquals(circle.size(), carried.size());
    double begin = carried.getFirst().y() - circle.getFirst().y();
    for (int k = 0; k < circle.size(); k++) {
      double belt = begin + k * BELT_M_PER_S * FRAME_S;
      Pose onBelt = carried.get(k).with(1, carried.get(k).y() - belt);
      assertTrue(
          Poses.distance(circle.get(k), onBelt) < 1e-6,
          "frame " + k + ": " + onBelt + " for " + circle.get(k));
    }
  }

  @Test
  void theToolIsWhereTheBeltHasTakenItSinceTrackingBegan() {
    RunningProgram running = withBelt(TICKS_PER_S);
    running.start(
        """
        def follow():
          sleep(0.5)
          ticks = encoder_get_tick_count(0)
          track_conveyor_linear(p[0, 2, 0, 0, 0, 0], 50000)
          sleep(1)
          here = get_target_tcp_pose()
          along = get_target_tcp_pose_along_path()
          travel = encoder_unwind_delta_tick_count(0, encoder_get_tick_count(0) - ticks) / 50000
          textmsg(floor(1000000 * norm(here[1] - along[1] - travel) + 0.5))
          textmsg(floor(1000000 * norm(here[0] - along[0]) + 0.5))
          speed = get_target_tcp_speed()
          textmsg(floor(10000 * speed[1] + 0.5))
          speed = get_target_tcp_speed_along_path()
          textmsg(floor(10000 * speed[1] + 0.5))
        end
        """);
    running.finish();
    assertEquals(List.of("0", "0", "1000", "0"), running.said(), () -> "" + running.reported());
  }

  /** Joint accelerations stay within what a stop of the fastest joint may have. */
  private static final class Smoothness {
    private final double mostRadPerS2;
    private Joints before = Joints.ZERO;
    private double largest;

    Smoothness(double mostRadPerS2) {
      this.mostRadPerS2 = mostRadPerS2;
    }

    void see(ArmState arm) {
      Joints speed = arm.targetSpeedRadPerS();
      largest = Math.max(largest, speed.maxAbsDifference(before) / FRAME_S);
      before = speed;
    }

    void check() {
      assertTrue(largest <= mostRadPerS2, "acceleration " + largest + " rad/s²");
    }
  }

  @Test
  void takesUpARunningBeltWithoutAJumpAndComesToRestFromIt() {
    RunningProgram running = withBelt(3 * TICKS_PER_S);
    running.start(
        """
        def follow():
          movej([-0.6, -1.4, -1.7, -1.6, 1.57, 0])
          textmsg("tracks")
          track_conveyor_linear(p[0, 1, 0, 0, 0, 0], 50000)
          sleep(0.8)
          textmsg("stops")
          stop_conveyor_tracking(a=10)
          textmsg("rests")
          sleep(0.1)
        end
        """);
    running.until("tracks");
    Smoothness start = new Smoothness(8);
    start.see(running.state().arm());
    while (!running.said().contains("stops")) {
      start.see(running.state().arm());
      running.advance(1);
      assertEquals(ProgramState.RUNNING, running.programState(), () -> "" + running.reported());
    }
    start.check();
    Smoothness stop = new Smoothness(10.001);
    stop.before = running.state().arm().targetSpeedRadPerS();
    while (!running.said().contains("rests")) {
      running.advance(1);
      stop.see(running.state().arm());
      assertEquals(ProgramState.RUNNING, running.programState(), () -> "" + running.reported());
    }
    stop.check();
    assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
    running.finish();
    assertTrue(running.reported().isEmpty(), () -> "" + running.reported());
  }

  @Test
  void theSpeedSliderSlowsMovesButNoBelt() {
    RunningProgram running = withBelt(TICKS_PER_S);
    running.start(CIRCLE.formatted(TRACK));
    running.until("draws");
    running.done(new BoxCommand.SetSpeedFraction(0));
    running.advance(200);
    Pose before = tcp(running);
    running.advance(250);
    assertEquals(0.5 * BELT_M_PER_S, tcp(running).y() - before.y(), 1e-6);
    assertEquals(before.x(), tcp(running).x(), 1e-9);
  }

  @Test
  void aPausedProgramGoesOnWithTheBelt() {
    RunningProgram running = withBelt(TICKS_PER_S);
    running.start(CIRCLE.formatted(TRACK));
    running.until("draws");
    running.advance(100);
    running.done(new ProgramCommand.PauseProgram());
    running.advance(200);
    Pose before = tcp(running);
    running.advance(250);
    assertEquals(0.5 * BELT_M_PER_S, tcp(running).y() - before.y(), 1e-6);
    assertEquals(before.x(), tcp(running).x(), 1e-9);
    running.done(new ProgramCommand.ResumeProgram());
    running.until("drawn");
  }

  @Test
  void aSafeguardStopHoldsTheArmAndTheBeltIsCaughtUpWithAfterwards() {
    RunningProgram running = withBelt(TICKS_PER_S);
    running.start(CIRCLE.formatted(TRACK));
    running.until("draws");
    running.advance(100);
    running.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    Smoothness stop = new Smoothness(40);
    stop.before = running.state().arm().targetSpeedRadPerS();
    for (int i = 0; i < 300; i++) {
      running.advance(1);
      stop.see(running.state().arm());
    }
    stop.check();
    Pose held = tcp(running);
    assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
    running.advance(300);
    assertEquals(held, tcp(running));
    assertEquals(SafetyMode.SAFEGUARD_STOP, running.state().safety().safetyMode());
    Smoothness continuing = new Smoothness(25);
    running.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
    for (int i = 0; i < 3000 && !running.said().contains("drawn"); i++) {
      running.advance(1);
      continuing.see(running.state().arm());
    }
    continuing.check();
    assertTrue(running.said().contains("drawn"), () -> "" + running.reported());
    running.finish();
    assertFalse(running.state().program().ending().orElseThrow() instanceof Ending.Failed);
  }

  @Test
  void aProgramThatEndsLeavesTheBelt() {
    for (boolean stopped : new boolean[] {true, false}) {
      RunningProgram running = withBelt(TICKS_PER_S);
      running.start(TRACK + "sleep(1)\ntextmsg(\"now\")\nsleep(" + (stopped ? 9 : 0.1) + ")\n");
      running.until("now");
      if (stopped) {
        running.done(new ProgramCommand.StopProgram());
      }
      Smoothness stop = new Smoothness(8.001);
      stop.before = running.state().arm().targetSpeedRadPerS();
      for (int i = 0; i < 200; i++) {
        running.advance(1);
        stop.see(running.state().arm());
      }
      stop.check();
      assertEquals(ProgramState.STOPPED, running.programState());
      assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
      running.start("movej([0, -1.4, -1.7, -1.6, 1.57, 0])");
      running.finish();
      assertTrue(running.reported().isEmpty(), () -> "" + running.reported());
    }
  }

  @Test
  void anArmWithoutPowerIsLeftBehindByTheBelt() {
    RunningProgram running = withBelt(TICKS_PER_S);
    running.start(TRACK + "sleep(1)\ntextmsg(\"now\")\nsleep(9)\n");
    running.until("now");
    running.done(new SafetyCommand.PowerOff());
    running.advance(500);
    Pose rests = running.state().arm().actualTcpInBase();
    running.done(new SafetyCommand.PowerOn());
    running.advance(500);
    running.done(new SafetyCommand.ReleaseBrakes());
    running.advance(1500);
    assertEquals(0, Poses.distance(rests, running.state().arm().actualTcpInBase()), 1e-3);
    assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
  }

  @Test
  void aWrappingCountIsNoJump() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        thread belt():
          count = 60000
          while True:
            encoder_set_tick_count(1, count)
            count = count + 20
            if count > 65535:
              count = count - 65536
            end
            sync()
          end
        end
        def wrap():
          encoder_enable_set_tick_count(1, 2)
          encoder_set_tick_count(1, 60000)
          run belt()
          sleep(0.3)
          track_conveyor_linear(p[0, 1, 0, 0, 0, 0], 100000, encoder_index=1)
          sleep(0.8)
          textmsg("follows")
          sleep(0.8)
          textmsg("done")
          sleep(0.1)
        end
        """);
    running.until("follows");
    Pose before = tcp(running);
    int frame = 0;
    while (!running.said().contains("done")) {
      running.advance(1);
      assertEquals(ProgramState.RUNNING, running.programState(), () -> "" + running.reported());
      frame++;
      assertEquals(before.y() + frame * 0.0002, tcp(running).y(), 1e-6, "frame " + frame);
    }
    assertTrue(running.reported().isEmpty(), () -> "" + running.reported());
  }

  @Test
  void pulsesOfInputsMoveTheTool() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        encoder_enable_pulse_decode(0, 1, 8, 9)
        track_conveyor_linear(p[0, 0, 1, 0, 0, 0], 1000)
        sleep(2)
        textmsg(encoder_get_tick_count(0, "raw"))
        sleep(1)
        """);
    double before = tcp(running).z();
    for (int period = 0; period < 5; period++) {
      running.done(new IoCommand.SetInput("configurable_in[0]", true));
      running.done(new IoCommand.SetInput("configurable_in[1]", true));
      running.done(new IoCommand.SetInput("configurable_in[0]", false));
      running.done(new IoCommand.SetInput("configurable_in[1]", false));
    }
    running.until("20");
    assertEquals(before + 0.02, tcp(running).z(), 1e-6);
  }

  @Test
  void endingForceModeDoesNotEndTracking() {
    RunningProgram running = withBelt(TICKS_PER_S);
    running.start(
        "sleep(0.5)\n"
            + TRACK
            + """
            sleep(0.5)
            force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 5, 0, 0, 0], 2, [0.1, 0.1, 0.1, 1, 1, 1])
            sleep(0.5)
            end_force_mode()
            sleep(0.2)
            textmsg("ended")
            sleep(1)
            textmsg("done")
            sleep(0.1)
            """);
    running.until("ended");
    Pose before = tcp(running);
    running.advance(250);
    Pose after = tcp(running);
    assertEquals(0.5 * BELT_M_PER_S, after.y() - before.y(), 1e-6);
    assertEquals(before.z(), after.z(), 1e-6);
    running.until("done");
  }

  @Test
  void aRoundConveyorTurnsTheToolWithItOrNot() {
    for (boolean rotate : new boolean[] {true, false}) {
      RunningProgram running = withBelt(500);
      running.start(
          """
          def round():
            movej([0, -1.4, -1.7, -1.6, 1.57, 0])
            sleep(0.2)
            track_conveyor_circular(p[0.3, 0, 0.2, 0, 0, 0], 6000, %s)
            sleep(1)
            textmsg("follows")
            sleep(0.1)
            movel(pose_add(get_target_tcp_pose_along_path(), p[0.03, 0, 0.05, 0, 0, 0]))
            textmsg("done")
            sleep(0.1)
          end
          """
              .formatted(rotate ? "True" : "False"));
      running.until("follows");
      Pose start = tcp(running);
      running.advance(1);
      double angle = 2 * Math.PI / 6000;
      Pose turn = new Pose(0.3, 0, 0, 0, 0, angle);
      Pose expected = Poses.trans(turn, new Pose(start.x() - 0.3, start.y(), start.z(), 0, 0, 0));
      Pose after = tcp(running);
      assertEquals(0, Poses.pointDistance(expected, after), 1e-7, "rotate " + rotate);
      assertEquals(rotate ? angle : 0, Poses.rotationAngle(start, after), 1e-8);
      running.until("done");
      assertTrue(running.reported().isEmpty(), () -> "" + running.reported());
    }
  }

  @Test
  void aBeltThatLeadsOutOfReachStopsTheProgramWithTheReason() {
    RunningProgram running = withBelt(5 * TICKS_PER_S);
    running.start(TRACK + "sleep(20)\n");
    for (int i = 0; i < 10_000 && running.programState() == ProgramState.RUNNING; i++) {
      running.advance(1);
    }
    assertTrue(
        running.reported().stream()
            .anyMatch(
                text ->
                    text.contains("out of the arm's reach")
                        || text.contains("what carries the tool aside")
                        || text.contains("protective stop")),
        () -> "" + running.reported());
    running.advance(500);
    assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
  }

  @Test
  void movesThatBlendArriveOnTheBeltAsTheyDoOnTheFloor() {
    String moves =
        """
        def chain():
          movej([-0.4, -1.4, -1.7, -1.6, 1.57, 0])
          sleep(0.5)
          %s
          sleep(1)
          start = get_target_tcp_pose_along_path()
          textmsg("draws")
          movel(pose_add(start, p[0.05, 0.05, 0, 0, 0, 0]), 0.5, 0.1, r=0.02)
          movel(pose_add(start, p[0.1, 0, 0, 0, 0, 0]), 0.5, 0.1, r=0.02)
          movej(pose_add(start, p[0.05, -0.05, 0.02, 0, 0, 0]), 1, 0.5, r=0.01)
          movej(start, 1, 0.5)
          textmsg("drawn")
          sleep(0.1)
        end
        """;
    RunningProgram still = new RunningProgram();
    still.start(moves.formatted(""));
    List<Pose> floor = drawn(still);
    RunningProgram moving = withBelt(TICKS_PER_S);
    moving.start(moves.formatted(TRACK));
    List<Pose> carried = drawn(moving);
    assertEquals(floor.size(), carried.size());
    double begin = carried.getFirst().y() - floor.getFirst().y();
    for (int k = 0; k < floor.size(); k++) {
      Pose onBelt = carried.get(k).with(1, carried.get(k).y() - begin - k * BELT_M_PER_S * FRAME_S);
      assertTrue(Poses.distance(floor.get(k), onBelt) < 1e-6, "frame " + k);
    }
  }

  @Test
  void randomBeltsAreFollowedWithinTheLimitsOfTheArm() {
    long seed = 21;
    SplittableRandom random = new SplittableRandom(seed);
    for (int run = 0; run < 12; run++) {
      RunningProgram running = new RunningProgram();
      double x = random.nextDouble(-1, 1);
      double y = random.nextDouble(-1, 1);
      running.start(
          """
          def follow():
            movej([-0.2, -1.4, -1.7, -1.6, 1.57, 0])
            track_conveyor_linear(p[%s, %s, 0, 0, 0, 0], 20000)
            while True:
              movel(pose_add(get_target_tcp_pose_along_path(), p[0, 0, 0.03, 0, 0, 0]), 0.5, 0.1)
              movel(pose_add(get_target_tcp_pose_along_path(), p[0, 0, -0.03, 0, 0, 0]), 0.5, 0.1)
            end
          end
          """
              .formatted(x, y));
      running.advance(1500);
      Smoothness smooth = new Smoothness(12);
      double place = 0;
      for (int part = 0; part < 8; part++) {
        double ticksPerS = random.nextDouble(-4000, 4000);
        int frames = random.nextInt(20, 300);
        if (Math.abs(place + ticksPerS * frames * FRAME_S) > 2500) {
          ticksPerS = -ticksPerS;
        }
        running.done(new WorldCommand.RunEncoder(0, ticksPerS));
        place += ticksPerS * (frames + 1) * FRAME_S;
        smooth.before = running.state().arm().targetSpeedRadPerS();
        for (int i = 0; i < frames; i++) {
          running.advance(1);
          smooth.see(running.state().arm());
        }
      }
      int shown = run;
      assertEquals(
          ProgramState.RUNNING,
          running.programState(),
          () -> "seed " + seed + ", run " + shown + ": " + running.reported());
      smooth.check();
    }
  }
}
