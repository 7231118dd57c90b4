package org.pendant.testing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestStatus;

class GithubAnnotationsTest {

  @Test
  void marksBrokenFilesAndRedTestsAtTheirLines() {
    assertEquals(
        List.of(
            "::error file=cell/old_test.script,line=3,col=5,title=no test of the file could run"
                + "::`movee` is not known%0A  movee(q)%0A  ^~~~~",
            "::error file=cell/grip_test.script,line=2,col=3,title=test_grip[0.05%2C True]%3A"
                + " failed::width is 0.05 m, expected 0.04 m%0Awithin 0.001 m%0Ain close,"
                + " cell/grip_test.script:2:3%0Ain test_grip, cell/grip_test.script:6:3",
            "::error file=cell/grip_test.script,line=10,col=3,title=test_force%3A error"
                + "::force_mode: 4 arguments are missing",
            "::error file=cell/grip_test.script,line=9,col=1,title=test_forever%3A timed out"
                + "::ran longer than 60 s of robot time"),
        GithubAnnotations.lines(SampleSuite.suite()));
  }

  @Test
  void areNoneWhereNothingIsRed() {
    assertEquals(
        List.of(),
        GithubAnnotations.lines(SampleSuite.of(SampleSuite.passed("a.script", "test_a", 1))));
  }

  @Test
  void noTextBecomesAPropertyOrAnotherCommand() {
    TestFailure failure =
        new TestFailure(
            "x",
            "100 %\r\n::error::forged",
            Optional.of(new TestPlace("a,b:c%.script", 3, 0, "")),
            List.of());
    assertEquals(
        List.of(
            "::error file=a%2Cb%3Ac%25.script,line=3,title=test_a%3A failed"
                + "::100 %25\\x0d%0A::error::forged"),
        GithubAnnotations.lines(
            SampleSuite.of(SampleSuite.red("test_a", TestStatus.FAILED, failure))));
  }

  @Test
  void aBrokenFileWhoseProblemHasNoPlaceIsMarkedAtItsFirstLine() {
    SuiteResult suite =
        new SuiteResult(
            List.of(),
            List.of(
                new BrokenTestFile("x.script", List.of("x.script: error: cannot be read")),
                new BrokenTestFile("y.script", List.of())),
            1,
            0,
            0);
    assertEquals(
        List.of(
            "::error file=x.script,line=1,title=no test of the file could run"
                + "::x.script: error: cannot be read",
            "::error file=y.script,line=1,title=no test of the file could run"
                + "::y.script: error: no test of it could run"),
        GithubAnnotations.lines(suite));
  }

  @Test
  void areAsManyAsGithubShowsAndSayHowManyMoreThereAre() {
    List<String> lines = GithubAnnotations.lines(SampleSuite.many(1_000));
    assertEquals(51, lines.size());
    assertEquals("::error title=pendant test::50 more, see the log", lines.getLast());
    String longest =
        GithubAnnotations.lines(
                SampleSuite.of(SampleSuite.failed("%".repeat(10_000_000), List.of())))
            .getFirst();
    assertTrue(longest.length() < 20_000, longest.length() + " characters");
  }
}
