package org.pendant.gui.shell.run;

import java.awt.KeyboardFocusManager;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.text.JTextComponent;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.Command;
import org.pendant.controller.message.Popup;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.shell.look.Glyph;
import org.pendant.gui.shell.look.GlyphIcon;
import org.pendant.gui.shell.look.Overlay;
import org.pendant.gui.workbench.Palette;
import org.pendant.language.source.ByteText;

/** Shows the popups of programs, the oldest first, over the views and never over the footer. */
public final class PopupPanel {
  private final Overlay overlay;
  private final Consumer<Command> send;
  private final JLabel title = new JLabel();
  private final JLabel more = new JLabel();
  private final JTextArea text = new JTextArea(4, 44);
  private final JButton go = new JButton();
  private final JButton stop = new JButton("Stop program");
  private Optional<Popup> shown = Optional.empty();

  /**
   * A panel without popups.
   *
   * @param under what it may cover
   * @param send has the controller do something, and tells when it is refused
   */
  public PopupPanel(JComponent under, Consumer<Command> send) {
    this.send = send;
    JPanel panel =
        new JPanel(
            new MigLayout(
                "insets 0, gap 8, wrap 1, hidemode 3", "[grow, fill, 0::]", "[][grow][]"));
    panel.setOpaque(false);
    title.putClientProperty("FlatLaf.styleClass", "h3");
    title.setName("popup-title");
    text.setName("popup-text");
    text.setEditable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setToolTipText("What the program says");
    text.getAccessibleContext().setAccessibleName("What the program says");
    go.setName("popup-continue");
    go.addActionListener(event -> answer());
    stop.setName("popup-stop");
    stop.setToolTipText("Ends the program instead of going on");
    stop.getAccessibleContext().setAccessibleName("Stop program");
    stop.addActionListener(event -> send.accept(new Command.StopProgram()));
    panel.add(title, "split 2, growx");
    panel.add(more, "grow 0");
    panel.add(new JScrollPane(text), "grow");
    JPanel buttons = new JPanel(new MigLayout("insets 0, gap 8, hidemode 3", "push[][]"));
    buttons.setOpaque(false);
    buttons.add(stop);
    buttons.add(go);
    panel.add(buttons);
    overlay = new Overlay("popup", under, panel);
    // One that the program waits for is never closed without an answer.
    overlay.onEscape(() -> shown.filter(popup -> !popup.blocking()).ifPresent(p -> answer()));
  }

  private void answer() {
    shown.ifPresent(popup -> send.accept(new Command.AnswerPopup(popup.number())));
  }

  /** Shows what is open in a snapshot. */
  public void refresh(ControllerState state) {
    List<Popup> open = state.openPopups();
    Optional<Popup> first = open.stream().findFirst();
    more.setText(open.size() > 1 ? "1 of " + open.size() : "");
    if (first.equals(shown)) {
      return;
    }
    shown = first;
    overlay.close();
    first.ifPresent(this::show);
  }

  private void show(Popup popup) {
    more.setForeground(Palette.quiet());
    String words = ByteText.decoded(popup.title());
    title.setText(words.isBlank() ? "Popup" : words);
    title.setIcon(icon(popup.severity()));
    text.setText(ByteText.decoded(popup.text()));
    text.setCaretPosition(0);
    go.setText(popup.blocking() ? "Continue" : "Close");
    go.setToolTipText(
        popup.blocking() ? "Closes the popup; the program goes on" : "Closes the popup");
    go.getAccessibleContext().setAccessibleName(go.getText());
    stop.setVisible(popup.blocking());
    overlay.open();
    if (!typing()) {
      go.requestFocusInWindow();
    }
  }

  /** Whether somebody types: a key meant for the text must not answer a popup. */
  private static boolean typing() {
    return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner()
            instanceof JTextComponent field
        && field.isEditable();
  }

  private static GlyphIcon icon(Popup.Severity severity) {
    return switch (severity) {
      case MESSAGE -> GlyphIcon.of(Glyph.INFO, 20, Palette::accent);
      case WARNING -> GlyphIcon.of(Glyph.WARNING, 20, Palette::warning);
      case ERROR -> GlyphIcon.of(Glyph.ERROR, 20, Palette::error);
    };
  }
}
