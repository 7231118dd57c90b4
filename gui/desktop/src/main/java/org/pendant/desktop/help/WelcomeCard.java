package org.pendant.desktop.help;

import static org.pendant.desktop.help.HelpViewTexts.text;

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
  private final JButton close = new JButton(text("close"));

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
    overlay.takeEscapeAnywhere();
    close.setName("welcome-close");
    close.setToolTipText(text("closesThisCardEscItIs"));
    close.addActionListener(event -> close());
  }

  /** Adds the action that opens it. */
  public void addAction() {
    actions.add(Action.of("help.welcome", text("welcome"), "", this::open));
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
    JLabel heading = new JLabel(text("welcomeToPendant"));
    heading.putClientProperty("FlatLaf.styleClass", "h2");
    panel.add(heading, "span");
    panel.add(new JLabel(text("theArmIsOnAndA")), "span, gapbottom 8");
    JButton first = row("program.run", text("runTheProgramThatIsOpen"));
    JButton examples = new JButton(text("openAnExample"));
    examples.setName("welcome-examples");
    examples.setHorizontalAlignment(JButton.LEADING);
    examples.addActionListener(event -> examples().show(examples, 0, examples.getHeight()));
    panel.add(examples);
    panel.add(new JLabel());
    row("file.open", text("openAProgramScriptOrUrp"));
    row("file.new", text("newProgramBuiltFromNodes"));
    row("file.new-script", text("newScriptToBeWritten"));
    row("help.documentation", text("readTheDocumentation"));
    row("help.palette", text("findAnActionByAFew"));
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
          .forEach(each -> some.add(ActionItem.of(actions, each.id(), text("examplePrefix"))));
      menu.add(some);
    }
    return menu;
  }

  /** Closes it, if it is open. */
  public void close() {
    overlay.close();
  }
}
