package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.kit.form.HoldButton;
import org.pendant.kit.form.Remark;
import org.pendant.kit.form.RemarkSpace;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;
import org.pendant.models.arm.Joints;

/** Joints card: the six joints: turn them, see how far they may, and type where they should go. */
final class JointsCard {
  private final MovePresenter presenter;
  private final TitledCard card =
      new TitledCard("joints", text("joints"), "[][][grow, fill][][fill][]");
  private final List<HoldButton> holds = new ArrayList<>();
  private final List<RangeBar> bars = new ArrayList<>();
  private final List<NumberField> fields = new ArrayList<>();
  private final List<JLabel> units = new ArrayList<>();
  private final Remark problem = new Remark("move-joints-problem", Palette::error);
  private final Remark hint = new Remark("move-joints-hint", Palette::quiet);
  private final HoldButton go;
  private final JButton reset = new JButton(text("discard"));

  /**
   * A card.
   *
   * @param copy puts text on the clipboard
   * @param waypoint puts a line into the program
   */
  JointsCard(MovePresenter presenter, Consumer<String> copy, Consumer<String> waypoint) {
    this.presenter = presenter;
    for (int i = 0; i < Joints.COUNT; i++) {
      addRow(i);
    }
    card.add(new RemarkSpace(1, problem, hint), "span, " + Remark.LAYOUT);
    go = new HoldButton(text("holdToGo"), null, presenter::holdJointGoal, presenter.jog()::release);
    TitledCard.named(go, "move-go-joints", text("holdToMoveToTheJoint"));
    TitledCard.named(reset, "move-reset-joints", text("forgetWhatYouHaveTypedAnd"));
    reset.addActionListener(event -> presenter.goals().discard());
    JButton copyButton = new JButton(text("copy"));
    TitledCard.named(copyButton, "move-copy-joints", text("copyTheJointPositionsAsUrscript"));
    copyButton.addActionListener(event -> copy.accept(presenter.jointsScript()));
    JButton insert = new JButton(text("insert"));
    TitledCard.named(insert, "move-insert-movej", text("insertMovejToTheseJointPositions"));
    insert.addActionListener(event -> waypoint.accept("movej(" + presenter.jointsScript() + ")"));
    TitledCard.compact(go, reset, copyButton, insert);
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8", "[][grow][][]"));
    row.setOpaque(false);
    row.add(go);
    row.add(reset);
    row.add(copyButton);
    row.add(insert);
    card.add(row, "span, grow, gaptop 8");
  }

  JComponent component() {
    return card;
  }

  private void addRow(int joint) {
    String id = JointNames.id(joint);
    RangeBar bar = new RangeBar();
    bars.add(bar);
    NumberField field =
        new NumberField(
            presenter.goals().joints(),
            joint,
            "move-joint-" + id,
            text("positionOf", JointNames.of(joint)));
    fields.add(field);
    JLabel label = new JLabel(JointNames.of(joint));
    label.setLabelFor(field);
    JLabel unit = new JLabel();
    units.add(unit);
    card.add(label);
    card.add(hold("\u2212", joint, -1, id), "w 36::, h 34::, sg hold");
    card.add(bar, "growx");
    card.add(hold("+", joint, 1, id), "w 36::, h 34::, sg hold");
    card.add(field);
    card.add(unit);
  }

  private HoldButton hold(String text, int joint, int direction, String id) {
    HoldButton button =
        new HoldButton(
            text, null, () -> presenter.jog().turn(joint, direction), presenter.jog()::letGo);
    String way = direction > 0 ? "up" : "down";
    button.putClientProperty("FlatLaf.style", "minimumWidth: 0");
    TitledCard.named(
        button,
        "move-" + id + "-" + way,
        text(direction > 0 ? "turnUp" : "turnDown", JointNames.of(joint)));
    holds.add(button);
    return button;
  }

  void refresh() {
    Draft draft = presenter.goals().joints();
    Draft pose = presenter.goals().pose();
    for (int i = 0; i < Joints.COUNT; i++) {
      JointRange range = presenter.range(i);
      OptionalDouble goal =
          draft.edited() || presenter.goals().poseReachable()
              ? OptionalDouble.of(draft.values()[i])
              : OptionalDouble.empty();
      bars.get(i).show(range, presenter.positionRad(i), goal, draft.unit(i));
      bars.get(i).setToolTipText(rangeText(i, range));
      fields.get(i).refresh();
      units.get(i).setText(draft.unit(i).symbol());
    }
    holds.forEach(each -> each.setEnabled(presenter.movable()));
    go.setEnabled(presenter.movable() && draft.edited() && draft.valid());
    reset.setEnabled(draft.edited());
    problem.say(problemText(draft));
    hint.say(hintText(draft, pose));
  }

  private String hintText(Draft draft, Draft pose) {
    if (pose.edited()) {
      return presenter.goals().poseReachable() ? text("whereTheJointsAreAtThe") : "";
    }
    return draft.edited() && draft.valid() ? Draft.GOAL : "";
  }

  private static String problemText(Draft draft) {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!draft.problem(i).isEmpty()) {
        return JointNames.problem(i, draft.problem(i));
      }
    }
    return "";
  }

  private String rangeText(int joint, JointRange range) {
    DisplayUnit unit = presenter.goals().joints().unit(joint);
    return range.unlimited()
        ? text("turnsWithoutEnd", JointNames.of(joint))
        : text(
            "canTurnFromTo",
            JointNames.of(joint),
            unit.text(range.minRad()),
            unit.text(range.maxRad()),
            unit.symbol());
  }
}
