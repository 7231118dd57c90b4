package org.pendant.kit.layout;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import java.util.Arrays;
import java.util.List;

/**
 * Cards in as many columns as fit, each at least as wide as the first card; a card that needs more
 * spans several. Each goes where it comes highest, so that the order is kept as far as the heights
 * allow. Hidden cards count for nothing.
 */
public final class CardColumns implements LayoutManager {
  private final int gap;
  private final int widestColumn;

  /**
   * Columns with space around and between them.
   *
   * @param gap the space, in pixels before scaling
   * @param widestColumn columns become no wider than this, in pixels before scaling
   */
  public CardColumns(int gap, int widestColumn) {
    this.gap = gap;
    this.widestColumn = widestColumn;
  }

  /** How many columns of at least {@code columnWidth} fit, at least one. */
  static int columns(int width, int columnWidth, int gap) {
    return Math.max(1, (width - gap) / Math.max(1, columnWidth + gap));
  }

  /** How many columns of width {@code column} a card of width {@code card} needs. */
  static int span(int card, int column, int gap) {
    return Math.max(1, Math.ceilDiv(card + gap, column + gap));
  }

  private static List<Component> cards(Container parent) {
    return Arrays.stream(parent.getComponents()).filter(Component::isVisible).toList();
  }

  private static int columnWidth(Container parent) {
    List<Component> cards = cards(parent);
    return cards.isEmpty() ? 0 : cards.getFirst().getPreferredSize().width;
  }

  @Override
  public Dimension preferredLayoutSize(Container parent) {
    int width = parent.getWidth() > 0 ? parent.getWidth() : 3 * columnWidth(parent) + 4 * gap;
    return new Dimension(width, arrange(parent, width, false));
  }

  @Override
  public Dimension minimumLayoutSize(Container parent) {
    return new Dimension(columnWidth(parent) + 2 * gap, 0);
  }

  @Override
  public void layoutContainer(Container parent) {
    arrange(parent, parent.getWidth(), true);
  }

  /** Returns the height that is needed. */
  private int arrange(Container parent, int width, boolean place) {
    Insets insets = parent.getInsets();
    int inner = width - insets.left - insets.right;
    int least = columnWidth(parent);
    int count = columns(inner, least, gap);
    int column = Math.min((inner - gap) / count - gap, Math.max(widestColumn, least));
    int[] bottoms = new int[count];
    Arrays.fill(bottoms, insets.top + gap);
    for (Component card : cards(parent)) {
      Dimension wanted = card.getPreferredSize();
      int span = Math.min(count, span(wanted.width, column, gap));
      int at = highest(bottoms, span);
      int top = top(bottoms, at, span);
      if (place) {
        int x = insets.left + gap + at * (column + gap);
        card.setBounds(x, top, Math.max(0, span * (column + gap) - gap), wanted.height);
      }
      Arrays.fill(bottoms, at, at + span, top + wanted.height + gap);
    }
    return Arrays.stream(bottoms).max().orElse(0) + insets.bottom;
  }

  private static int highest(int[] bottoms, int span) {
    int best = 0;
    for (int i = 1; i + span <= bottoms.length; i++) {
      if (top(bottoms, i, span) < top(bottoms, best, span)) {
        best = i;
      }
    }
    return best;
  }

  private static int top(int[] bottoms, int from, int span) {
    return Arrays.stream(bottoms, from, from + span).max().orElse(0);
  }

  @Override
  public void addLayoutComponent(String name, Component component) {}

  @Override
  public void removeLayoutComponent(Component component) {}
}
