package org.pendant.desktop.testwriter;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.message.Question;
import org.pendant.models.pose.Pose;

final class RunWordsTest {
  private static final Path FILE = Path.of("cell", "pick_test.script");

  private static OperatedRun facts(List<RunStep> steps, String... left) {
    return new OperatedRun(
        BoxSetup.START_RAD, Pose.ZERO, 1, List.of(), steps, new RunEnd.Running(10), List.of(left));
  }

  @Test
  void aTestThatHasAllOfItsRunIsSavedAndThatIsAll() {
    assertEquals("Saved pick_test.script", RunWords.saved(FILE, facts(List.of())));
  }

  @Test
  void whatIsMissingIsSaid() {
    RunStep asked = new RunStep.Asked(0, "Which?", Question.Kind.STRING, Optional.empty(), 0);

    assertEquals(
        "Saved pick_test.script. An answer is not known, its line # operator says where it belongs."
            + " Not in it: a; b; and 1 more, which its first lines name",
        RunWords.saved(FILE, facts(List.of(asked), "a", "b", "c")));
  }
}
