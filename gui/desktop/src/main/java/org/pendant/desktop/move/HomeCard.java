package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.box.BoxSetup;
import org.pendant.kit.form.HoldButton;
import org.pendant.kit.form.Remark;
import org.pendant.kit.form.RemarkSpace;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;
import org.pendant.models.arm.Joints;

/** Home card: where home is: go there, put it where the arm is, or type it. */
final class HomeCard {
  private final MovePresenter presenter;
  private final TitledCard card = new TitledCard("home", text("home"), "[grow, fill]");
  private final List<NumberField> fields = new ArrayList<>();
  private final List<JLabel> units = new ArrayList<>();
  private final Remark problem = new Remark("move-home-problem", Palette::error);
  private final HoldButton go;
  private final JButton here = new JButton(text("setHomeToHere"));
  private final JButton set = new JButton(text("setTyped"));
  private final JButton reset = new JButton(text("discard"));
  private final JButton standard = new JButton(text("standard"));

  HomeCard(MovePresenter presenter) {
    this.presenter = presenter;
    go = new HoldButton(text("holdToGoHome"), null, presenter::holdHome, presenter.jog()::release);
    TitledCard.named(go, "move-home", text("holdToMoveAllJointsHome"));
    TitledCard.named(here, "move-home-here", text("makeThePresentJointPositionsHome"));
    here.addActionListener(event -> presenter.setHomeHere());
    TitledCard.named(set, "move-set-home", text("makeTheTypedJointPositionsHome"));
    set.addActionListener(event -> presenter.home().setTyped());
    TitledCard.named(reset, "move-reset-home", text("forgetWhatYouHaveTyped"));
    reset.addActionListener(event -> presenter.home().draft().reset());
    TitledCard.named(standard, "move-standard-home", text("homeIsWhereARobotIs"));
    standard.addActionListener(event -> presenter.home().set(BoxSetup.START_RAD));
    card.add(grid(), "grow");
    card.add(new RemarkSpace(1, problem), Remark.LAYOUT);
    card.add(row(go, here), "grow, gaptop 4");
    card.add(row(set, reset, standard), "grow");
  }

  private JComponent grid() {
    JPanel grid =
        new JPanel(new MigLayout("insets 0, gap 8 4", "[]8[grow, fill]4[]16[]8[grow, fill]4[]"));
    grid.setOpaque(false);
    for (int i = 0; i < Joints.COUNT; i++) {
      String name = JointNames.of(i);
      NumberField field =
          new NumberField(
              presenter.home().draft(), i, "move-home-" + JointNames.id(i), text("homeOf", name));
      JLabel label = new JLabel(name);
      label.setLabelFor(field);
      fields.add(field);
      units.add(new JLabel());
      int column = i < 3 ? 0 : 3;
      grid.add(label, "cell " + column + " " + i % 3);
      grid.add(field, "cell " + (column + 1) + " " + i % 3 + ", w 60:84:");
      grid.add(units.get(i), "cell " + (column + 2) + " " + i % 3);
    }
    return grid;
  }

  private static JComponent row(JButton... buttons) {
    TitledCard.compact(buttons);
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8"));
    row.setOpaque(false);
    for (JButton each : buttons) {
      row.add(each);
    }
    return row;
  }

  JComponent component() {
    return card;
  }

  void refresh() {
    HomePresenter home = presenter.home();
    Draft draft = home.draft();
    for (int i = 0; i < Joints.COUNT; i++) {
      fields.get(i).refresh();
      units.get(i).setText(draft.unit(i).symbol());
    }
    boolean reachable = home.within(presenter::range);
    go.setEnabled(presenter.movable() && reachable);
    set.setEnabled(draft.edited() && draft.valid());
    reset.setEnabled(draft.edited());
    standard.setEnabled(!home.standard());
    problem.say(problemText(draft, reachable));
  }

  private static String problemText(Draft draft, boolean reachable) {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!draft.problem(i).isEmpty()) {
        return JointNames.problem(i, draft.problem(i));
      }
    }
    return reachable ? "" : text("homeIsOutsideTheRangeOf");
  }
}
