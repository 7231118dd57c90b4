package org.pendant.desktop.debug;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.theme.Palette;

/** Debugger panel: why the program is paused, then its content, or what to do to get one. */
@SuppressWarnings("serial") // never written to a stream
final class DebugPanel extends JPanel {
  private static final String CONTENT = "content";
  private static final String NOTE = "note";

  private final JTextArea status = text("debug-status", DebugTexts.text("whyTheProgramIsPaused"));
  private final JTextArea note = text("debug-note", DebugTexts.text("whatToDo"));
  private final JPanel top = new JPanel(new MigLayout("insets 6 8 6 8, fillx", "[grow]", "[]"));
  private final CardLayout cards = new CardLayout();
  private final JPanel middle = new JPanel(cards);

  DebugPanel(String name, JComponent content) {
    super(new BorderLayout());
    setName(name);
    top.add(status, "growx, wmin 0");
    top.setVisible(false);
    JPanel empty = new JPanel(new MigLayout("insets 16, fill", "[grow]", "[center]"));
    empty.add(note, "growx, wmin 0, aligny center");
    middle.add(content, CONTENT);
    middle.add(empty, NOTE);
    add(top, BorderLayout.NORTH);
    add(middle);
    note.setForeground(Palette.quiet());
  }

  private static JTextArea text(String name, String accessibleName) {
    JTextArea text = new JTextArea();
    text.setName(name);
    text.getAccessibleContext().setAccessibleName(accessibleName);
    text.setEditable(false);
    text.setOpaque(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setBorder(BorderFactory.createEmptyBorder());
    text.setFocusable(false);
    text.putClientProperty("FlatLaf.style", "font: $defaultFont");
    return text;
  }

  /** Has the titles of columns stand over the start of what is in them. */
  static void alignTitles(JTable table) {
    if (table.getTableHeader().getDefaultRenderer() instanceof JLabel title) {
      title.setHorizontalAlignment(SwingConstants.LEADING);
    }
  }

  /** Shows the content under a status line; empty text for none. */
  void showContent(String why) {
    show(why, false);
  }

  /** Shows the content under a line that asks for no attention. */
  void showQuietly(String about) {
    show(about, true);
  }

  private void show(String why, boolean quiet) {
    status.setForeground(quiet ? Palette.quiet() : Palette.warning());
    if (!status.getText().equals(why)) {
      status.setText(why);
    }
    top.setVisible(!why.isEmpty());
    cards.show(middle, CONTENT);
  }

  /** Shows a sentence in place of the content. */
  void showNote(String sentence) {
    if (!note.getText().equals(sentence)) {
      note.setText(sentence);
    }
    top.setVisible(false);
    cards.show(middle, NOTE);
  }
}
