package org.pendant.desktop.timeline;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import org.pendant.desktop.timeline.TimelinePainter.Sheet;
import org.pendant.kit.theme.Palette;
import org.pendant.recording.ColumnTrace;

/**
 * Nearest row: how far the arm is from what is nearest around it, from 0 at the bottom, and in
 * quiet how far its links are from one another where that is less; red where it is in something,
 * with what it has run into.
 */
final class NearestRow {
  /** As high as the row, m: what is farther away is no concern. */
  private static final double TOP_M = 0.2;

  /** Nearer than this is told as a warning, m. */
  private static final double NEAR_M = 0.02;

  private NearestRow() {}

  static void paint(Sheet sheet, Tracks tracks, double y, double height) {
    double bottom = y + height;
    Graphics2D pen = sheet.pen();
    pen.setColor(Palette.line());
    pen.draw(new Line2D.Double(sheet.left(), bottom, sheet.left() + sheet.width(), bottom));
    Optional<ColumnTrace> objects = tracks.objectM();
    tracks
        .nearestM()
        .ifPresent(
            all -> {
              if (objects.isPresent()) {
                curve(sheet, all, Palette.quiet(), y, height);
              }
              curve(sheet, objects.orElse(all), Palette.series(5), y, height);
            });
    double free = Double.NEGATIVE_INFINITY;
    for (Tracks.Hit hit : tracks.hits()) {
      if (sheet.sees(hit.timeS(), hit.timeS())) {
        free = hit(sheet, hit, y, height, free);
      }
    }
  }

  private static void curve(Sheet sheet, ColumnTrace trace, Color color, double y, double height) {
    Graphics2D pen = sheet.pen();
    double bottom = y + height;
    double beforeX = Double.NaN;
    double beforeY = Double.NaN;
    pen.setStroke(new BasicStroke(UIScale.scale(1.3f)));
    for (int i = 0; i < trace.size(); i++) {
      double nearM = trace.lowest(i);
      double x = sheet.x(trace.timeS(i));
      double at = bottom - height * Math.clamp(nearM / TOP_M, 0, 1);
      if (nearM <= 0) {
        // as wide as the stretch, so that an instant of it is seen
        pen.setColor(Palette.error());
        pen.fill(
            new Rectangle2D.Double(x, y, Math.max(2, sheet.x(trace.timeS(i + 1)) - x), height));
      } else if (!Double.isNaN(beforeX) && !Double.isNaN(nearM)) {
        pen.setColor(nearM < NEAR_M ? Palette.warning() : color);
        pen.draw(new Line2D.Double(beforeX, beforeY, x, at));
      }
      beforeX = Double.isNaN(nearM) ? Double.NaN : x;
      beforeY = at;
    }
    pen.setStroke(new BasicStroke(1));
  }

  /** A disc, and who has hit what behind it where the one before leaves room; where that ends. */
  private static double hit(Sheet sheet, Tracks.Hit hit, double y, double height, double free) {
    Graphics2D pen = sheet.pen();
    double x = sheet.x(hit.timeS());
    double size = Math.min(height, UIScale.scale(9f));
    pen.setColor(Palette.error());
    pen.fill(new Ellipse2D.Double(x - size / 2, y + (height - size) / 2, size, size));
    if (x < free) {
      return free;
    }
    double gap = UIScale.scale(4f);
    double wide = sheet.metrics().stringWidth(hit.words());
    boolean fits = x + size + gap + wide < (double) sheet.left() + sheet.width();
    double left = fits ? x + size / 2 + gap : x - size / 2 - gap - wide;
    pen.setColor(Palette.card());
    pen.fill(new Rectangle2D.Double(left - gap / 2, y, wide + gap, height));
    pen.setColor(Palette.error());
    double base = y + (height + sheet.metrics().getAscent() - sheet.metrics().getDescent()) / 2;
    pen.drawString(hit.words(), (float) left, (float) base);
    return x + size + gap + wide;
  }
}
