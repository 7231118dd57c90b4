package org.pendant.desktop.editor;

import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.theme.Markup;
import org.pendant.kit.theme.Palette;

/** Notice bar: asks something above the text of one program, without stopping the user. */
@SuppressWarnings("serial") // never written to a stream
final class NoticeBar extends JPanel {

  NoticeBar() {
    super(new MigLayout("insets 6 12 6 12, gap 8"));
    setName("editor-notice");
    setBackground(Palette.tint(Palette.warning(), 0.14));
    setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Palette.line()));
    setVisible(false);
  }

  /**
   * An answer.
   *
   * @param word with which the name of its button ends
   */
  record Answer(String word, String text, Runnable run) {}

  /**
   * Asks. Every answer takes the bar away.
   *
   * @param answers what the buttons say and do, in this order; the first is the usual one
   */
  void ask(String question, List<Answer> answers) {
    removeAll();
    JLabel label = new JLabel("<html>" + Markup.escaped(question));
    add(label, "growx, pushx, wmin 0");
    for (Answer answer : answers) {
      JButton button = new JButton(answer.text());
      button.setName("notice-" + answer.word());
      button.setToolTipText(answer.text());
      button.addActionListener(
          event -> {
            close();
            answer.run().run();
          });
      add(button);
    }
    setVisible(true);
    revalidate();
    getComponent(1).requestFocusInWindow();
  }

  void close() {
    setVisible(false);
  }
}
