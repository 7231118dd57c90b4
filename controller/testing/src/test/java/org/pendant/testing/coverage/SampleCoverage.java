package org.pendant.testing.coverage;

import java.util.List;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.coverage.CoverageMap;
import org.pendant.script.coverage.CoverageSite;
import org.pendant.script.coverage.CoverageSite.Kind;
import org.pendant.script.vm.ProgramLoader;

/** Programs compiled for coverage, and runs of them that have reached what a test says. */
public final class SampleCoverage {
  /** A program with everything that is reported. */
  public static final String PICK =
      """
      def pick():
        def grip(width):
          if width < 0 or width > 0.1:
            return False
          end
          return True
        end
        def unused():
          # <never> & "not yet"
          return 1
        end
        i = 0
        while i < 3:
          i = i + 1
        end
        grip(i)
      end
      """;

  private SampleCoverage() {}

  /** What there is to reach in a text. */
  public static CoverageMap map(String name, String text) {
    return ProgramLoader.loadCovered(Source.of(name, text), StandardBuiltins.create())
        .program()
        .orElseThrow()
        .coverageMap()
        .orElseThrow();
  }

  /**
   * A run.
   *
   * @param reached the lines whose statements it reached, and what was decided: {@code 3T} and
   *     {@code 3F} for the branch of line 3, {@code 3.2T} for the second operand there
   */
  public static Coverage run(CoverageMap map, String... reached) {
    byte[] marks = new byte[map.slots()];
    int line = 0;
    int operand = 0;
    for (CoverageSite site : map.sites()) {
      operand = site.line() == line ? operand : 0;
      line = site.line();
      operand += site.kind() == Kind.CONDITION ? 1 : 0;
      String name = line + (site.kind() == Kind.CONDITION ? "." + operand : "");
      if (site.kind().twoWay()) {
        mark(marks, site.slot(), name + "F", reached);
        mark(marks, site.slot() + 1, name + "T", reached);
      } else {
        mark(marks, site.slot(), site.kind() == Kind.STATEMENT ? name : "", reached);
      }
    }
    return new Coverage(map, marks);
  }

  private static void mark(byte[] marks, int slot, String name, String... reached) {
    if (List.of(reached).contains(name)) {
      marks[slot] = 1;
    }
  }

  /** The program, in a test that grips too wide and one that grips. */
  public static CoverageReport pick() {
    CoverageMap map = map("cell/pick.script", PICK);
    CoverageCollector collector = new CoverageCollector();
    LineOrigin origin = LineOrigin.file("cell/pick.script");
    collector.add(
        "pick_test.script test_wide",
        run(map, "12", "13F", "13T", "13", "14", "16", "3", "3T", "3.1F", "3.2T", "4"),
        origin);
    collector.add(
        "pick_test.script test_empty", run(map, "12", "13", "13F", "16", "3", "3F"), origin);
    collector.add("pick_test.script test_other");
    return collector.report();
  }
}
