package org.pendant.desktop.testwriter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Answer;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/** Tests that are written from real runs, and run. */
final class WrittenTestTest {
  private static String written(OperatedRun facts) {
    return TestScript.of(facts, "pick", PlayedRun.PROGRAM, signal -> "");
  }

  private static String passes(PlayedRun run, OperatedRun facts) {
    String test = written(facts);
    TestResult result = run.run(test);
    assertEquals(
        Optional.empty(),
        result.failure().map(TestFailure::message),
        () -> test + result.failure());
    assertEquals(TestStatus.PASSED, result.status());
    return test;
  }

  @Test
  void aRunWithInputsPasses() {
    PlayedRun run =
        new PlayedRun()
            .ask(new IoCommand.SetInput("digital_in[3]", true))
            .frames(50)
            .start(
                "  movej([0.2, -1.5, -1.5, -1.5, 1.5, 0])",
                "  while not get_standard_digital_in(0):",
                "    sync()",
                "  end",
                "  set_standard_digital_out(1, True)",
                "  if get_standard_digital_in(3) and read_input_integer_register(7) == 42:",
                "    set_tool_digital_out(1, True)",
                "  end",
                "  movej([0, -1.5, -1.5, -1.5, 1.5, 0])",
                "  while get_standard_digital_in(0) or get_standard_analog_in(1) < 2.4:",
                "    sync()",
                "  end",
                "  set_standard_digital_out(1, False)")
            .frames(300)
            .ask(
                new IoCommand.WriteSignals(
                    new SignalWrite.IntegerRegister(RegisterDirection.INPUT, 7, 42)))
            .frames(500)
            .ask(new IoCommand.SetInput("digital_in[0]", true))
            .frames(900)
            .ask(
                new IoCommand.WriteSignals(
                    new SignalWrite.AnalogInput(
                        AnalogBank.STANDARD_IN, 1, 2.5, AnalogDomain.VOLTAGE)))
            .ask(new IoCommand.SetInput("digital_in[0]", false))
            .toEnd();

    passes(run, run.facts());
    assertEquals(List.of(), run.facts().left());
  }

  @Test
  void aSecondRunBeginsWhereTheFirstOneHasEnded() {
    PlayedRun run = new PlayedRun().frames(10);
    for (double base : new double[] {1.5, -1.5}) {
      run.start(
              "  movej([" + base + ", -1.5, -1.5, -1.5, 1.5, 0])",
              "  set_standard_digital_out(0, True)",
              "  sleep(0.1)",
              "  set_standard_digital_out(0, False)")
          .frames(2)
          .toEnd();
    }

    String test = passes(run, run.facts());

    assertTrue(test.contains("# @start_at 85.943"), test);
  }

  @Test
  void theTcpIsThatOfTheRun() {
    PlayedRun run =
        new PlayedRun()
            .ask(new ManualCommand.SetTool(new ToolCentre(new Pose(0, 0, 0.2, 0, 0, 0), "grip")))
            .frames(10)
            .start("  movel(pose_trans(get_actual_tcp_pose(), p[0, 0, 0.05, 0.3, 0, 0]), v=0.1)")
            .toEnd();

    String test = passes(run, run.facts());

    assertTrue(test.contains("set_tcp(p[0, 0, 0.2, 0, 0, 0])  # as before the start"), test);
  }

  @Test
  void aProgramThatSpeaksToOthersNeedsThemPlayed() {
    PlayedRun run = new PlayedRun().start("  socket_open(\"camera\", 5000)").toEnd();

    assertEquals(
        List.of(
            "the program speaks to other computers, which listen(...) and rpc_answer(...) play"),
        run.facts().left());
  }

  @Test
  void popupsAndQuestionsAreAnsweredAsTheyWere() {
    PlayedRun run =
        new PlayedRun()
            .start(
                "  popup(\"nothing waits for this\")",
                "  popup(\"Insert the \" + \"part\", blocking=True)",
                "  if get_standard_digital_in(2):",
                "    set_standard_digital_out(2, True)",
                "  end",
                "  n = request_integer_from_primary_client(\"How many?\")",
                "  if n == 3 and get_standard_digital_in(4):",
                "    set_standard_digital_out(3, True)",
                "  end",
                "  popup(\"Insert the next one\", blocking=True)",
                "  set_standard_digital_out(4, True)")
            .frames(200)
            .ask(new IoCommand.SetInput("digital_in[2]", true))
            .frames(100)
            .ask(new MessageCommand.AnswerPopup(2))
            .frames(100)
            .ask(new IoCommand.SetInput("digital_in[4]", true))
            .frames(100)
            .ask(new MessageCommand.AnswerQuestion(3, new Answer.Whole(3)))
            .frames(200)
            .ask(new MessageCommand.AnswerPopup(4))
            .toEnd();
    assertTrue(run.state().program().ending().isPresent());

    String test = passes(run, run.facts());

    assertTrue(test.contains("answer(\"How many?\", 3, after=0.4)"), test);
    assertTrue(test.contains("eventually(popup_open(\"Insert the part\")"), test);
  }

  @Test
  void whatNobodyKnowsTheAnswerOfIsAskedForInAComment() {
    PlayedRun run =
        new PlayedRun()
            .start("  n = request_integer_from_primary_client(\"How many?\")")
            .frames(50)
            .ask(new MessageCommand.AnswerQuestion(1, new Answer.Whole(3)))
            .toEnd();

    String test = written(run.factsOfFile());

    assertTrue(
        test.contains(
            "  # operator: what was answered is not known, put it here: answer(\"How many?\", ...),"
                + " a whole number"),
        test);
  }

  @Test
  void pausesAndTheSpeedSliderAreRepeated() {
    PlayedRun run =
        new PlayedRun()
            .ask(new BoxCommand.SetSpeedFraction(0.5))
            .frames(10)
            .start(
                "  movej([1, -1.5, -1.5, -1.5, 1.5, 0])",
                "  set_standard_digital_out(2, True)",
                "  pause",
                "  set_standard_digital_out(2, False)")
            .frames(100)
            .ask(new ProgramCommand.PauseProgram())
            .frames(500)
            .ask(new ProgramCommand.ResumeProgram())
            .frames(100)
            .ask(new BoxCommand.SetSpeedFraction(1))
            .frames(1500)
            .ask(new ProgramCommand.ResumeProgram())
            .toEnd();

    String test = passes(run, run.facts());

    assertTrue(test.contains("set_speed_slider(0.5)  # as before the start"), test);
    assertTrue(test.contains("pause_program()"), test);
    assertTrue(test.contains("eventually(program_paused()"), test);
  }

  @Test
  void aProgramThatFailedHasToFail() {
    PlayedRun run = new PlayedRun().start("  sleep(0.5)", "  x = 1 / 0").toEnd();

    String test = passes(run, run.facts());

    assertTrue(test.contains("assert_program_fails(\""), test);
  }

  @Test
  void aProgramThatPeopleStoppedIsStopped() {
    PlayedRun run =
        new PlayedRun()
            .start("  while True:", "    sleep(0.1)", "  end")
            .frames(700)
            .ask(new ProgramCommand.StopProgram())
            .toEnd();

    String test = passes(run, run.facts());

    assertTrue(test.contains("stop_program()  # at 1.4"), test);
  }

  @Test
  void aProgramThatStillRunsGoesOn() {
    PlayedRun run = new PlayedRun().start("  while True:", "    sleep(0.1)", "  end").frames(700);

    String test = passes(run, run.facts());

    assertTrue(test.contains("always(program_running(), during=1)"), test);
  }

  @Test
  void aSafetyStopIsWhereTheTestEnds() {
    PlayedRun run =
        new PlayedRun()
            .start(
                "  set_standard_digital_out(0, True)",
                "  sleep(1)",
                "  protective_stop()",
                "  sleep(1)")
            .frames(900);

    String test = passes(run, run.facts());

    assertTrue(test.contains("# the safety functions stopped the arm at 1"), test);
  }

  @Test
  void whatNoTestCanRepeatIsSaid() {
    PlayedRun run =
        new PlayedRun()
            .start("  sleep(1)")
            .frames(10)
            .ask(new WorldCommand.PushTool(new Wrench(1, 0, 0, 0, 0, 0)))
            .frames(10)
            .ask(
                new IoCommand.WriteSignals(
                    "client",
                    List.of(new SignalWrite.Digital(new Signal(SignalBank.STANDARD_OUT, 6), true))))
            .toEnd();

    String test = passes(run, run.facts());

    assertTrue(test.contains("# - the arm was pushed or pulled (at 0.02 s)\n"), test);
    assertTrue(test.contains("# - digital_out[6] was written from outside"), test);
  }

  @Test
  void whatChangesAllTheTimeIsLeftOutAndSaid() {
    PlayedRun run = new PlayedRun().start("  sleep(1)").frames(10);
    for (int i = 1; i <= 150; i++) {
      run.ask(
              new IoCommand.WriteSignals(
                  new SignalWrite.FloatRegister(RegisterDirection.INPUT, 2, i / 10.0)))
          .frames(1);
    }
    run.toEnd();

    String test = passes(run, run.facts());

    assertTrue(test.contains("# - input_float_register[2] was changed 150 times\n"), test);
    assertFalse(test.contains("write_input_float_register"), test);
  }

  @Test
  void whereNothingRanThereIsNothingToWrite() {
    assertEquals(Optional.empty(), new PlayedRun().frames(10).any());
  }
}
