package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Source;

class ProgramLabelTest {
  private static final String JOB =
      """
      def job():
        $ 1 "Program"
        def nod():
          $ 5 "Nod" "noBreak"
          sync()
        end
        while True:
          $ 2 "Loop"
          $ "no number"
          nod()
        end
      end
      """;

  private final List<ProgramLabel> labels =
      ProgramLoader.load(Source.of("job", JOB), new MachineFixture().builtins)
          .program()
          .orElseThrow()
          .labels();

  @Test
  void aProgramKnowsItsNumberedLabelsByTheirLines() {
    assertEquals(
        List.of(
            new ProgramLabel(2, 1, "Program"),
            new ProgramLabel(4, 5, "Nod"),
            new ProgramLabel(8, 2, "Loop")),
        labels);
  }

  @Test
  void theOneThatWasPassedIsTheLastAboveALine() {
    assertEquals(Optional.empty(), ProgramLabel.at(labels, 1));
    assertEquals(5, ProgramLabel.at(labels, 5).orElseThrow().number());
    assertEquals(2, ProgramLabel.at(labels, 10).orElseThrow().number());
  }
}
