package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.kit.form.HoldButton;
import org.pendant.kit.form.Remark;
import org.pendant.kit.form.RemarkSpace;
import org.pendant.kit.layout.FlushRow;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;

/** Pose card: the pose of the TCP: read it, type another one, and go there. */
final class PoseCard {
  private final MovePresenter presenter;
  private final TitledCard card = new TitledCard("tcp-pose", text("tcpPose"), "[grow, fill]");
  private final JLabel where = new JLabel();
  private final PoseFields fields;
  private final Remark problem = new Remark("move-pose-problem", Palette::error);
  private final Remark note = new Remark("move-pose-note", Palette::warning);
  private final Remark hint = new Remark("move-pose-hint", Palette::quiet);
  private final HoldButton go;
  private final HoldButton align;
  private final List<Runnable> follow = new ArrayList<>();
  private final JButton reset = new JButton(text("discard"));

  /** A card; see {@link JointsCard} for the arguments. */
  PoseCard(MovePresenter presenter, Consumer<String> copy, Consumer<String> waypoint) {
    this.presenter = presenter;
    fields = new PoseFields(presenter.goals().pose(), "move-pose-", text("poseOfTheTcp"));
    where.setName("move-pose-frame");
    go = new HoldButton(text("holdToGo"), null, presenter::holdPoseGoal, presenter.jog()::release);
    TitledCard.named(go, "move-go-pose", text("holdToMoveAllJointsTo"));
    align =
        new HoldButton(
            text("holdToAlign"), null, presenter::holdAlignment, presenter.jog()::release);
    TitledCard.named(align, "move-align", text("holdToTurnTheToolParallel"));
    card.add(where);
    card.add(choices(), "grow");
    card.add(fields.component(), "grow, wmin 0, gaptop 8");
    card.add(new RemarkSpace(2, problem, note, hint), Remark.LAYOUT);
    card.add(buttons(copy, waypoint), "grow, gaptop 8");
  }

  JComponent component() {
    return card;
  }

  private JComponent choices() {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8", "[][][grow]"));
    row.setOpaque(false);
    row.add(
        choice(
            "move-length-unit",
            text("unitOfLengths"),
            DisplayUnit.of(DisplayUnit.Kind.LENGTH).toArray(DisplayUnit[]::new),
            PoseForm::length,
            unit -> new PoseForm(unit, presenter.form().angle(), presenter.form().rotation())));
    row.add(
        choice(
            "move-angle-unit",
            text("unitOfAngles"),
            DisplayUnit.of(DisplayUnit.Kind.ANGLE).toArray(DisplayUnit[]::new),
            PoseForm::angle,
            unit -> new PoseForm(presenter.form().length(), unit, presenter.form().rotation())));
    row.add(
        choice(
            "move-rotation-form",
            text("howRotationsAreWritten"),
            RotationForm.values(),
            PoseForm::rotation,
            form -> new PoseForm(presenter.form().length(), presenter.form().angle(), form)));
    return row;
  }

  private <T> JComboBox<T> choice(
      String name,
      String tip,
      T[] values,
      Function<PoseForm, T> shown,
      Function<T, PoseForm> form) {
    JComboBox<T> box = new JComboBox<>(values);
    box.setSelectedItem(shown.apply(presenter.form()));
    TitledCard.named(box, name, tip);
    box.addActionListener(
        event -> presenter.setForm(form.apply(box.getItemAt(box.getSelectedIndex()))));
    follow.add(
        () -> {
          T now = shown.apply(presenter.form());
          if (!now.equals(box.getSelectedItem())) {
            box.setSelectedItem(now);
          }
        });
    return box;
  }

  private JComponent buttons(Consumer<String> copy, Consumer<String> waypoint) {
    TitledCard.named(reset, "move-reset-pose", text("forgetWhatYouHaveTypedAnd"));
    reset.addActionListener(event -> presenter.goals().discard());
    JButton copyButton = new JButton(text("copy"));
    TitledCard.named(copyButton, "move-copy-pose", text("copyThePoseInTheBase"));
    copyButton.addActionListener(event -> copy.accept(presenter.poseScript()));
    JButton insert = new JButton(text("insert"));
    TitledCard.named(insert, "move-insert-movel", text("insertMovelToThePoseIn"));
    insert.addActionListener(event -> waypoint.accept("movel(" + presenter.poseScript() + ")"));
    TitledCard.compact(go, align, reset, copyButton, insert);
    JPanel row = new FlushRow(6);
    row.add(go);
    row.add(reset);
    row.add(align);
    row.add(copyButton);
    row.add(insert);
    return row;
  }

  void refresh() {
    GoalPresenter goals = presenter.goals();
    Draft draft = goals.pose();
    Draft joints = goals.joints();
    follow.forEach(Runnable::run);
    where.setText(
        presenter.jog().axes() == JogAxes.FRAME ? text("inTheFrame") : text("inTheBaseOfTheRobot"));
    fields.refresh(presenter.form());
    align.setEnabled(presenter.movable());
    go.setEnabled(presenter.movable() && draft.edited() && draft.valid() && goals.poseReachable());
    reset.setEnabled(draft.edited());
    boolean unreachable = draft.edited() && draft.valid() && !goals.poseReachable();
    problem.say(unreachable ? goals.poseText() : fields.problem(presenter.form()));
    note.say(unreachable ? "" : goals.poseText());
    hint.say(hintText(draft, joints, unreachable));
  }

  private static String hintText(Draft draft, Draft joints, boolean unreachable) {
    if (joints.edited()) {
      return joints.valid() ? text("whereTheTcpIsWithThe") : "";
    }
    return draft.edited() && draft.valid() && !unreachable ? Draft.GOAL : "";
  }
}
