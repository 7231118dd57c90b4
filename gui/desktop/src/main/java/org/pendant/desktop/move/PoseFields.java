package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.text.Messages;

/** Pose fields: the six numbers of a pose, position on the left and rotation on the right. */
final class PoseFields {
  private static final List<String> NAMES =
      List.of("x", "y", "z", "rotation-1", "rotation-2", "rotation-3");

  private static final List<String> PARTS =
      List.of(
          text("poseX"),
          text("poseY"),
          text("poseZ"),
          text("poseRotation1"),
          text("poseRotation2"),
          text("poseRotation3"));

  private final Draft draft;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, gap 8 4", "[]8[grow, fill]4[]24[]8[grow, fill]4[]"));
  private final List<JLabel> labels = new ArrayList<>();
  private final List<NumberField> fields = new ArrayList<>();
  private final List<JLabel> units = new ArrayList<>();

  /**
   * Fields for a draft of a pose.
   *
   * @param prefix of the fields' names
   * @param what the pose is, for people who cannot see it
   */
  PoseFields(Draft draft, String prefix, String what) {
    this.draft = draft;
    panel.setOpaque(false);
    for (int i = 0; i < draft.size(); i++) {
      fields.add(
          new NumberField(draft, i, prefix + NAMES.get(i), text("partOfPose", what, PARTS.get(i))));
      labels.add(new JLabel());
      labels.get(i).setLabelFor(fields.get(i));
      units.add(new JLabel());
    }
    for (int i = 0; i < 3; i++) {
      place(i, 0, i);
      place(i + 3, 3, i);
    }
  }

  private void place(int index, int column, int row) {
    panel.add(labels.get(index), "cell " + column + " " + row);
    panel.add(fields.get(index), "cell " + (column + 1) + " " + row + ", wmin 72");
    panel.add(units.get(index), "cell " + (column + 2) + " " + row);
  }

  JComponent component() {
    return panel;
  }

  void refresh(PoseForm form) {
    for (int i = 0; i < fields.size(); i++) {
      labels.get(i).setText(form.labels().get(i));
      fields.get(i).refresh();
      units.get(i).setText(draft.unit(i).symbol());
    }
  }

  /** The first problem with the name of its field; empty if there is none. */
  String problem(PoseForm form) {
    for (int i = 0; i < draft.size(); i++) {
      if (!draft.problem(i).isEmpty()) {
        return Messages.told(form.labels().get(i), draft.problem(i));
      }
    }
    return "";
  }
}
