package org.pendant.desktop.unit;

import static org.pendant.desktop.unit.UnitTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.EntryField;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.pose.Pose;

/** Pose rows: the six fields of a pose in a form, and the choice of how its rotation is written. */
public final class PoseRows {
  private static final List<String> AXES = List.of("X", "Y", "Z");
  private static final int ANGLES = 3;

  private PoseRows() {}

  /**
   * Adds them.
   *
   * @param name with which the names of the fields begin
   * @param usable whether the pose can be typed now
   */
  public static <T> void addTo(
      PartsForm<T> form,
      String name,
      RotationChoice rotation,
      Function<T, Pose> get,
      BiFunction<T, Pose, T> with,
      Predicate<T> usable) {
    JPanel grid =
        new JPanel(
            new MigLayout("insets 0, gap 6", "[][50:100:130, fill][]16[][50:100:130, fill][]"));
    grid.setOpaque(false);
    List<EntryField> fields = new ArrayList<>();
    List<JLabel> angleLabels = new ArrayList<>();
    for (int i = 0; i < ANGLES; i++) {
      int axis = i;
      EntryField length =
          form.number(
              name + "-" + AXES.get(i).toLowerCase(Locale.ROOT),
              AXES.get(i),
              Measure.MILLIMETRE,
              now -> get.apply(now).get(axis),
              (before, typed) -> with.apply(before, get.apply(before).with(axis, typed)));
      EntryField angle =
          form.number(
              name + "-r" + AXES.get(i).toLowerCase(Locale.ROOT),
              "R" + AXES.get(i),
              Measure.DEGREE,
              now -> angles(get.apply(now), rotation.form())[axis],
              (before, typed) ->
                  with.apply(before, turned(get.apply(before), rotation.form(), axis, typed)));
      JLabel lengthLabel = label(AXES.get(i), length);
      JLabel angleLabel = label("R" + AXES.get(i), angle);
      angleLabels.add(angleLabel);
      grid.add(lengthLabel);
      grid.add(length, "wmin 50, wmax 160");
      grid.add(form.unit(Measure.MILLIMETRE));
      grid.add(angleLabel);
      grid.add(angle, "wmin 50, wmax 160");
      grid.add(form.unit(Measure.DEGREE), "wrap");
      fields.add(length);
      fields.add(angle);
    }
    JComboBox<RotationForm> choice =
        TitledCard.named(
            new JComboBox<>(RotationForm.values()),
            name + "-rotation",
            text("howRotationsAreWritten"));
    choice.addActionListener(
        event -> rotation.set(choice.getItemAt(Math.max(0, choice.getSelectedIndex()))));
    form.grid(grid, fields);
    form.add(text("rotationAs"), choice);
    form.follow(
        now -> {
          choice.setSelectedItem(rotation.form());
          for (int i = 0; i < ANGLES; i++) {
            String words = rotation.form().labels().get(i);
            angleLabels.get(i).setText(words);
            fields.get(2 * i + 1).getAccessibleContext().setAccessibleName(words);
          }
          fields.forEach(each -> each.setEnabled(usable.test(now)));
        });
  }

  private static JLabel label(String text, JTextField field) {
    JLabel label = new JLabel(text);
    label.setLabelFor(field);
    return label;
  }

  private static double[] angles(Pose pose, RotationForm form) {
    double[] angles = new double[ANGLES];
    form.fromVector(pose.rx(), pose.ry(), pose.rz(), angles);
    return angles;
  }

  private static Pose turned(Pose pose, RotationForm form, int axis, double angleRad) {
    double[] angles = angles(pose, form);
    angles[axis] = angleRad;
    double[] vector = new double[ANGLES];
    form.toVector(angles[0], angles[1], angles[2], vector);
    return new Pose(pose.x(), pose.y(), pose.z(), vector[0], vector[1], vector[2]);
  }
}
