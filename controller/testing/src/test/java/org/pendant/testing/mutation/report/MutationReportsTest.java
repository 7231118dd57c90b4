package org.pendant.testing.mutation.report;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.pendant.testing.mutation.MutationReport;
import org.pendant.testing.mutation.MutationSuite;

/** The forms that mutation is told in, to the byte. */
class MutationReportsTest {
  private static MutationSuite suite() {
    return MutationSuite.of(
            "def unused(a):",
            "  x = True",
            "end",
            "def wait_and_half(a):",
            "  sleep(0.5) # \u00e4",
            "  return a / 2",
            "end")
        .tests("def test_half():", "  assert_near(wait_and_half(4), 2)", "end");
  }

  private static String expected() throws IOException {
    try (InputStream in = MutationReportsTest.class.getResourceAsStream("mutation.json")) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void theTableHasTheMutantsThatNobodyNoticed() {
    assertEquals(
        """
        5 mutants
        file         mutants  killed  survived  not covered   score
        pick.script        5       2         2            1  40.0 %

        survived:
        pick.script:5:3: call dropped
          - sleep(0.5) # \u00e4
          + # \u00e4
        pick.script:5:9: speed
          - sleep(0.5) # \u00e4
          + sleep(1.0) # \u00e4
        """,
        MutationTable.of(suite().run()));
  }

  @Test
  void theFileForViewersFollowsTheirSchema() throws IOException {
    MutationSuite suite = suite();
    MutationReport report = suite.run();
    ByteArrayOutputStream out = new ByteArrayOutputStream();

    MutationJson.write(report, suite.result().results(), "1.0", out);

    assertEquals(expected(), out.toString(StandardCharsets.UTF_8));
  }
}
