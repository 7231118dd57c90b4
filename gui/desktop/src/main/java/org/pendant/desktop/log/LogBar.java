package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.AbstractButton;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.layout.WrappingRow;

/** Log bar: filters, search and commands above the table of messages. */
final class LogBar {
  /** Whether to go forwards through the matches. */
  interface Stepping {
    void step(boolean forward);
  }

  /** A bar that is narrower than so many digits has its sources in a menu. */
  private static final int NARROW_DIGITS = 66;

  private final JPanel filters = new JPanel(new MigLayout("insets 0, gap 4, hidemode 3"));
  private final JButton narrow = new JButton(text("sources"));
  private final JPanel from = new JPanel(new MigLayout("insets 0, gap 4"));
  private final JPanel searching = new JPanel(new MigLayout("insets 0, gap 4", "[grow,fill][][]"));
  private final JPanel bar = new JPanel(new WrappingRow(8));
  private final JTextField search = new JTextField(16);
  private final JLabel matches = new JLabel();
  private final JLabel messages = new JLabel();
  private final JToggleButton follow = new JToggleButton(text("followNewest"), true);
  private final Map<Level, JToggleButton> levels = new EnumMap<>(Level.class);
  private final Map<LogSource, JToggleButton> sources = new EnumMap<>(LogSource.class);
  private final Consumer<LogFilter> filter;

  LogBar(Consumer<LogFilter> filter, Consumer<String> searched, Stepping stepping) {
    this.filter = filter;
    bar.setName("log-bar");
    for (Level level : Level.values()) {
      levels.put(level, toggle(level.name(), word(level), SeverityIcon.of(level)));
    }
    for (LogSource source : LogSource.values()) {
      sources.put(source, toggle(source.name(), source.title(), null));
      sources.get(source).setToolTipText(text("show", source.meaning()));
    }
    buildSearch(searched, stepping);
    bar.add(filters);
    bar.add(from);
    filters.add(buildNarrow());
    bar.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            fit();
          }
        });
    bar.add(searching);
    bar.add(messages);
    name(messages, "log-counts", text("howManyMessagesThereAre"));
  }

  /** The sources as a menu, for where there is little room. */
  private JButton buildNarrow() {
    JPopupMenu menu = new JPopupMenu();
    sources.forEach(
        (source, toggle) -> {
          JCheckBoxMenuItem item = new JCheckBoxMenuItem(source.title());
          item.setModel(toggle.getModel());
          item.setToolTipText(text("show", source.meaning()));
          menu.add(item);
        });
    narrow.putClientProperty("JButton.buttonType", "toolBarButton");
    name(narrow, "log-sources", text("chooseWhoseMessagesAreShown"));
    narrow.addActionListener(event -> menu.show(narrow, 0, narrow.getHeight()));
    narrow.setVisible(false);
    return narrow;
  }

  /** Where the bar is narrow, the messages get the room. */
  private void fit() {
    boolean little =
        bar.getWidth() < NARROW_DIGITS * bar.getFontMetrics(bar.getFont()).charWidth('0');
    if (narrow.isVisible() != little) {
      narrow.setVisible(little);
      from.setVisible(!little);
      levels.forEach((level, toggle) -> toggle.setText(little ? "" : word(level)));
      bar.revalidate();
    }
  }

  private static String word(Level level) {
    return switch (level) {
      case INFO -> text("info");
      case WARNING -> text("warnings");
      case ERROR -> text("errors");
    };
  }

  /** Has {@code follow} hear whether the newest message is to be kept in sight. */
  void addFollowing(Consumer<Boolean> wanted) {
    follow.putClientProperty("JButton.buttonType", "toolBarButton");
    name(follow, "log-follow", text("keepTheNewestMessageInSight"));
    follow.addActionListener(event -> wanted.accept(follow.isSelected()));
    addCommand(follow);
  }

  /** Each on its own, so that they wrap; the count stays last. */
  private void addCommand(AbstractButton button) {
    bar.add(button, bar.getComponentCount() - 1);
  }

  /** Adds the button that opens the menu of columns below it. */
  void addColumns(JPopupMenu menu) {
    JButton button = new JButton(text("columns"));
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    name(button, "log-columns", text("chooseTheColumnsOfTheTable"));
    button.addActionListener(event -> menu.show(button, 0, button.getHeight()));
    addCommand(button);
  }

  private JToggleButton toggle(String id, String text, Icon icon) {
    JToggleButton toggle = new JToggleButton(text, icon, true);
    toggle.putClientProperty("JButton.buttonType", "toolBarButton");
    toggle.setIconTextGap(6);
    name(
        toggle,
        "log-show-" + id.toLowerCase(Locale.ROOT).replace('_', '-'),
        text("showMessages", text));
    toggle.addActionListener(event -> filter.accept(chosen()));
    (icon == null ? from : filters).add(toggle);
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
    Set<LogSource> shownSources = EnumSet.noneOf(LogSource.class);
    sources.forEach(
        (source, toggle) -> {
          if (toggle.isSelected()) {
            shownSources.add(source);
          }
        });
    return new LogFilter(shownLevels, shownSources);
  }

  private void buildSearch(Consumer<String> searched, Stepping stepping) {
    search.putClientProperty("JTextField.placeholderText", text("searchMessages"));
    search.putClientProperty("JTextField.showClearButton", true);
    matches.setForeground(LogColors.quiet());
    search.putClientProperty("JTextField.trailingComponent", matches);
    name(search, "log-search", text("searchMessagesCtrlFEnterFor"));
    search.getDocument().addDocumentListener(new Typed(() -> searched.accept(search.getText())));
    search.addActionListener(event -> stepping.step(true));
    search
        .getInputMap(JComponent.WHEN_FOCUSED)
        .put(KeyStroke.getKeyStroke("shift ENTER"), "log-previous-match");
    search.getActionMap().put("log-previous-match", LogView.act(() -> stepping.step(false)));
    searching.add(search);
    searching.add(
        arrow("\u2191", "log-previous", text("previousMatchShiftF3"), () -> stepping.step(false)));
    searching.add(arrow("\u2193", "log-next", text("nextMatchF3"), () -> stepping.step(true)));
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
    command(text("copy"), "copy", text("copyTheSelectedMessagesCtrlC"), copy, keys);
    command(text("export"), "export", text("saveTheMessagesShownToA"), export, keys);
    command(text("clear"), "clear", text("emptyThisListTheControllerKeeps"), clear, keys);
  }

  private void command(
      String text, String name, String tip, Runnable run, UnaryOperator<String> keys) {
    String key = keys.apply(name);
    JButton button = arrow(text, "log-" + name, key.isEmpty() ? tip : tip + " (" + key + ")", run);
    addCommand(button);
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

  void showFollowing(boolean following) {
    follow.setSelected(following);
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
