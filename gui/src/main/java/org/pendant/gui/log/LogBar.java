package org.pendant.gui.log;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.gui.layout.Typed;
import org.pendant.gui.layout.WrappingRow;

/** Filters, search and commands above the table of messages. */
final class LogBar {
  /** Whether to go forwards through the matches. */
  interface Stepping {
    void step(boolean forward);
  }

  private final JPanel filters = new JPanel(new MigLayout("insets 0, gap 4"));
  private final JPanel searching = new JPanel(new MigLayout("insets 0, gap 4", "[grow,fill][][]"));
  private final JPanel commands = new JPanel(new MigLayout("insets 0, gap 4"));
  private final JPanel bar = new JPanel(new WrappingRow(8));
  private final JTextField search = new JTextField(16);
  private final JLabel matches = new JLabel();
  private final JLabel messages = new JLabel();
  private final Map<Level, JToggleButton> levels = new EnumMap<>(Level.class);
  private final Map<Origin, JToggleButton> origins = new EnumMap<>(Origin.class);
  private final Consumer<LogFilter> filter;

  LogBar(Consumer<LogFilter> filter, Consumer<String> searched, Stepping stepping) {
    this.filter = filter;
    bar.setName("log-bar");
    for (Level level : Level.values()) {
      levels.put(level, toggle(word(level), new SeverityIcon(level)));
    }
    filters.add(new JLabel(" "));
    for (Origin origin : Origin.values()) {
      origins.put(origin, toggle(LogLine.sourceOf(origin), null));
    }
    buildSearch(searched, stepping);
    bar.add(filters);
    bar.add(searching);
    bar.add(commands);
    bar.add(messages);
    name(messages, "log-counts", "How many messages there are");
  }

  private static String word(Level level) {
    return switch (level) {
      case INFO -> "Info";
      case WARNING -> "Warnings";
      case ERROR -> "Errors";
    };
  }

  private JToggleButton toggle(String text, Icon icon) {
    JToggleButton toggle = new JToggleButton(text, icon, true);
    toggle.putClientProperty("JButton.buttonType", "toolBarButton");
    toggle.setIconTextGap(6);
    name(
        toggle,
        "log-show-" + text.toLowerCase(Locale.ROOT).replace(' ', '-'),
        "Show messages: " + text);
    toggle.addActionListener(event -> filter.accept(chosen()));
    filters.add(toggle);
    return toggle;
  }

  private LogFilter chosen() {
    Set<Level> shownLevels = EnumSet.noneOf(Level.class);
    levels.forEach(
        (level, toggle) -> {
          if (toggle.isSelected()) {
            shownLevels.add(level);
          }
        });
    Set<Origin> shownOrigins = EnumSet.noneOf(Origin.class);
    origins.forEach(
        (origin, toggle) -> {
          if (toggle.isSelected()) {
            shownOrigins.add(origin);
          }
        });
    return new LogFilter(shownLevels, shownOrigins);
  }

  private void buildSearch(Consumer<String> searched, Stepping stepping) {
    search.putClientProperty("JTextField.placeholderText", "Search messages");
    search.putClientProperty("JTextField.showClearButton", true);
    search.putClientProperty("JTextField.trailingComponent", matches);
    matches.setForeground(LogColors.quiet());
    name(search, "log-search", "Search messages (Ctrl F, Enter for the next)");
    search.getDocument().addDocumentListener(new Typed(() -> searched.accept(search.getText())));
    search.addActionListener(event -> stepping.step(true));
    search
        .getInputMap(JComponent.WHEN_FOCUSED)
        .put(KeyStroke.getKeyStroke("shift ENTER"), "log-previous-match");
    searching.add(search);
    searching.add(
        arrow("\u2191", "log-previous", "Previous match (Shift F3)", () -> stepping.step(false)));
    searching.add(arrow("\u2193", "log-next", "Next match (F3)", () -> stepping.step(true)));
  }

  private static JButton arrow(String text, String name, String tip, Runnable run) {
    JButton button = new JButton(text);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    name(button, name, tip);
    button.addActionListener(event -> run.run());
    return button;
  }

  /**
   * Adds what can be done with the messages.
   *
   * @param keys the key of a command by its name, empty for none
   */
  void addCommands(Runnable copy, Runnable export, Runnable clear, UnaryOperator<String> keys) {
    command("Copy", "copy", "Copy the selected messages (Ctrl C)", copy, keys);
    command("Export\u2026", "export", "Save the messages shown to a file", export, keys);
    command("Clear", "clear", "Empty this list; the controller keeps its log", clear, keys);
  }

  private void command(
      String text, String name, String tip, Runnable run, UnaryOperator<String> keys) {
    String key = keys.apply(name);
    JButton button = arrow(text, "log-" + name, key.isEmpty() ? tip : tip + " (" + key + ")", run);
    commands.add(button);
  }

  private static void name(JComponent component, String name, String tip) {
    component.setName(name);
    component.setToolTipText(tip);
    component.getAccessibleContext().setAccessibleName(tip);
  }

  JComponent component() {
    return bar;
  }

  void focusSearch() {
    search.requestFocusInWindow();
    search.selectAll();
  }

  void showCounts(LogCounts counts) {
    if (!counts.messages().equals(messages.getText())) {
      messages.setText(counts.messages());
    }
    if (!counts.matches().equals(matches.getText())) {
      matches.setText(counts.matches());
      matches.revalidate();
    }
  }
}
