package org.pendant.desktop.help;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionItem;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.settings.Settings;
import org.pendant.kit.theme.Overlay;
import org.pendant.kit.theme.Palette;

/** Welcome card: where to begin; it is there at the very first start, and when it is asked for. */
public final class WelcomeCard {
  private static final String SEEN = "help.welcomed";

  /** One of these is remembered of everybody who has worked with the window. */
  private static final List<String> USED = List.of(SEEN, "file.recent", "file.open", "look.theme");

  private final ActionTable actions;
  private final Settings settings;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 8, gap 8, wrap 2", "[fill, grow][fill]"));
  private final Overlay overlay;
  private final JButton close = new JButton("Close");

  /**
   * A card that is closed.
   *
   * @param under what it may cover
   */
  public WelcomeCard(ActionTable actions, Settings settings, JComponent under) {
    this.actions = actions;
    this.settings = settings;
    panel.setOpaque(false);
    overlay = new Overlay("welcome", under, panel);
    close.setName("welcome-close");
    close.setToolTipText("Closes this card (Esc); it is in the menu Help too");
    close.addActionListener(event -> close());
  }

  /** Adds the action that opens it. */
  public void addAction() {
    actions.add(Action.of("help.welcome", "Welcome", "", this::open));
  }

  /** Opens it at the very first start. */
  public void openAtFirst() {
    if (USED.stream().allMatch(each -> settings.get(each).isEmpty())) {
      open();
    }
    settings.put(SEEN, "true");
  }

  private void open() {
    panel.removeAll();
    JLabel heading = new JLabel("Welcome to Pendant");
    heading.putClientProperty("FlatLaf.styleClass", "h2");
    panel.add(heading, "span");
    panel.add(new JLabel("The arm is on, and a program is open. What next?"), "span, gapbottom 8");
    JButton first = row("program.run", "Run the program that is open");
    JButton examples = new JButton("Open an example \u25BE");
    examples.setName("welcome-examples");
    examples.setHorizontalAlignment(JButton.LEADING);
    examples.addActionListener(event -> examples().show(examples, 0, examples.getHeight()));
    panel.add(examples);
    panel.add(new JLabel());
    row("file.open", "Open a program, script or .urp\u2026");
    row("file.new", "New program, built from nodes");
    row("file.new-script", "New script, to be written");
    row("help.documentation", "Read the documentation");
    row("help.palette", "Find an action by a few letters");
    panel.add(close, "span, growx 0, right, gaptop 8");
    overlay.open();
    first.requestFocusInWindow();
  }

  private JButton row(String id, String text) {
    JButton button = new JButton(text);
    button.setName("welcome-" + id.replace('.', '-'));
    button.setHorizontalAlignment(JButton.LEADING);
    button.addActionListener(
        event -> {
          close();
          actions.run(id);
        });
    JLabel keys = new JLabel(KeyText.shown(actions.keysOf(id)));
    keys.setForeground(Palette.quiet());
    panel.add(button);
    panel.add(keys);
    return button;
  }

  private JPopupMenu examples() {
    JPopupMenu menu = new JPopupMenu();
    for (Example.Topic topic : Example.Topic.values()) {
      JMenu some = new JMenu(topic.title());
      Example.all().stream()
          .filter(each -> each.topic() == topic)
          .forEach(each -> some.add(ActionItem.of(actions, each.id(), "Example")));
      menu.add(some);
    }
    return menu;
  }

  /** Closes it, if it is open. */
  public void close() {
    overlay.close();
  }
}
