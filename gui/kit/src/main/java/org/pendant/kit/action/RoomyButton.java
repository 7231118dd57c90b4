package org.pendant.kit.action;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.util.List;
import javax.swing.Icon;
import javax.swing.JButton;

/** A button with room for other texts that it may show: what is beside it stays when they come. */
@SuppressWarnings("serial") // never written to a stream
public class RoomyButton extends JButton {
  private transient List<String> texts = List.of();

  /** A button with room for its text alone. */
  public RoomyButton(String text, Icon icon) {
    super(text, icon);
  }

  /** Has room for each of these texts as well. */
  public final void reserve(List<String> others) {
    texts = List.copyOf(others);
    revalidate();
  }

  @Override
  public Dimension getPreferredSize() {
    Dimension size = super.getPreferredSize();
    if (!isPreferredSizeSet() && !texts.isEmpty()) {
      FontMetrics metrics = getFontMetrics(getFont());
      int widest = texts.stream().mapToInt(metrics::stringWidth).max().orElse(0);
      size.width += Math.max(0, widest - metrics.stringWidth(getText()));
    }
    return size;
  }
}
