package org.pendant.desktop.shell;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.util.function.IntSupplier;
import javax.swing.text.JTextComponent;
import org.pendant.kit.layout.WrappingRow;

/**
 * Notice layout: an icon, a text that wraps, and choices beside it, or below it where there is no
 * room.
 */
final class NoticeLayout implements LayoutManager {
  /** Narrower texts (pixels before scaling) leave the row to the choices. */
  private static final int MIN_TEXT = 160;

  private static final int GAP = 8;

  /** The gap of the row of choices, in pixels before scaling. */
  static final int WITHIN_ROW = 4;

  private final Component icon;
  private final JTextComponent text;
  private final Container choices;
  private final IntSupplier width;

  /**
   * The layout of a notice.
   *
   * @param choices in a {@link WrappingRow}
   * @param width that the notice will have
   */
  NoticeLayout(Component icon, JTextComponent text, Container choices, IntSupplier width) {
    this.icon = icon;
    this.text = text;
    this.choices = choices;
    this.width = width;
  }

  @Override
  public void layoutContainer(Container parent) {
    arrange(parent.getWidth(), true);
  }

  @Override
  public Dimension preferredLayoutSize(Container parent) {
    return new Dimension(width.getAsInt(), arrange(width.getAsInt(), false));
  }

  @Override
  public Dimension minimumLayoutSize(Container parent) {
    return new Dimension(0, arrange(width.getAsInt(), false));
  }

  /** Returns the height that is needed. */
  private int arrange(int width, boolean place) {
    int gap = UIScale.scale(GAP);
    Dimension sign = icon.getPreferredSize();
    Dimension row = oneRow();
    int left = 2 * gap + sign.width + gap;
    int beside = width - left - row.width - 2 * gap;
    boolean below = beside < Math.min(UIScale.scale(MIN_TEXT), wordsWidth());
    int textWidth = Math.max(1, below ? width - left - gap : beside);
    text.setSize(textWidth, Integer.MAX_VALUE);
    int textHeight = text.getPreferredSize().height;
    if (below) {
      choices.setSize(width - left - gap, 1);
      row = choices.getPreferredSize();
    }
    int first = Math.max(textHeight, below ? 0 : row.height);
    if (place) {
      icon.setBounds(2 * gap, gap + (first - sign.height) / 2, sign.width, sign.height);
      text.setBounds(left, gap + (first - textHeight) / 2, textWidth, textHeight);
      int x = below ? left : width - gap - row.width;
      int y = below ? 2 * gap + first : gap + (first - row.height) / 2;
      choices.setBounds(x, y, row.width, row.height);
    }
    return first + 2 * gap + (below ? gap + row.height : 0);
  }

  /** The choices in a single row. */
  private Dimension oneRow() {
    int gap = UIScale.scale(WITHIN_ROW);
    int width = gap;
    int height = 0;
    for (Component each : choices.getComponents()) {
      Dimension size = each.getPreferredSize();
      width += size.width + gap;
      height = Math.max(height, size.height);
    }
    return new Dimension(width, height + 2 * gap);
  }

  private int wordsWidth() {
    return text.getFontMetrics(text.getFont()).stringWidth(text.getText());
  }

  @Override
  public void addLayoutComponent(String name, Component component) {}

  @Override
  public void removeLayoutComponent(Component component) {}
}
