package org.pendant.gui.io;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.layout.Card;
import org.pendant.models.arm.Joints;

/** What the sensors of the arm and the control box read. */
final class ReadingsCard {
  private final Card card =
      new Card("Readings", "[]push" + "[right,80::]".repeat(Readings.JOINT_COLUMNS.size()));
  private final List<List<JLabel>> joints = new ArrayList<>();
  private final List<JLabel> others = new ArrayList<>();

  ReadingsCard() {
    card.add(new JLabel());
    Readings.JOINT_COLUMNS.forEach(title -> card.add(quiet(title)));
    for (int joint = 0; joint < Joints.COUNT; joint++) {
      String title = Readings.JOINTS.get(joint);
      card.add(new JLabel(title));
      List<JLabel> row = new ArrayList<>();
      for (String column : Readings.JOINT_COLUMNS) {
        row.add(value(title + ": " + column));
      }
      row.forEach(card::add);
      joints.add(row);
    }
    JPanel below = new JPanel(new MigLayout("insets 0, gap 8 4, wrap", "[]push[right]"));
    below.setOpaque(false);
    for (String title : Readings.OTHERS) {
      JLabel value = value(title);
      others.add(value);
      below.add(new JLabel(title));
      below.add(value);
    }
    card.add(below, "span, growx, gaptop 12");
  }

  private static JLabel quiet(String text) {
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
