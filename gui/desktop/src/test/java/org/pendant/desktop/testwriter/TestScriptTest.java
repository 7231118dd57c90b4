package org.pendant.desktop.testwriter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.Question;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

final class TestScriptTest {
  private static final RunEnd END =
      new RunEnd.Finished(
          2000,
          Optional.of(
              new RunEnd.Place(
                  new Joints(0.5, -1.5, -1.5, -1.5, 1.5, 0), new Pose(0.4, -0.2, 0.3, 0, 0, 0))));

  private static Signal output(int index) {
    return new Signal(SignalBank.STANDARD_OUT, index);
  }

  private static String script(RunStep... steps) {
    return script(END, steps);
  }

  private static String script(RunEnd end, RunStep... steps) {
    return TestScript.of(
        new OperatedRun(
            BoxSetup.START_RAD, Pose.ZERO, 1, List.of(), List.of(steps), end, List.of()),
        "pick-2",
        "pick.script",
        signal -> signal.equals("digital_out[1]") ? "gripper" : "");
  }

  private static RunStep.Asked asked(String text, Optional<Answer> answer) {
    return new RunStep.Asked(100, ByteText.asBytes(text), Question.Kind.STRING, answer, 250);
  }

  @Test
  void inputsAreSetAtTheirTimesWhileOutputsAreExpectedInTheirOrder() {
    assertEquals(
        """
        # Written from a run of pick.script that took 4 s.
        # Each expectation has a quarter more time than the program took, and half a second.

        # What people and clients did, at their times since the program started.
        thread operator():
          sleep(0.5)
          set_standard_digital_in(0, True)  # DI0, at 0.5 s
          sleep(0.7)
          set_tool_analog_in(1, 0.012, domain=0)  # tool_analog_in[1], at 1.2 s
          set_configurable_digital_in(3, True)  # CI3, at 1.2 s
        end

        def test_pick_2():
          start("pick.script")
          run operator()
          eventually(get_standard_digital_out(1), within=2)  # DO1 gripper on, at 1 s
          eventually(not get_standard_digital_out(1), within=1)  # DO1 gripper off, at 1.002 s
          wait_for_end(within=5)  # at 4 s
          # joints 28.6, -85.9, -85.9, -85.9, 85.9, 0 degrees, TCP 400.0, -200.0, 300.0 mm
          assert_joints_near(get_actual_joint_positions(), [0.5, -1.5, -1.5, -1.5, 1.5, 0], deg=0.5)
        end
        """,
        script(
            new RunStep.Input(
                250, new SignalWrite.Digital(new Signal(SignalBank.STANDARD_IN, 0), true)),
            new RunStep.Output(500, output(1), true),
            new RunStep.Output(501, output(1), false),
            new RunStep.Input(
                600,
                new SignalWrite.AnalogInput(AnalogBank.TOOL_IN, 1, 0.012, AnalogDomain.CURRENT)),
            new RunStep.Input(
                600, new SignalWrite.Digital(new Signal(SignalBank.CONFIGURABLE_IN, 3), true))));
  }

  @Test
  void ofAQuestionThatNoStringCanHoldTheLongestPieceIsWritten() {
    String test =
        script(asked("Put \"gl\u00fchende Kohlen\" there", Optional.of(new Answer.Text("yes"))));

    assertTrue(
        test.contains("  answer(\"gl\u00fchende Kohlen\", \"yes\", after=0.5)  # asked at 0.2 s"),
        test);
  }

  @Test
  void anAnswerThatNoStringCanHoldIsLeftToPeople() {
    String test = script(asked("Which?", Optional.of(new Answer.Text("the \"red\" one"))));

    assertTrue(test.contains("  # operator: what was answered is not known"), test);
    assertFalse(test.contains("\n  answer("), test);
  }

  @Test
  void whatASwitchedOnControllerDoesNotHaveIsSetBeforeTheStart() {
    String test =
        TestScript.of(
            new OperatedRun(
                new Joints(0, -1.5, 0, 0, 0, 0),
                new Pose(0, 0, 0.125, 0, 0, 1),
                0.25,
                List.of(new SignalWrite.Digital(output(1), true)),
                List.of(),
                END,
                List.of("the arm was guided by hand")),
            "pick",
            "sub/pick.pendant",
            signal -> "");

    assertTrue(
        test.contains(
            """
            #
            # Not in this test:
            # - the arm was guided by hand

            # @start_at 0, -85.9437, 0, 0, 0, 0
            def test_pick():
              set_standard_digital_out(1, True)  # DO1, as before the start
              set_tcp(p[0, 0, 0.125, 0, 0, 1])  # as before the start
              set_speed_slider(0.25)  # as before the start
              start("sub/pick.pendant")
              wait_for_end(within=6)  # at 4 s
            """),
        test);
  }

  @Test
  void aRunLongerThanATestUsuallyTakesHasItsTime() {
    assertTrue(script(new RunEnd.Finished(150_000, Optional.empty())).contains("# @timeout 405\n"));
  }

  @Test
  void ofVeryManyChangesTheFirstOnesAreExpected() {
    List<RunStep> steps = new ArrayList<>();
    for (int i = 0; i < TestScript.MAX_OUTPUTS + 5; i++) {
      steps.add(new RunStep.Output(i, output(1), i % 2 == 0));
    }

    String test = script(steps.toArray(RunStep[]::new));

    assertEquals(TestScript.MAX_OUTPUTS, test.split("eventually\\(", -1).length - 1);
    assertTrue(test.contains("  # 5 more changes of outputs are not looked at\n"), test);
  }
}
