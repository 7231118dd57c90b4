package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;

/** Safety bar: unlocks the safety configuration, and applies it after showing what changes. */
final class SafetyBar {
  private static final String LOCKED = text("lockedUnlockToChangeItNothing");
  private static final String UNLOCKED = text("unlockedNothingHasChangedYet");
  private static final String CHANGED = text("changedNotAppliedYetTheController");

  private final SafetyDraft draft;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, gap 8 6, wrap, hidemode 3", "[grow, fill]"));
  private final JLabel checksum = new JLabel();
  private final Remark state;
  private final JButton unlock = new JButton(text("unlock"));
  private final JButton apply = new JButton(text("apply"));
  private final JButton discard = new JButton(text("discard"));
  private final SafetyQuestion question;

  /**
   * A bar.
   *
   * @param page with which the names of its components begin
   */
  SafetyBar(SafetyDraft draft, String page) {
    this.draft = draft;
    state =
        new Remark(page + "-lock-state", Palette::quiet)
            .withRoomFor(List.of(LOCKED, UNLOCKED, CHANGED));
    TitledCard.named(unlock, page + "-unlock", text("changeTheSafetyConfiguration"));
    unlock.addActionListener(
        event -> {
          draft.unlock();
          discard.requestFocusInWindow();
        });
    TitledCard.named(apply, page + "-apply", text("showWhatChangesThenApplyIt"));
    apply.addActionListener(event -> ask());
    TitledCard.named(discard, page + "-discard", text("forgetTheChangesAndLock"));
    discard.addActionListener(
        event -> {
          draft.discard();
          unlock.requestFocusInWindow();
        });
    TitledCard.compact(unlock, apply, discard);
    JPanel row = new JPanel(new WrappingRow(PartsForm.BETWEEN));
    row.setOpaque(false);
    List.of(unlock, apply, discard).forEach(row::add);
    row.add(checksum);
    checksum.setName(page + "-checksum");
    checksum.setToolTipText(text("ofTheSettingsAsShownEqual"));
    panel.setOpaque(false);
    panel.add(row, "wmin 0, pad 0 -" + PartsForm.BETWEEN + " 0 0");
    panel.add(state, Remark.LAYOUT);
    question = new SafetyQuestion(row, page + "-apply");
    draft.addListener(this::show);
  }

  JComponent component() {
    return panel;
  }

  private void ask() {
    question.ask(draft.changes(), text("applyAndPowerOff"), this::apply, apply);
  }

  private void apply() {
    draft.apply();
    unlock.requestFocusInWindow();
  }

  void show() {
    boolean unlocked = draft.unlocked();
    unlock.setVisible(!unlocked);
    apply.setVisible(unlocked);
    apply.setEnabled(draft.changed());
    discard.setVisible(unlocked);
    // what was asked is not what would change now
    question.close();
    checksum.setText(text("checksum", draft.checksum()));
    state.say(!unlocked ? LOCKED : draft.changed() ? CHANGED : UNLOCKED);
  }
}
