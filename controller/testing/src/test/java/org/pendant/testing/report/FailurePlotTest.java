package org.pendant.testing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.models.arm.Joints;
import org.pendant.testing.report.FailurePlot.Frame;

class FailurePlotTest {
  private static FailurePlot plot(double radPerS, boolean valve) {
    List<Frame> frames =
        IntStream.range(0, 1250)
            .mapToObj(
                i ->
                    new Frame(
                        10 + i * 0.002,
                        Joints.of(i * 0.002 * radPerS, -1.5, 0, -1.5, 0, 0),
                        Joints.of(radPerS, 0, 0, 0, 0, 0),
                        new DigitalLevels(0, valve && i > 500 ? 4 : 0, 0, 0, 0, 0, 0)))
            .toList();
    return new FailurePlot(12, frames);
  }

  private static String page(FailurePlot plot) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    new HtmlReport(
            SampleSuite.suite(),
            _ -> Optional.empty(),
            Map.of(),
            Map.of(SampleSuite.failed().id(), plot))
        .writePage(out);
    return out.toString(StandardCharsets.UTF_8);
  }

  private static long count(String page, String pattern) {
    return Pattern.compile(pattern).matcher(page).results().count();
  }

  @Test
  void aRedTestHasTheJointsAndSignalsAroundItsFailureInThePage() throws IOException {
    String page = page(plot(0.3, true));

    assertEquals(12, count(page, "<polyline class=\"j[0-5]\" points=\""));
    assertEquals(1, count(page, "<path class=\"signal\" d=\"M92 [0-9]+H[0-9.]+V[0-9]+H850\"/>"));
    assertTrue(page.contains(">digital_out[2]</text>"), page);
    assertEquals(1, count(page, "<line class=\"moment\" x1=\"698"));
    assertTrue(page.contains("Joints and signals around the failure at 12.000 s"), page);
    assertFalse(page.contains(" style=") || page.contains("<script"));
    assertFalse(page.contains("NaN") || page.contains("Infinity"));
  }

  @Test
  void aPlotIsSmallerThanItsFramesAre() throws IOException {
    assertTrue(page(plot(0.3, true)).length() - page(plot(0, false)).length() < 120_000);
  }

  @Test
  void whereNothingMovesAndNoSignalChangesThereIsNoPlot() throws IOException {
    assertFalse(plot(0, false).tells());
    assertTrue(plot(0, true).tells());
    assertEquals(0, count(page(plot(0, false)), "<polyline"));
  }
}
