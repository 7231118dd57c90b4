package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.script.vm.ProgramState;

/** Everything is passed by value, whatever copies share behind the scenes. */
class ValueSemanticsTest {
  private static final int PROGRAMS = 60;
  private static final int STATEMENTS = 60;

  @Test
  void copiesNeverSeeEachOthersChanges() {
    for (long seed = 0; seed < PROGRAMS; seed++) {
      RandomAssignments made = new RandomAssignments(new Random(seed));
      String text = made.program(STATEMENTS);
      RunningProgram program = new RunningProgram();
      program.start(text);
      program.finish();
      assertEquals(ProgramState.STOPPED, program.programState());
      String shown = "seed " + seed + "\n" + text + program.reported();
      assertEquals(made.expected(), program.said(), shown);
    }
  }
}
