package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.Map;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.Remark;
import org.pendant.kit.form.RemarkSpace;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.theme.Palette;
import org.pendant.models.pose.Pose;

/**
 * Frame card: a frame of the user's own, along whose axes the tool can be moved; seen while it is
 * chosen.
 */
final class FrameCard {
  private final MovePresenter presenter;
  private final TitledCard card =
      new TitledCard("frame-in-the-base", text("frameInTheBase"), "[grow, fill]");
  private final PoseFields fields;
  private final Remark problem = new Remark("move-frame-problem", Palette::error);
  private final JComboBox<String> features = new JComboBox<>();
  private Map<String, Pose> frames = Map.of();
  private final JButton set = new JButton(text("setFrame"));
  private final JButton reset = new JButton(text("discard"));

  FrameCard(MovePresenter presenter) {
    this.presenter = presenter;
    FramePresenter frame = presenter.frame();
    fields = new PoseFields(frame.draft(), "move-own-frame-", text("frameInTheBase"));
    JButton here = new JButton(text("setToTcp"));
    TitledCard.named(set, "move-set-frame", text("moveAlongTheAxesOfThis"));
    set.addActionListener(event -> frame.setTyped());
    TitledCard.named(reset, "move-reset-frame", text("forgetWhatYouHaveTyped"));
    reset.addActionListener(event -> frame.draft().reset());
    TitledCard.named(here, "move-frame-here", text("putTheFrameWhereTheTcp"));
    here.addActionListener(event -> presenter.setFrameHere());
    TitledCard.compact(set, reset, here);
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8"));
    row.setOpaque(false);
    row.add(set);
    row.add(reset);
    row.add(here);
    TitledCard.named(features, "move-frame-features", text("takeAFeatureOfTheInstallation"));
    features.addActionListener(event -> choose());
    offer(Map.of());
    card.add(features, "growx");
    card.add(fields.component(), "grow");
    card.add(new RemarkSpace(1, problem), Remark.LAYOUT);
    card.add(row, "grow, gaptop 4");
    card.setVisible(false);
  }

  /** Features that can be taken for the frame, by name. */
  void offer(Map<String, Pose> offered) {
    frames = Map.of();
    features.removeAllItems();
    features.addItem(text("takeAFeature"));
    offered.keySet().forEach(features::addItem);
    features.setVisible(!offered.isEmpty());
    frames = offered;
  }

  private void choose() {
    Pose chosen = frames.get(String.valueOf(features.getSelectedItem()));
    if (chosen != null) {
      presenter.frame().set(chosen);
      features.setSelectedIndex(0);
    }
  }

  JComponent component() {
    return card;
  }

  void refresh() {
    Draft draft = presenter.frame().draft();
    card.setVisible(presenter.jog().axes() == JogAxes.FRAME);
    fields.refresh(presenter.form());
    problem.say(fields.problem(presenter.form()));
    set.setEnabled(draft.edited() && draft.valid());
    reset.setEnabled(draft.edited());
  }
}
