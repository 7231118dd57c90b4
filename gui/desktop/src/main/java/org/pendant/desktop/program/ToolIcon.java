package org.pendant.desktop.program;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.regex.Pattern;
import javax.swing.Icon;
import org.pendant.kit.theme.Palette;

/** Drawings on the buttons above the tree, in a square of 16. */
record ToolIcon(Sign sign) implements Icon {
  private static final int SIDE = 16;

  /** What buttons there are, in their order. */
  enum Sign {
    UNDO("undo", "Undo", "7 3 3 6 7 9 ; 3 6 11 6 13 8 13 12 7 12"),
    REDO("redo", "Do again", "9 3 13 6 9 9 ; 13 6 5 6 3 8 3 12 9 12"),
    UP("move-up", "Move up", "4 7 8 3 12 7 ; 8 3 8 13"),
    DOWN("move-down", "Move down", "4 9 8 13 12 9 ; 8 13 8 3"),
    CUT("cut", "Cut", "4 2 11 11 ; 12 2 5 11 ; 3 11 5 13 ; 11 13 13 11"),
    COPY("copy", "Copy", "3 3 10 3 10 10 3 10 3 3 ; 12 6 13 6 13 13 6 13 6 12"),
    PASTE("paste", "Paste", "3 4 13 4 13 14 3 14 3 4 ; 6 2 10 2 ; 6 9 10 9"),
    DELETE("delete", "Delete", "3 5 13 5 ; 6 5 6 3 10 3 10 5 ; 4 5 5 14 11 14 12 5"),
    SUPPRESS("suppress", "Suppress, or use again", "2 8 14 8 ; 4 4 12 4 ; 4 12 12 12"),
    FOLLOW("follow", "Follow", "2 4 7 8 2 12 2 4 ; 9 4 14 4 ; 9 8 14 8 ; 9 12 14 12");

    private final String action;
    private final String title;
    private final String lines;

    /**
     * @param lines x and y in turn; a semicolon begins another line
     */
    Sign(String action, String title, String lines) {
      this.action = action;
      this.title = title;
      this.lines = lines;
    }

    /** What it does, as the end of an action's id. */
    String action() {
      return action;
    }

    String title() {
      return title;
    }

    private Path2D path() {
      Path2D path = new Path2D.Double();
      for (String line : Splitter.LINES.splitAsStream(lines).toList()) {
        double[] xy =
            Splitter.NUMBERS.splitAsStream(line.strip()).mapToDouble(Double::parseDouble).toArray();
        path.moveTo(xy[0], xy[1]);
        for (int i = 2; i < xy.length; i += 2) {
          path.lineTo(xy[i], xy[i + 1]);
        }
      }
      return path;
    }
  }

  /** Takes the texts of drawings apart. */
  private static final class Splitter {
    private static final Pattern LINES = Pattern.compile(";");
    private static final Pattern NUMBERS = Pattern.compile(" ");
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Color color = c.isEnabled() ? c.getForeground() : Palette.line();
    Graphics2D pen = StepIcon.pen(g, x, y, color, 1.4f);
    pen.draw(sign.path());
    pen.dispose();
  }

  @Override
  public int getIconWidth() {
    return UIScale.scale(SIDE);
  }

  @Override
  public int getIconHeight() {
    return UIScale.scale(SIDE);
  }
}
