package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.models.arm.Joints;

/**
 * Readings card: what the sensors of the arm and the control box read. Where a row does not fit the
 * card's width, it is broken in two.
 */
final class ReadingsCard {
  private static final int COLUMNS = Readings.JOINT_COLUMNS.size();

  private final TitledCard card = new TitledCard("readings", text("readings"), "[grow,fill]");
  private final JPanel table = new JPanel();
  private final JPanel below = new JPanel();
  private final List<JLabel> titles = Readings.JOINT_COLUMNS.stream().map(Cells::title).toList();
  private final List<List<JLabel>> joints = new ArrayList<>();
  private final List<JLabel> others = Readings.OTHERS.stream().map(Cells::value).toList();

  /** How wide the card must be for whole rows; 0 until that is known. */
  private int wholeWidth;

  private boolean whole = true;

  /** The labels of the card. */
  private static final class Cells {
    private static JLabel title(String text) {
      JLabel label = new JLabel(text);
      label.setEnabled(false);
      return label;
    }

    private static JLabel value(String title) {
      JLabel label = new JLabel("\u2013");
      label.putClientProperty("FlatLaf.styleClass", "monospaced");
      label.setToolTipText(title);
      return label;
    }
  }

  ReadingsCard() {
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      String title = Readings.JOINTS.get(joint);
      joints.add(
          Readings.JOINT_COLUMNS.stream()
              .map(each -> Cells.value(Messages.told(title, each)))
              .toList());
    }
    table.setOpaque(false);
    below.setOpaque(false);
    card.add(table);
    card.add(below, "gaptop 12");
    arrange();
    card.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            fit();
          }
        });
  }

  /** Breaks rows that do not fit, and mends them when they do again. */
  private void fit() {
    if (whole) {
      wholeWidth = card.getLayout().minimumLayoutSize(card).width;
    }
    boolean fits = card.getWidth() >= wholeWidth;
    if (fits != whole) {
      whole = fits;
      arrange();
      card.revalidate();
    }
  }

  private void arrange() {
    int values = whole ? COLUMNS : COLUMNS / 2;
    table.removeAll();
    table.setLayout(
        new MigLayout(
            "insets 0, gap 8 4, wrap " + (values + 1), "[]push" + "[right,60::]".repeat(values)));
    addRow(new JLabel(), titles, values);
    for (int joint = 0; joint < joints.size(); joint++) {
      addRow(new JLabel(Readings.JOINTS.get(joint)), joints.get(joint), values);
    }
    below.removeAll();
    below.setLayout(
        whole
            ? new MigLayout("insets 0, gap 8 4, wrap 2", "[]push[right]")
            : new MigLayout("insets 0, gap 8 4, wrap 1", "[grow]"));
    for (int i = 0; i < others.size(); i++) {
      below.add(new JLabel(Readings.OTHERS.get(i)), "wmin 0");
      below.add(others.get(i), whole ? "" : "right");
    }
  }

  private void addRow(JLabel name, List<JLabel> cells, int values) {
    table.add(name);
    for (int i = 0; i < cells.size(); i++) {
      boolean second = i > 0 && i % values == 0;
      table.add(cells.get(i), second ? "skip 1" : "");
    }
  }

  JComponent component() {
    return card;
  }

  void refresh(ControllerState state) {
    for (int joint = 0; joint < joints.size(); joint++) {
      show(joints.get(joint), Readings.joint(state, joint));
    }
    show(others, Readings.others(state));
  }

  private static void show(List<JLabel> labels, List<String> texts) {
    for (int i = 0; i < labels.size(); i++) {
      if (!labels.get(i).getText().equals(texts.get(i))) {
        labels.get(i).setText(texts.get(i));
      }
    }
  }
}
