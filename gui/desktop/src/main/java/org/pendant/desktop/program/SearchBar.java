package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;

/** Search bar: finds nodes of the tree below it. */
@SuppressWarnings("serial") // never written to a stream
final class SearchBar extends JPanel {
  private final JTextField text = new JTextField();
  private final JLabel count = new JLabel();
  private final transient Runnable closed;

  /**
   * A bar that is hidden.
   *
   * @param typed hears of every change of what is looked for
   * @param step goes to the next match (true) or the one before
   * @param closed hears that nothing is looked for any more
   */
  SearchBar(Consumer<String> typed, Consumer<Boolean> step, Runnable closed) {
    super(new MigLayout("insets 4 6 4 6, gap 4", "[grow, fill, 0::][][][][]"));
    this.closed = closed;
    setName("program-search-bar");
    text.setName("program-search");
    text.putClientProperty("JTextField.placeholderText", text("findInTheProgram"));
    text.getAccessibleContext().setAccessibleName(text("findInLabelsAndValuesOf"));
    text.getDocument().addDocumentListener(new Typed(() -> typed.accept(text.getText())));
    key("ENTER", () -> step.accept(true));
    key("shift ENTER", () -> step.accept(false));
    key("DOWN", () -> step.accept(true));
    key("UP", () -> step.accept(false));
    key("ESCAPE", this::close);
    add(text);
    add(count);
    add(button("\u2191", text("matchBeforeShiftF3"), "previous", () -> step.accept(false)));
    add(button("\u2193", text("nextMatchF3"), "next", () -> step.accept(true)));
    add(button("\u00d7", text("closeEscape"), "close", this::close));
    setVisible(false);
  }

  private static JButton button(String sign, String tip, String name, Runnable run) {
    JButton button = new JButton(sign);
    button.setName("program-search-" + name);
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleName(tip);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.addActionListener(event -> run.run());
    return button;
  }

  private void key(String keys, Runnable run) {
    text.registerKeyboardAction(
        event -> run.run(), KeyStroke.getKeyStroke(keys), JComponent.WHEN_FOCUSED);
  }

  /** Shows the bar and goes to its field. */
  void open() {
    setVisible(true);
    revalidate();
    text.requestFocusInWindow();
    text.selectAll();
  }

  private void close() {
    setVisible(false);
    text.setText("");
    closed.run();
  }

  /** What is looked for; empty while the bar is hidden. */
  String wanted() {
    return isVisible() ? text.getText() : "";
  }

  /** Tells how many matches there are. */
  void showCount(int matches) {
    boolean none = matches == 0 && !text.getText().isBlank();
    count.setText(
        text.getText().isBlank() ? "" : text(matches == 1 ? "oneNode" : "severalNodes", matches));
    count.setForeground(none ? Palette.error() : Palette.quiet());
  }
}
