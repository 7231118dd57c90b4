package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Drive;
import org.pendant.controller.state.ControllerState;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.source.TestCase;

class GoldensTest {
  /** Finds one problem in each run. */
  private static final class Finding implements Goldens {
    private final Problem problem;
    private final List<String> told = new ArrayList<>();

    private Finding(int line, String program) {
      problem = new Problem("golden-differs", "it differs", line, program);
    }

    @Override
    public Run begins(TestCase test) {
      told.add("begins " + test.golden().orElseThrow().deg());
      return new Run() {
        @Override
        public void begins(Drive drive) {}

        @Override
        public void sees(ControllerState state) {}

        @Override
        public Optional<Problem> passed() {
          told.add("passed");
          return Optional.of(problem);
        }

        @Override
        public void close() {
          told.add("closed");
        }
      };
    }
  }

  private static TestPlace place(TestResult result) {
    return result.failure().orElseThrow().place().orElseThrow();
  }

  @Test
  void aTestThatIsNotMarkedIsComparedWithNothing() {
    Finding finding = new Finding(1, "");

    TestResult result = Suite.of("def test_a():", "  sync()", "end").with(finding).only();

    assertEquals(TestStatus.PASSED, result.status());
    assertEquals(List.of(), finding.told);
  }

  @Test
  void aDifferenceMakesATestRedAtTheLineThatRan() {
    Finding finding = new Finding(3, "");

    TestResult result =
        Suite.of("# @golden deg=0.5", "def test_a():", "  sync()", "end").with(finding).only();

    assertEquals(TestStatus.FAILED, result.status());
    assertEquals("golden-differs", result.failure().orElseThrow().code());
    assertEquals(new TestPlace("cell/pick_test.script", 3, 0, "test_a"), place(result));
    assertEquals(List.of("begins OptionalDouble[0.5]", "passed", "closed"), finding.told);
  }

  @Test
  void ofATestThatWatchesItIsTheLineOfTheProgram() {
    TestResult result =
        Suite.of("# @golden", "def test_a():", "  start(\"pick.script\")", "  sync()", "end")
            .with("cell/pick.script", "def pick():", "  sleep(0.1)", "end")
            .with(new Finding(2, "cell/pick.script"))
            .only();

    assertEquals(new TestPlace("cell/pick.script", 2, 0, ""), place(result));
  }

  @Test
  void aTestThatIsRedByItselfSaysThatAlone() {
    Finding finding = new Finding(3, "");

    TestResult result =
        Suite.of("# @golden", "def test_a():", "  fail(\"so\")", "end").with(finding).only();

    assertEquals("so: the test says so", result.failure().orElseThrow().message());
    assertEquals(List.of("begins OptionalDouble[0.1]", "closed"), finding.told);
  }

  @Test
  void whatIsRandomInAGoldenTestIsTheSameWithEachSeed() {
    Suite suite = Suite.of("# @golden", "def test_a():", "  textmsg(random())", "end");
    TestSettings settings = suite.settings();

    List<String> first = suite.only().output();
    List<String> second =
        suite
            .with(
                new TestSettings(
                    settings.controller().withSeed(7), 7, 1, 60, settings.wallTimeout(), false))
            .only()
            .output();

    assertEquals(first, second);
  }
}
