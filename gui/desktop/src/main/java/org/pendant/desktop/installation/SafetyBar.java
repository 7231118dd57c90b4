package org.pendant.desktop.installation;

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
  private static final String LOCKED =
      "Locked. Unlock to change it; nothing holds before you apply it.";
  private static final String UNLOCKED = "Unlocked. Nothing has changed yet.";
  private static final String CHANGED =
      "Changed, not applied yet: the controller still has what was there.";

  private final SafetyDraft draft;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, gap 8 6, wrap, hidemode 3", "[grow, fill]"));
  private final JLabel checksum = new JLabel();
  private final Remark state;
  private final Remark summary;
  private final JButton unlock = new JButton("Unlock");
  private final JButton apply = new JButton("Apply\u2026");
  private final JButton discard = new JButton("Discard");
  private final JButton really = new JButton("Apply and power off");
  private final JButton back = new JButton("Back");
  private boolean asking;

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
    summary = new Remark(page + "-changes", Palette::warning);
    TitledCard.named(unlock, page + "-unlock", "Change the safety configuration");
    unlock.addActionListener(
        event -> {
          draft.unlock();
          discard.requestFocusInWindow();
        });
    TitledCard.named(apply, page + "-apply", "Show what changes, then apply it");
    apply.addActionListener(event -> ask(true));
    TitledCard.named(discard, page + "-discard", "Forget the changes, and lock");
    discard.addActionListener(
        event -> {
          draft.discard();
          unlock.requestFocusInWindow();
        });
    TitledCard.named(really, page + "-apply-really", "Apply the changes; the arm is powered off");
    really.addActionListener(
        event -> {
          asking = false;
          draft.apply();
          unlock.requestFocusInWindow();
        });
    TitledCard.named(back, page + "-apply-back", "Do not apply them yet");
    back.addActionListener(event -> ask(false));
    TitledCard.compact(unlock, apply, discard, really, back);
    JPanel row = new JPanel(new WrappingRow(PartsForm.BETWEEN));
    row.setOpaque(false);
    List.of(unlock, apply, discard, really, back).forEach(row::add);
    row.add(checksum);
    checksum.setName(page + "-checksum");
    checksum.setToolTipText(
        "Of the settings as shown: equal ones have the same, any change makes another one");
    panel.setOpaque(false);
    panel.add(row, "wmin 0, pad 0 -" + PartsForm.BETWEEN + " 0 0");
    panel.add(state, Remark.LAYOUT);
    panel.add(summary, Remark.LAYOUT);
    draft.addListener(
        () -> {
          asking = asking && draft.changed();
          show();
        });
  }

  JComponent component() {
    return panel;
  }

  private void ask(boolean on) {
    asking = on;
    show();
    (on ? back : apply).requestFocusInWindow();
  }

  void show() {
    boolean unlocked = draft.unlocked();
    unlock.setVisible(!unlocked);
    apply.setVisible(unlocked && !asking);
    apply.setEnabled(draft.changed());
    discard.setVisible(unlocked && !asking);
    really.setVisible(unlocked && asking);
    back.setVisible(unlocked && asking);
    checksum.setText("Checksum " + draft.checksum());
    state.say(!unlocked ? LOCKED : draft.changed() ? CHANGED : UNLOCKED);
    summary.say(asking ? String.join("\n", draft.changes()) : "");
  }
}
