package org.pendant.recording.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.InterpreterCommand;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.PowerTimes;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.recording.RecordingRing;

/** A rerun stands where the old run stood, bit for bit, and continues as that did. */
@Tag("slow")
final class RerunTest {
  private static final int BRANCHES = 20;
  private static final long LAST = 1500;

  /** What runs on a controller, and what is done to it. */
  private static List<Arguments> plays() {
    return List.of(
        play("threads and inputs", RerunTest::threadsAndInputs),
        play("slider and pauses", RerunTest::sliderAndPauses),
        play("force and contact", RerunTest::forceAndContact),
        play("a part that is gripped", RerunTest::grippedPart),
        play("popups and questions", RerunTest::popupsAndQuestions),
        play("moved by hand", RerunTest::movedByHand),
        play("pulled by hand", RerunTest::pulledByHand),
        play("interpreted lines", RerunTest::interpretedLines),
        play("stops", RerunTest::stops),
        play("programs from outside", RerunTest::programsFromOutside));
  }

  private static Arguments play(String name, Supplier<Play> play) {
    return Arguments.of(Named.of(name, play));
  }

  private static Play threadsAndInputs() {
    Play play = new Play(ControllerOptions.headless().withSeed(7).withMeasuredNoise(true));
    return play.start(
            """
            def prog():
              count = 0
              seen = [0, 0, 0]
              thread counting():
                while True:
                  enter_critical
                  count = count + 1
                  exit_critical
                  sleep(0.01 + 0.02 * random())
                end
              end
              thread watching():
                while True:
                  if get_standard_digital_in(0):
                    seen[0] = seen[0] + random()
                    set_standard_digital_out(1, not get_standard_digital_out(1))
                  end
                  sync()
                end
              end
              run counting()
              run watching()
              q = get_target_joint_positions()
              while True:
                q[0] = q[0] + 0.3 * random()
                if get_standard_digital_in(2):
                  q[0] = -0.5
                end
                movej(q, a=4, v=2)
                textmsg("at ", [count, q[0]])
                seen[2] = read_input_float_register(3)
              end
            end
            """)
        .at(211, new IoCommand.SetInput("digital_in[0]", true))
        .at(300, new IoCommand.WriteSignals(register(2.5)))
        .at(450, new IoCommand.SetInput("digital_in[0]", false))
        .at(450, new IoCommand.WriteSignals(register(-7)))
        .at(800, new IoCommand.SetInput("digital_in[2]", true))
        .at(900, new WorldCommand.RunEncoder(0, 1234.5))
        .at(1100, new ProgramCommand.StopProgram());
  }

  private static SignalWrite register(double value) {
    return new SignalWrite.FloatRegister(RegisterDirection.INPUT, 3, value);
  }

  private static final String PATH =
      """
      def prog():
        while True:
          movej([0.2, -1.5, -1.6, -1.6, 1.6, 0], a=2, v=1.2, r=0.03)
          movel(p[0.45, -0.05, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.3, r=0.02)
          movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.3, r=0.04)
          movej([0.3, -1.4, -1.7, -1.6, 1.5, 0.2], a=2, v=1.2)
          textmsg(get_actual_tcp_pose())
        end
      end
      """;

  private static Play sliderAndPauses() {
    Play play = new Play(ControllerOptions.headless()).start(PATH);
    SplittableRandom random = new SplittableRandom(11);
    for (int frame = 50; frame < LAST; frame += random.nextInt(10, 90)) {
      switch (random.nextInt(3)) {
        case 0 -> play.at(frame, new ProgramCommand.PauseProgram());
        case 1 -> play.at(frame, new ProgramCommand.ResumeProgram());
        default -> play.at(frame, new BoxCommand.SetSpeedFraction(random.nextDouble(0.05, 1)));
      }
    }
    return play;
  }

  private static Play forceAndContact() {
    SceneObject table =
        new SceneObject.Plane(
            "table", new Vector3(0, 0, 0.3), new Vector3(0, 0, 1), Material.DEFAULT);
    return new Play(
            ControllerOptions.headless()
                .withMeasuredNoise(true)
                .withStart(new Joints(0, -1.5708, -1.5708, -1.5708, 1.5708, 0))
                .withScene(new Scene(List.of(table), Optional.empty(), List.of())))
        .start(
            """
            def press():
              set_tcp(p[0, 0, 0.15, 0, 0, 0])
              here = get_target_tcp_pose()
              movel(p[here[0], here[1], 0.302, here[3], here[4], here[5]], a=1, v=0.25)
              force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, -20, 0, 0, 0], 2,
                [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])
              here = get_target_tcp_pose()
              movel(pose_trans(p[0, 0.1, 0, 0, 0, 0], here), a=0.5, v=0.1)
              textmsg(get_tcp_force())
              end_force_mode()
              textmsg(force())
              sleep(10)
            end
            """)
        .at(700, new WorldCommand.PushTool(new Wrench(3, -4, 5, 0, 0, 0)))
        .at(900, new WorldCommand.PushTool(new Wrench(0, 0, 0, 0, 0, 0)))
        .at(1000, new WorldCommand.PushLink(3, new Vector3(0, 0, 0.1), new Vector3(10, 0, 0)))
        .at(1100, new WorldCommand.LetGo());
  }

  private static Play grippedPart() {
    SceneObject table =
        new SceneObject.Plane(
            "table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT);
    SceneObject part =
        new SceneObject.Box(
            "part",
            new Pose(0.4, -0.09, 0.03, 0, 0, 0.1),
            new Vector3(0.06, 0.04, 0.06),
            Material.DEFAULT,
            1);
    return new Play(
            ControllerOptions.headless()
                .withMeasuredNoise(true)
                .withScene(new Scene(List.of(table, part), Optional.empty(), List.of()))
                .withEquipment(
                    CellEquipment.NONE.and(List.of(DeviceSetup.of("two-finger").orElseThrow()))))
        .start(
            """
            def grip():
              set_tcp(p[0, 0, 0.15, 0, 0, 0])
              movej(p[0.4, -0.1, 0.1, 3.14159265, 0, 0], a=8, v=3)
              movel(p[0.4, -0.1, 0.03, 3.14159265, 0, 0], a=2, v=0.5)
              socket_open("127.0.0.1", 63352)
              socket_set_var("POS", 255)
              sleep(0.6)
              movel(p[0.4, -0.1, 0.2, 3.14159265, 0, 0], a=2, v=0.5)
              socket_set_var("POS", 0)
              sleep(10)
            end
            """);
  }

  private static Play popupsAndQuestions() {
    return new Play(ControllerOptions.headless().withOperator(Operator.present()))
        .start(
            """
            def prog():
              popup("look", "title", False, False, True)
              textmsg("went on")
              part = request_integer_from_primary_client("how many")
              movej([0.1 * part, -1.5, -1.6, -1.6, 1.6, 0], a=2, v=1.2)
              popup("done", "title", True, False, False)
              if request_boolean_from_primary_client("again"):
                textmsg("again ", part)
              end
              sleep(1)
              request_string_from_primary_client("name")
            end
            """)
        .at(60, new MessageCommand.AnswerPopup(1))
        .at(140, new MessageCommand.AnswerQuestion(2, new Answer.Text("no number")))
        .at(200, new MessageCommand.AnswerQuestion(2, new Answer.Whole(3)))
        .at(210, new MessageCommand.ShowPopup("from", "outside"))
        .at(900, new MessageCommand.AnswerPopup(3))
        .at(901, new MessageCommand.AnswerPopup(4))
        .at(950, new MessageCommand.AnswerQuestion(5, new Answer.Bool(true)))
        .at(1480, new MessageCommand.CancelQuestion(6));
  }

  private static Play movedByHand() {
    Play play = new Play(ControllerOptions.headless());
    for (int frame = 10; frame < 400; frame += 17) {
      play.at(frame, new ManualCommand.Jog(new JogMove.TurnJoint(1, -1), 0.7));
    }
    play.at(420, new ManualCommand.StopJog());
    for (int frame = 600; frame < 900; frame += 17) {
      play.at(frame, new ManualCommand.Jog(new JogMove.ToJoints(Joints.ZERO), 1));
    }
    return play.at(1000, new SafetyCommand.SetManualMode(true))
        .at(1100, new WorldCommand.AttachLoad(Optional.of(Payload.of(1, 0, 0, 0.05))))
        .at(1200, new ManualCommand.DeclarePayload(1, new Vector3(0, 0, 0.05), Optional.empty()))
        .at(1300, new SafetyCommand.PowerOff());
  }

  private static Play pulledByHand() {
    Play play = new Play(ControllerOptions.headless());
    for (int frame = 10; frame < 1200; frame += 17) {
      play.at(frame, new ManualCommand.StartFreedrive(FreeAxes.ALL, new FreedriveFrame.Base()));
    }
    for (int frame = 100; frame < 900; frame += 13) {
      play.at(
          frame,
          new WorldCommand.PullLink(
              5, new Vector3(0, 0, 0.05), new Vector3(-0.2, -0.3 - 0.0003 * frame, 0.5)));
    }
    return play.at(905, new WorldCommand.LetGo()).at(1250, new ManualCommand.EndFreedrive());
  }

  private static Play interpretedLines() {
    Play play =
        new Play(ControllerOptions.headless())
            .start("def im():\n  interpreter_mode()\n  textmsg(\"over\")\nend\n")
            .at(20, new InterpreterCommand.Interpret("def double(x): return 2 * x end"))
            .at(20, new InterpreterCommand.Interpret("a = double(random())"))
            .at(21, new InterpreterCommand.AskInterpreter())
            .at(
                40,
                new InterpreterCommand.Interpret(
                    "movej([0.4, -1.5, -1.6, -1.6, 1.6, 0], a=2, v=1.2)"))
            .at(41, new InterpreterCommand.Interpret("clear_interpreter()"))
            .at(41, new InterpreterCommand.Interpret("b = 3"))
            .at(200, new ProgramCommand.AbortMove())
            .at(
                500,
                new InterpreterCommand.Interpret(
                    "movej([0, -1.5, -1.6, -1.6, 1.6, 0], a=2, v=1.2)"))
            .at(501, new InterpreterCommand.Interpret("textmsg(b)"))
            .at(520, new InterpreterCommand.SkipInterpreted())
            .at(1200, new InterpreterCommand.Interpret("end_interpreter()"));
    return play;
  }

  private static Play stops() {
    ControllerOptions options =
        ControllerOptions.headless().withPowerTimes(PowerTimes.ofTotal(0.2));
    Play play = new Play(options).start(PATH);
    return play.at(300, new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true))
        .at(500, new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false))
        .at(700, new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true))
        .at(800, new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, false))
        .at(900, new SafetyCommand.PowerOn())
        .at(1000, new SafetyCommand.ReleaseBrakes())
        .at(1300, new ProgramCommand.StartProgram(play.program(PATH)));
  }

  private static Play programsFromOutside() {
    Play play = new Play(ControllerOptions.headless()).start(PATH);
    String speed = "def fast():\n  speedj([0.5, 0, 0, 0, 0, 0], 1, 2)\n  stopj(1)\nend\n";
    return play.at(
            200, new ProgramCommand.RunSecondary(play.program("sec s():\n  textmsg(1)\nend\n")))
        .at(400, new IoCommand.ClaimSignal("client", "input_float_register[3]"))
        .at(401, new IoCommand.WriteSignals("client", List.of(register(4))))
        .at(402, new IoCommand.WriteSignals(register(5)))
        .at(600, new ProgramCommand.ReplaceProgram(play.program(speed)))
        .at(700, new IoCommand.ReleaseSignals("client"))
        .at(701, new IoCommand.WriteSignals(register(6)))
        .at(1300, new MessageCommand.WriteLog(LogEntry.Level.INFO, "hello"));
  }

  @ParameterizedTest
  @MethodSource("plays")
  void standsWhereTheOldRunStoodAndGoesOnAsThatDid(Supplier<Play> made) throws RerunRefused {
    Play play = made.get().until(LAST);
    SplittableRandom random = new SplittableRandom(LAST);
    for (int i = 0; i < BRANCHES; i++) {
      long frame = random.nextLong(1, LAST);
      Controller branch = play.again(frame).controller();
      String where = "frame " + frame;
      assertEquals(play.frames.get((int) frame - 1), Play.facts(branch.state()), where);
      long until = Math.min(LAST, frame + 200);
      assertEquals(
          play.frames.subList((int) frame, (int) until), play.follow(branch, until), where);
    }
  }

  @ParameterizedTest
  @MethodSource("plays")
  void everyFrameOfTheRerunIsThatOfTheOldRun(Supplier<Play> made) throws RerunRefused {
    Play play = made.get().until(LAST);
    List<List<Object>> again = new ArrayList<>();
    Controller fresh = new Controller(play.options);
    Rerun.to(LAST, play.journal.run())
        .run(Controllers.of(fresh), () -> again.add(Play.facts(fresh.state())));
    assertEquals(play.frames, again);
  }

  @Test
  void anInputThatIsChangedInTheBranchChangesWhatHappens() throws RerunRefused {
    Play play = threadsAndInputs().until(LAST);
    Controller branch = play.again(500).controller();
    var _ = branch.submit(new IoCommand.SetInput("digital_in[2]", true));
    List<List<Object>> other = play.follow(branch, 799);
    assertNotEquals(play.frames.subList(500, 799), other);
    assertFalse(
        branch.state().arm().targetPositionRad().equals(play.frames.get(798).get(2)),
        "the arm goes elsewhere");
  }

  @Test
  void theBranchHasAJournalOfItsOwnFromTheBeginning() throws RerunRefused {
    Play play = threadsAndInputs().until(LAST);
    Journal branch = play.again(850);
    List<List<Object>> went = play.follow(branch.controller(), 950);
    Controller second = Play.again(Rerun.to(950, branch.run()), play.options).controller();
    assertEquals(went.getLast(), Play.facts(second.state()));
  }

  @Test
  void theOldControllerGoesOnUndisturbed() throws RerunRefused {
    Play disturbed = threadsAndInputs().until(600);
    Controller branch = disturbed.again(500).controller();
    var _ = branch.submit(new IoCommand.SetInput("digital_in[2]", true));
    branch.runUntil(() -> false, 100);
    disturbed.until(LAST);
    assertEquals(threadsAndInputs().until(LAST).frames, disturbed.frames);
    assertTrue(disturbed.journal.run().size() > 5);
  }

  @Test
  void noiseOfRestThatTheRecordingHasLeftOutIsNoDifference() throws RerunRefused {
    Play play = new Play(ControllerOptions.headless().withMeasuredNoise(true));
    RecordingRing ring = new RecordingRing(play.controller().state(), Optional::empty);
    for (int i = 0; i < 333; i++) {
      play.controller().advance();
      ring.take(play.controller().state());
    }
    ControllerState recorded = ring.recording().atFrame(333);
    assertNotEquals(
        play.controller().state().arm().actualPositionRad(), recorded.arm().actualPositionRad());
    Controller branch = play.again(recorded).controller();
    assertEquals(Play.facts(play.controller().state()), Play.facts(branch.state()));
  }

  @Test
  void frameZeroIsAFreshController() throws RerunRefused {
    Play play = threadsAndInputs().until(10);
    assertEquals(0, play.again(0).controller().state().frame());
  }
}
