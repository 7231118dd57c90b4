package org.pendant.desktop.editor;

import java.awt.CardLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import org.pendant.kit.theme.HtmlLabel;
import org.pendant.kit.theme.Palette;

/** Empty state: a panel that says what to do while there is nothing to show. */
@SuppressWarnings("serial") // never written to a stream
final class EmptyState extends JPanel {
  private final CardLayout cards = new CardLayout();
  private final JLabel note = new HtmlLabel(SwingConstants.CENTER);

  EmptyState(JComponent content) {
    setLayout(cards);
    add(content, "content");
    add(note, "note");
  }

  void showContent() {
    cards.show(this, "content");
  }

  /** Shows a sentence in place of the content; it breaks where the panel is narrow. */
  void showNote(String sentence) {
    note.setText("<html><center>" + sentence + "</center></html>");
    note.setForeground(Palette.quiet());
    cards.show(this, "note");
  }
}
