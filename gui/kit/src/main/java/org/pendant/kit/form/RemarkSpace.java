package org.pendant.kit.form;

import java.awt.Dimension;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/**
 * Space for remarks that is there also while there is nothing to say: what lies below does not move
 * under the pointer when a remark comes or goes.
 */
@SuppressWarnings("serial") // never written to a stream
public final class RemarkSpace extends JPanel {
  private final int lines;

  /**
   * Space for remarks below each other.
   *
   * @param lines how many lines of text have room always
   */
  public RemarkSpace(int lines, Remark... remarks) {
    super(new MigLayout("insets 0, gap 0, wrap, hidemode 3", "[grow, fill]"));
    this.lines = lines;
    setOpaque(false);
    for (Remark each : remarks) {
      add(each, Remark.LAYOUT);
    }
  }

  private Dimension atLeast(Dimension size) {
    int least = lines * getFontMetrics(getFont()).getHeight();
    return new Dimension(size.width, Math.max(size.height, least));
  }

  @Override
  public Dimension getPreferredSize() {
    return atLeast(super.getPreferredSize());
  }

  @Override
  public Dimension getMinimumSize() {
    return atLeast(super.getMinimumSize());
  }
}
