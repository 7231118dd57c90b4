package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.Remark;
import org.pendant.kit.form.RemarkSpace;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;

/** Payload card: what is mounted on the flange: mass, centre of gravity, inertia. */
final class PayloadCard {
  private static final List<String> LABELS =
      List.of(text("mass"), "X", "Y", "Z", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz");
  private static final List<String> NAMES =
      List.of("m", "x", "y", "z", "ixx", "iyy", "izz", "ixy", "ixz", "iyz");

  private final ToolPresenter presenter;
  private final TitledCard card = new TitledCard("payload", text("payload"), "[grow, fill]");
  private final List<NumberField> fields = new ArrayList<>();
  private final List<JLabel> units = new ArrayList<>();
  private final Remark problem = new Remark("move-payload-problem", Palette::error);
  private final JButton set = new JButton(text("setPayload"));
  private final JButton reset = new JButton(text("discard"));

  PayloadCard(ToolPresenter presenter) {
    this.presenter = presenter;
    TitledCard.named(set, "move-set-payload", text("declareThisPayloadZeroesTheForce"));
    set.addActionListener(event -> presenter.setPayload());
    TitledCard.named(reset, "move-reset-payload", text("forgetWhatYouHaveTyped"));
    reset.addActionListener(event -> presenter.resetPayload());
    card.add(grid(0, ToolPresenter.INERTIA), "grow");
    card.add(quiet(text("xYZCentreOfGravity")));
    card.add(grid(ToolPresenter.INERTIA, LABELS.size()), "grow, gaptop 8");
    card.add(quiet(text("inertiaAboutItAlongTheAxes")));
    card.add(new RemarkSpace(1, problem), Remark.LAYOUT);
    TitledCard.compact(set, reset);
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8"));
    row.setOpaque(false);
    row.add(set);
    row.add(reset);
    card.add(row, "grow, gaptop 4");
  }

  private static Remark quiet(String text) {
    Remark remark = new Remark("move-payload-note", Palette::quiet);
    remark.say(text);
    return remark;
  }

  private JComponent grid(int from, int to) {
    JPanel grid =
        new JPanel(new MigLayout("insets 0, gap 8 4", "[]8[grow, fill]4[]16[]8[grow, fill]4[]"));
    grid.setOpaque(false);
    for (int i = from; i < to; i++) {
      boolean left = from == 0 ? i == 0 : i < from + 3;
      int row = left ? i - from : from == 0 ? i - 1 : i - from - 3;
      add(grid, i, left ? 0 : 3, row);
    }
    return grid;
  }

  private void add(JPanel grid, int index, int column, int row) {
    String tip =
        switch (index) {
          case 0 -> text("massOfThePayload");
          case 1, 2, 3 -> text("centreOfGravity", LABELS.get(index));
          default -> text("inertiaOf", LABELS.get(index));
        };
    NumberField field =
        new NumberField(presenter.payload(), index, "move-payload-" + NAMES.get(index), tip);
    JLabel label = new JLabel(LABELS.get(index));
    label.setLabelFor(field);
    fields.add(field);
    units.add(new JLabel());
    grid.add(label, "cell " + column + " " + row);
    grid.add(field, "cell " + (column + 1) + " " + row + ", wmin 60");
    grid.add(units.getLast(), "cell " + (column + 2) + " " + row);
  }

  JComponent component() {
    return card;
  }

  void refresh() {
    for (int i = 0; i < fields.size(); i++) {
      fields.get(i).refresh();
      units.get(i).setText(presenter.payload().unit(i).symbol());
    }
    problem.say(presenter.payloadProblem());
    set.setEnabled(presenter.payload().edited() && presenter.payload().valid());
    reset.setEnabled(presenter.payload().edited());
  }
}
