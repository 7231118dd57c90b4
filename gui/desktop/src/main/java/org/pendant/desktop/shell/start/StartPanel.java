package org.pendant.desktop.shell.start;

import static org.pendant.desktop.shell.start.StartTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.EventQueue;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.form.HoldButton;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.layout.FlushRow;
import org.pendant.kit.theme.Overlay;
import org.pendant.kit.theme.Palette;
import org.pendant.kit.theme.WrappedText;

/**
 * Start panel: shows a {@link StartChoice} over the views and never over the footer. Escape
 * cancels.
 */
public final class StartPanel {
  /** How wide it would be, in pixels before scaling. */
  private static final int WIDTH = 480;

  private final StartChoice choice;
  private final Overlay overlay;
  private final JLabel title =
      new JLabel("", Glyph.WARNING.icon(20, Palette.warning()), JLabel.LEADING);
  private final WrappedText text = new WrappedText("", text("whatHappensFirst"));
  private final JButton move = button("start-move", text("moveThere"));
  private final HoldButton hold;
  private final JButton start = button("start-now", text("startAnyway"));
  private final JButton cancel = button("start-cancel", text("cancel"));
  private final JCheckBox ask = new JCheckBox(text("askEachTimeTheArmIs"));
  private final JPanel panel =
      new JPanel(
          new MigLayout(
              "insets 0, gap 8, wrap 1, hidemode 3", "[grow, fill, 0:" + WIDTH + ":]", ""));
  private StartChoice.Phase shown = StartChoice.Phase.NOTHING;
  private long asked;

  /**
   * A panel that is not open.
   *
   * @param under what it may cover
   */
  public StartPanel(JComponent under, StartChoice choice) {
    this.choice = choice;
    hold = new HoldButton(text("holdToMove"), null, choice::hold, choice::release);
    hold.setName("start-hold");
    panel.setOpaque(false);
    title.setName("start-title");
    title.putClientProperty("FlatLaf.styleClass", "h3");
    text.setName("start-text");
    text.setFocusable(false);
    tip(move, text("movesTheJointsThereSlowlyThen"));
    tip(hold, text("movesTheArmThereAsLong"));
    tip(cancel, text("theProgramDoesNotStartEscape"));
    move.addActionListener(event -> act(choice::moveThere));
    start.addActionListener(event -> act(choice::startNow));
    cancel.addActionListener(event -> act(choice::cancel));
    ask.setName("start-ask");
    ask.setOpaque(false);
    ask.setToolTipText(text("otherwiseProgramsStartFromWherever"));
    ask.addActionListener(event -> choice.setAsks(ask.isSelected()));
    JPanel buttons = new FlushRow(8);
    for (JButton each : new JButton[] {move, hold, start, cancel}) {
      buttons.add(each);
    }
    panel.add(title, "wmin 0");
    panel.add(text, "wmin 0");
    panel.add(buttons, "gaptop 8");
    panel.add(ask, "wmin 0");
    overlay = new Overlay("start-choice", under, panel);
    overlay.onEscape(() -> act(choice::cancel));
  }

  private static JButton button(String name, String words) {
    JButton button = new JButton(words);
    button.setName(name);
    button.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "press");
    button
        .getActionMap()
        .put(
            "press",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                button.doClick();
              }
            });
    return button;
  }

  private static void tip(JButton button, String tip) {
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleName(button.getText());
    button.getAccessibleContext().setAccessibleDescription(tip);
  }

  private void act(Runnable run) {
    run.run();
    update();
  }

  /** Shows a snapshot. */
  public void refresh(ControllerState state) {
    choice.refresh(state);
    update();
  }

  private void update() {
    StartChoice.Phase now = choice.phase();
    if (now == StartChoice.Phase.NOTHING) {
      overlay.close();
      shown = now;
      return;
    }
    boolean other = choice.asked() != asked;
    if (now != shown || other) {
      shown = now;
      show(now, other);
    }
    if (!text.getText().equals(choice.text())) {
      say(choice.text());
      overlay.place();
    }
  }

  /** Places it anew; where there is not enough room the setting goes, an action has it too. */
  private void fit() {
    overlay.place();
    if (panel.getParent() != null) {
      panel.getParent().validate();
    }
    if (ask.isVisible() && ask.getY() + ask.getHeight() > panel.getHeight()) {
      ask.setVisible(false);
    }
  }

  /** How many rows the words need follows from the width. */
  private void say(String words) {
    text.setText(words);
    if (text.getWidth() == 0) {
      text.setSize(UIScale.scale(WIDTH), Short.MAX_VALUE);
    }
  }

  private void show(StartChoice.Phase now, boolean other) {
    asked = choice.asked();
    title.setText(choice.title());
    title.setToolTipText(choice.title());
    panel.getAccessibleContext().setAccessibleName(choice.title());
    say(choice.text());
    boolean asking = now == StartChoice.Phase.ASKING;
    boolean moving = now == StartChoice.Phase.MOVING;
    move.setVisible(asking);
    move.setEnabled(choice.canMove());
    // Who still holds it when the arm is there lets it go there.
    hold.setVisible(!moving);
    hold.setEnabled(choice.canMove());
    start.setVisible(!moving);
    start.setText(asking ? text("startAnyway") : text("start"));
    tip(start, asking ? text("startsTheProgramWhereTheArm") : text("startsTheProgram"));
    cancel.setText(moving ? text("stop") : text("cancel"));
    tip(cancel, moving ? text("stopsTheArmEscape") : text("theProgramDoesNotStartEscape"));
    ask.setSelected(choice.asks());
    ask.setVisible(!moving);
    overlay.open();
    overlay.place();
    // How many rows words and buttons need is known when they have been laid out.
    EventQueue.invokeLater(this::fit);
    if (other) {
      overlay.takeFocus(cancel);
    } else if (now == StartChoice.Phase.THERE && !hold.getModel().isPressed()) {
      start.requestFocusInWindow();
    } else if (moving) {
      cancel.requestFocusInWindow();
    }
  }
}
