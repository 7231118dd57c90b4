package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

/** Where the rows of a timeline are. */
final class TimelinePainterTest {
  @Test
  void namesOfRowsStandApartInTheLowestTimeline() {
    FontMetrics metrics =
        new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)
            .createGraphics()
            .getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
    TimelinePainter painter = new TimelinePainter();

    double[] heights =
        painter.heights(
            painter.leastHeight(metrics) - 1.5 * metrics.getHeight() - TimelinePainter.gap(),
            metrics.getHeight());

    for (int i = 0; i + 1 < heights.length; i++) {
      double apart = (heights[i] + heights[i + 1]) / 2 + TimelinePainter.gap();
      assertTrue(
          apart >= 0.95 * (metrics.getAscent() + metrics.getDescent()),
          "names " + i + " and " + (i + 1) + " are " + apart + " apart");
    }
  }
}
