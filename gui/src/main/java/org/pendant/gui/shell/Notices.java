package org.pendant.gui.shell;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.gui.shell.look.Card;
import org.pendant.gui.shell.look.Glyph;
import org.pendant.gui.shell.look.GlyphIcon;
import org.pendant.gui.workbench.Palette;

/** Questions above the views that can wait: the window is used meanwhile. */
@SuppressWarnings("serial") // never written to a stream
final class Notices extends JPanel {
  private final Map<String, JPanel> open = new HashMap<>();

  /**
   * Something to choose; every choice closes the notice.
   *
   * @param text of its button
   */
  record Choice(String text, Runnable run) {}

  Notices() {
    super(new MigLayout("insets 0, gap 0, wrap 1, hidemode 3", "[grow, fill]", ""));
    setName("notices");
  }

  /**
   * Asks, in place of an earlier question of the same name.
   *
   * @param name of the component
   */
  void ask(String name, String text, List<Choice> choices) {
    close(name);
    JPanel card =
        new Card(
            new MigLayout("insets 8 16 8 8, gap 8", "[grow, 0::]" + "[]".repeat(choices.size())));
    card.setName(name);
    JLabel label =
        new JLabel(text, GlyphIcon.of(Glyph.WARNING, 18, Palette::warning), JLabel.LEADING);
    label.setToolTipText(text);
    card.add(label, "growx");
    for (Choice choice : choices) {
      JButton button = new JButton(choice.text());
      button.setName(name + "-" + choice.text().replace(' ', '-').toLowerCase(Locale.ROOT));
      button.setToolTipText(choice.text());
      button.getAccessibleContext().setAccessibleName(choice.text());
      button.addActionListener(
          event -> {
            close(name);
            choice.run().run();
          });
      card.add(button);
    }
    open.put(name, card);
    add(card, "gap 8 8 4 4");
    revalidate();
  }

  /** Takes a question back. */
  void close(String name) {
    JPanel card = open.remove(name);
    if (card != null) {
      remove(card);
      revalidate();
      repaint();
    }
  }
}
