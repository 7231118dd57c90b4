package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.kit.form.HoldButton;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/**
 * Freedrive card: freedrive on while a button is held or until it is switched off, along some axes
 * or all.
 */
final class FreedriveCard {
  private static final List<String> AXES = List.of("X", "Y", "Z", "RX", "RY", "RZ");
  private static final String HINT = text("dragTheArmInThe3d");

  private final FreedrivePresenter presenter;
  private final TitledCard card = new TitledCard("freedrive", text("freedrive"), "[grow, fill]");
  private final Segments<JogAxes> frames;
  private final List<JToggleButton> axes = new ArrayList<>();
  private final HoldButton hold;
  private final JToggleButton keep = new JToggleButton(text("keepOn"));
  private final Remark status = new Remark("move-freedrive-status", Palette::quiet);
  private final Remark warning = new Remark("move-freedrive-warning", Palette::warning);
  private final Remark reason = new Remark("move-freedrive-reason", Palette::warning);

  FreedriveCard(FreedrivePresenter presenter) {
    this.presenter = presenter;
    frames =
        new Segments<>(
            JogAxes.class,
            presenter.axes(),
            "move-free-frame-",
            JogAxes::title,
            each -> text("theFreeAxesAreThoseOf", each.meaning()),
            presenter::setAxes);
    hold = new HoldButton(text("holdForFreedrive"), null, presenter::begin, presenter::release);
    TitledCard.named(hold, "move-freedrive", text("theArmCanBeGuidedBy"));
    TitledCard.named(keep, "move-freedrive-keep", text("keepFreedriveOnUntilThisIs"));
    keep.addActionListener(event -> switchTo(keep.isSelected()));
    compact(keep);
    TitledCard.compact(hold);
    card.add(row(hold, keep), "grow");
    card.add(choices(), "grow, gaptop 4");
    card.add(status, Remark.LAYOUT);
    card.add(warning, Remark.LAYOUT);
    card.add(reason, Remark.LAYOUT);
    Remark hint = new Remark("move-freedrive-hint", Palette::quiet);
    card.add(hint, Remark.LAYOUT);
    hint.say(HINT);
  }

  private void switchTo(boolean on) {
    if (on) {
      presenter.begin();
    } else {
      presenter.release();
    }
  }

  private JComponent choices() {
    JPanel grid = new JPanel(new MigLayout("insets 0, gap 8 6, wrap", "[][grow]"));
    grid.setOpaque(false);
    grid.add(new JLabel(text("axesOf")));
    grid.add(frames.component());
    grid.add(new JLabel(text("freeLabel")));
    JPanel row = new JPanel(new MigLayout("insets 0, gap 2", ""));
    row.setOpaque(false);
    for (int i = 0; i < AXES.size(); i++) {
      row.add(axis(i));
    }
    JButton all = new JButton(text("allAxes"));
    TitledCard.named(all, "move-free-all", text("freeAllAxes"));
    TitledCard.compact(all);
    all.addActionListener(event -> presenter.setFree(FreeAxes.ALL));
    row.add(all, "gapleft 8");
    grid.add(row);
    return grid;
  }

  private JToggleButton axis(int axis) {
    String name = AXES.get(axis);
    JToggleButton button = new JToggleButton(name, true);
    compact(button);
    TitledCard.named(
        button,
        "move-free-" + name.toLowerCase(Locale.ROOT),
        (axis < 3 ? text("freeToMoveAlong", name) : text("freeToTurnAbout", name.substring(1))));
    button.addActionListener(event -> presenter.setFree(axis, button.isSelected()));
    axes.add(button);
    return button;
  }

  private static void compact(JToggleButton button) {
    button.putClientProperty("FlatLaf.style", "minimumWidth: 0; margin: 2,8,2,8");
  }

  private static JComponent row(JComponent... parts) {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8"));
    row.setOpaque(false);
    for (JComponent each : parts) {
      row.add(each);
    }
    return row;
  }

  JComponent component() {
    return card;
  }

  void refresh() {
    hold.setEnabled(presenter.movable());
    keep.setEnabled(presenter.movable());
    keep.setSelected(presenter.on());
    frames.show(presenter.axes());
    for (int i = 0; i < axes.size(); i++) {
      axes.get(i).setSelected(presenter.free().free(i));
    }
    status.say(presenter.status());
    warning.say(presenter.warning());
    reason.say(Messages.shown(presenter.reason()));
  }
}
