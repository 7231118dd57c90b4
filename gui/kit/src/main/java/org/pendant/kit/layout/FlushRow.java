package org.pendant.kit.layout;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Insets;
import javax.swing.JPanel;

/** Components in a {@link WrappingRow} with space between them only, not around them. */
@SuppressWarnings("serial") // never written to a stream
public final class FlushRow extends JPanel {
  private final int gap;

  /**
   * An empty row.
   *
   * @param gap between components, in pixels before scaling
   */
  public FlushRow(int gap) {
    super(new WrappingRow(gap));
    this.gap = gap;
    setOpaque(false);
  }

  /** Takes back what the layout leaves around. */
  @Override
  public Insets getInsets() {
    int out = -UIScale.scale(gap);
    return new Insets(out, out, out, out);
  }
}
