package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.awt.event.ActionEvent;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.theme.Palette;

/** Teach bar: says which place the arm is moved to be taught, until people accept it or leave. */
@SuppressWarnings("serial") // never written to a stream
final class TeachBar extends JPanel {
  private final JLabel text = new JLabel();
  private final JButton accept = new JButton(MoveTexts.text("ok"));
  private final JButton leave = new JButton(text("cancel"));
  private transient Runnable accepted = () -> {};
  private transient Runnable left = () -> {};

  TeachBar() {
    super(new MigLayout("insets 8 16 8 16, gap 12", "[grow, fill, 0::][][]"));
    setName("teach-bar");
    setBackground(Palette.tint(Palette.accent(), 0.12));
    text.setName("teach-text");
    accept.setName("teach-ok");
    leave.setName("teach-cancel");
    accept.setToolTipText(text("takesWhereTheArmIsNow"));
    leave.setToolTipText(text("leavesThePlaceAsItWas"));
    add(text, "wmin 0");
    add(accept);
    add(leave);
    accept.addActionListener(this::accept);
    leave.addActionListener(this::leave);
    registerKeyboardAction(
        this::leave, KeyStroke.getKeyStroke("ESCAPE"), WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
    setVisible(false);
  }

  /** Begins; an earlier request is left. */
  void ask(String what, Runnable whenAccepted, Runnable whenLeft) {
    accepted = whenAccepted;
    left = whenLeft;
    text.setText(text("moveTheArmToWhereShall", what));
    text.setToolTipText(text.getText());
    accept.getAccessibleContext().setAccessibleName(text("takeWhereTheArmIsFor", what));
    leave.getAccessibleContext().setAccessibleName(text("leaveAsItWas", what));
    setVisible(true);
    revalidate();
    accept.requestFocusInWindow();
  }

  private void accept(ActionEvent event) {
    Runnable then = accepted;
    end();
    then.run();
  }

  private void leave(ActionEvent event) {
    Runnable then = left;
    end();
    then.run();
  }

  private void end() {
    setVisible(false);
    accepted = () -> {};
    left = () -> {};
  }
}
