package org.pendant.kit.theme;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import java.awt.RenderingHints;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JLabel;

/** A word on a softly coloured ground: a mode or a state. */
@SuppressWarnings("serial") // never written to a stream
public final class Badge extends JLabel {
  private transient Supplier<Color> tone = Palette::quiet;

  /**
   * An empty badge.
   *
   * @param name of the component
   * @param meaning what it shows, for tooltip and screen readers
   */
  public Badge(String name, String meaning) {
    setName(name);
    setToolTipText(meaning);
    getAccessibleContext().setAccessibleName(meaning);
    putClientProperty("FlatLaf.styleClass", "semibold");
  }

  @Override
  public void updateUI() {
    super.updateUI();
    Insets inner = UIScale.scale(new Insets(4, 10, 4, 10));
    setBorder(BorderFactory.createEmptyBorder(inner.top, inner.left, inner.bottom, inner.right));
  }

  /** Shows a word in a colour of the {@link Palette}. */
  public void show(String text, Supplier<Color> color) {
    if (!text.equals(getText())) {
      setText(text);
      getAccessibleContext().setAccessibleDescription(text);
    }
    Color wanted = color.get();
    tone = color;
    if (!wanted.equals(getForeground())) {
      setForeground(wanted);
    }
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D painter = (Graphics2D) g.create();
    painter.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    painter.setColor(Palette.tint(tone.get(), 0.14));
    int arc = UIScale.scale(8);
    painter.fillRoundRect(0, 0, getWidth(), getHeight(), arc, arc);
    painter.dispose();
    super.paintComponent(g);
  }
}
