package org.pendant.junit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.opentest4j.AssertionFailedError;
import org.pendant.controller.box.ArmChoice;

@Robot(arm = ArmChoice.IDEAL)
class RobotUnderTestTest {
  private static final String WAITS =
      """
      def waits():
        while not get_standard_digital_in(0):
          sync()
        end
        set_standard_digital_out(1, True)
        global seen = 3
        textmsg("seen ", seen)
      end
      """;

  @Test
  void aProgramWaitsForAnInput(RobotUnderTest robot) {
    robot.start(WAITS).advance(Duration.ofSeconds(2));
    assertFalse(robot.output(1));

    robot.setInput("digital_in[0]", true).runToEnd(Duration.ofSeconds(1));

    assertTrue(robot.output(1));
    assertEquals("3", robot.variable("seen").orElseThrow().text());
    assertTrue(robot.log().contains("seen 3"));
    assertEquals(2, robot.timeS(), 0.05);
  }

  @Test
  void anExampleRunsToItsEndAndIsRecorded(RobotUnderTest robot) throws IOException {
    robot.start(Path.of("../../examples/hello.script")).runToEnd();

    assertEquals(robot.state().frame(), robot.recording().lastFrame());
  }

  @Test
  void aProgramThatFailsFailsTheTestWithItsLine(RobotUnderTest robot) {
    robot.start("def p():\n  x = [1]\n  y = x[4]\nend\n");

    AssertionFailedError failure = assertThrows(AssertionFailedError.class, robot::runToEnd);
    assertTrue(failure.getMessage().startsWith("p, line 3: "), failure.getMessage());
  }

  @Test
  void aProgramThatDoesNotCompileIsToldWithItsPlace(RobotUnderTest robot) {
    AssertionFailedError failure =
        assertThrows(
            AssertionFailedError.class, () -> robot.start("def p():\n  x = nothing(1)\nend\n"));
    assertTrue(failure.getMessage().startsWith("program.script:2:7: "), failure.getMessage());
  }

  @Test
  void whatDoesNotComeAboutInTimeFailsTheTest(RobotUnderTest robot) {
    assertThrows(
        AssertionFailedError.class,
        () -> robot.start(WAITS).advanceUntil(each -> robot.output(1), Duration.ofSeconds(1)));
  }

  @Test
  void anInputThatThereIsNotIsRefused(RobotUnderTest robot) {
    assertThrows(IllegalArgumentException.class, () -> robot.setInput("digital_in[9]", true));
  }

  @Test
  void aTestHasSeveralRobotsOfSeveralKinds(
      RobotUnderTest one, @Robot(model = "ur10e") RobotUnderTest other) {
    assertEquals("ur5e", one.state().arm().description().id());
    assertEquals("ur10e", other.state().arm().description().id());
  }
}
