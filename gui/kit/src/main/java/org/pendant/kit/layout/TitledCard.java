package org.pendant.kit.layout;

import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.theme.Palette;

/** A titled panel with rounded corners. */
@SuppressWarnings("serial") // never written to a stream
public final class TitledCard extends JPanel {

  /**
   * An empty card.
   *
   * @param word with which its name ends
   * @param columns of the grid below the title, as MigLayout reads them
   */
  public TitledCard(String word, String title, String columns) {
    super(new MigLayout("insets 12 16 12 16, gap 8 4, wrap, hidemode 3", columns));
    putClientProperty("FlatLaf.style", "arc: 16");
    setBackground(Palette.card());
    setName("card-" + word);
    getAccessibleContext().setAccessibleName(title);
    JLabel heading = new JLabel(title);
    heading.putClientProperty("FlatLaf.styleClass", "h4");
    add(heading, "span, gapbottom 4");
  }

  /** Names a control for tests, screen readers and the pointer. */
  public static <C extends JComponent> C named(C component, String name, String tip) {
    component.setName(name);
    component.setToolTipText(tip);
    component.getAccessibleContext().setAccessibleName(tip);
    return component;
  }

  /** Makes buttons little wider than their texts. */
  public static void compact(JButton... buttons) {
    for (JButton each : buttons) {
      each.putClientProperty("FlatLaf.style", "minimumWidth: 0; margin: 2,8,2,8");
    }
  }
}
