package org.pendant.desktop.shell.run;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.theme.Card;
import org.pendant.kit.theme.Palette;

/** Numbers panel: a card with names and numbers in a column each. */
final class NumbersPanel {
  private final JPanel card =
      new Card(new MigLayout("insets 16, gap 8 4, wrap 2", "[]16[grow, right, 90::]", ""));
  private final List<JLabel> names = new ArrayList<>();
  private final List<JLabel> values = new ArrayList<>();

  /**
   * Without numbers yet.
   *
   * @param words with which the names of the numbers' components end
   */
  NumbersPanel(String name, String title, List<String> words, List<String> rows) {
    card.setName(name);
    JLabel heading = new JLabel(title);
    heading.putClientProperty("FlatLaf.styleClass", "h4");
    card.add(heading, "span 2");
    for (int i = 0; i < rows.size(); i++) {
      String row = rows.get(i);
      JLabel label = new JLabel(row);
      JLabel value = new JLabel();
      value.putClientProperty("FlatLaf.styleClass", "monospaced");
      value.setName(name + "-" + words.get(i));
      value.getAccessibleContext().setAccessibleDescription(title + " " + row);
      names.add(label);
      values.add(value);
      card.add(label);
      card.add(value);
    }
  }

  JPanel component() {
    return card;
  }

  /** Shows numbers under other names. */
  void show(List<String> titles, List<String> texts) {
    for (int i = 0; i < names.size(); i++) {
      if (!titles.get(i).equals(names.get(i).getText())) {
        names.get(i).setText(titles.get(i));
      }
    }
    show(texts);
  }

  void show(List<String> texts) {
    for (int i = 0; i < values.size(); i++) {
      if (!texts.get(i).equals(values.get(i).getText())) {
        values.get(i).setText(texts.get(i));
      }
      names.get(i).setForeground(Palette.quiet());
    }
  }
}
