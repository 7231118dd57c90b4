package org.pendant.desktop.editor;

import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.FloatingPanel;
import org.pendant.kit.theme.Markup;
import org.pendant.kit.theme.Palette;

/**
 * Inline prompt: asks for one line of text beside a place of the script. ENTER gives it, ESCAPE
 * leaves it.
 */
final class InlinePrompt {
  private final JComponent owner;
  private final JTextField field = new JTextField(24);
  private final JLabel complaint = new JLabel(" ");
  private final FloatingPanel overlay;
  private final Rectangle place;

  private InlinePrompt(
      ScriptArea owner, Rectangle place, String question, Consumer<InlinePrompt> given) {
    this.owner = owner;
    this.place = place;
    JPanel content = new JPanel(new MigLayout("insets 8, gap 4, wrap 1", "[grow]"));
    JLabel label = new JLabel(question);
    label.setLabelFor(field);
    field.setName("prompt");
    field.getAccessibleContext().setAccessibleName(question);
    field.setToolTipText(EditorTexts.text("enterDoesItEscapeLeavesIt", question));
    field.setFont(EditorTheme.codeFont());
    complaint.setName("prompt-complaint");
    complaint.setForeground(Palette.error());
    content.add(label);
    content.add(field, "growx");
    content.add(complaint, "growx, hidemode 3");
    complaint.setVisible(false);
    overlay = new FloatingPanel(owner, content);
    field.addActionListener(event -> given.accept(this));
    field.registerKeyboardAction(
        event -> close(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_FOCUSED);
    field.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            if (!event.isTemporary()) {
              overlay.hide();
            }
          }
        });
  }

  /**
   * Asks.
   *
   * @param place what it is about, in the coordinates of {@code owner}
   * @param text what stands in the field at first, selected
   * @param given takes the prompt when ENTER is pressed, and closes it or refuses
   */
  static void ask(
      ScriptArea owner,
      Rectangle place,
      String question,
      String text,
      Consumer<InlinePrompt> given) {
    InlinePrompt prompt = new InlinePrompt(owner, place, question, given);
    prompt.field.setText(text);
    prompt.overlay.show(place, false);
    prompt.field.selectAll();
    prompt.field.requestFocusInWindow();
  }

  String text() {
    return field.getText().strip();
  }

  /** Says at the field why what stands there will not do. */
  void refuse(String reason) {
    field.putClientProperty("JComponent.outline", "error");
    complaint.setText("<html><body style=\"width: 240px\">" + Markup.escaped(reason));
    complaint.setVisible(true);
    overlay.show(place, false);
    field.selectAll();
  }

  void close() {
    // It hides when it loses the focus: what is typed meanwhile would be lost with the field.
    if (!owner.requestFocusInWindow()) {
      overlay.hide();
    }
  }
}
