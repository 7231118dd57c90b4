package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.session.StateWords;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.Actions;
import org.pendant.kit.layout.Squeeze;
import org.pendant.kit.theme.Palette;

/**
 * Scene bar: the buttons over the picture of the arm. What is wanted often has a button, the rest
 * is in a menu at the end; all of it is in the list of actions too.
 */
final class SceneBar extends JPanel {
  private static final long serialVersionUID = 1L;

  private final transient Actions actions;
  private final transient List<Runnable> states = new ArrayList<>();

  /** What the menu shows is needed only when it opens. */
  private final transient List<Runnable> menuStates = new ArrayList<>();

  private final transient Map<String, Squeeze.Part> spares = new HashMap<>();
  private final JButton more = new JButton(text("more"));
  private final JPopupMenu menu = new JPopupMenu();

  /** Where the next item goes: the menu, or a menu in it. */
  private JComponent items = menu;

  SceneBar(Actions actions) {
    super(new MigLayout("insets 2 4 2 4, gap 2, hidemode 3"));
    this.actions = actions;
    setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Palette.line()));
    more.setToolTipText(text("moreToSeeAndThePicture"));
    prepare(more, "scene-more", text("moreAboutThe3dView"));
    more.addActionListener(
        event -> {
          menuStates.forEach(Runnable::run);
          menu.show(more, 0, more.getHeight());
        });
  }

  /** A button that does something; {@code key} works while the picture has the focus. */
  void button(String id, String title, String describes, String key, Runnable run) {
    actions.add(Action.of(id, text("actionIn3d", describes), "", run));
    JButton button = new JButton(title);
    button.addActionListener(event -> run.run());
    add(described(button, id, describes, key));
    JMenuItem item = new JMenuItem(title);
    item.addActionListener(event -> run.run());
    spare(button, item);
  }

  /** A button that is on or off. */
  void toggle(
      String id,
      String title,
      String describes,
      String key,
      BooleanSupplier on,
      Consumer<Boolean> set) {
    actions.add(
        Action.of(id, text("actionIn3d", describes), "", () -> set.accept(!on.getAsBoolean()))
            .checked(on));
    JToggleButton button = new JToggleButton(title);
    button.addActionListener(event -> set.accept(button.isSelected()));
    states.add(() -> button.setSelected(on.getAsBoolean()));
    add(described(button, id, describes, key));
    JCheckBoxMenuItem item = new JCheckBoxMenuItem(StateWords.capital(title));
    item.addActionListener(event -> set.accept(item.isSelected()));
    menuStates.add(() -> item.setSelected(on.getAsBoolean()));
    spare(button, item);
  }

  /** What has no room in the bar is in the menu. */
  private void spare(AbstractButton button, JMenuItem item) {
    item.setName(button.getName() + "-item");
    item.setToolTipText(button.getToolTipText());
    item.setVisible(false);
    menu.add(item);
    spares.put(
        button.getName(),
        whole -> {
          button.setVisible(whole);
          item.setVisible(!whole);
        });
  }

  private static AbstractButton described(
      AbstractButton button, String id, String describes, String key) {
    String sentence = StateWords.capital(describes);
    button.setToolTipText(key.isEmpty() ? sentence : text("inThePicture", sentence, key));
    prepare(button, id.replace('.', '-'), sentence);
    return button;
  }

  private static void prepare(AbstractButton button, String name, String accessibleName) {
    button.setName(name);
    button.getAccessibleContext().setAccessibleName(accessibleName);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
  }

  /** A menu in the menu, for what {@code add} adds. */
  void group(String title, Runnable add) {
    JMenu sub = new JMenu(title);
    menu.add(sub);
    items = sub;
    add.run();
    items = menu;
  }

  /** Something in the menu. */
  void item(String id, String title, Runnable run) {
    actions.add(Action.of(id, text("actionIn3d", title), "", run));
    JMenuItem item = new JMenuItem(StateWords.capital(title));
    item.setName(id.replace('.', '-'));
    item.addActionListener(event -> run.run());
    items.add(item);
  }

  /** An action that is added elsewhere, in the menu. */
  void entry(String id, String title) {
    JMenuItem item = new JMenuItem(title);
    item.setName("scene-more-" + id.replace('.', '-'));
    item.addActionListener(event -> actions.run(id));
    menuStates.add(
        () ->
            item.setEnabled(
                actions.all().stream()
                    .filter(each -> each.id().equals(id))
                    .anyMatch(each -> each.enabled().getAsBoolean())));
    items.add(item);
  }

  /** Something in the menu that is on or off. */
  void check(String id, String title, BooleanSupplier on, Consumer<Boolean> set) {
    actions.add(
        Action.of(id, text("actionIn3d", title), "", () -> set.accept(!on.getAsBoolean()))
            .checked(on));
    JCheckBoxMenuItem item = new JCheckBoxMenuItem(StateWords.capital(title));
    item.setName(id.replace('.', '-'));
    item.addActionListener(event -> set.accept(item.isSelected()));
    menuStates.add(() -> item.setSelected(on.getAsBoolean()));
    items.add(item);
  }

  /** A menu in the menu, of which one is chosen. */
  void choices(String title, List<Choice> choices) {
    JMenu sub = new JMenu(StateWords.capital(title));
    for (Choice each : choices) {
      actions.add(
          Action.of(each.id(), text("choiceIn3d", title, each.title()), "", each.run())
              .chosen(each.on()));
      JRadioButtonMenuItem item = new JRadioButtonMenuItem(each.title());
      item.setName(each.id().replace('.', '-'));
      item.addActionListener(event -> each.run().run());
      menuStates.add(() -> item.setSelected(each.on().getAsBoolean()));
      sub.add(item);
    }
    items.add(sub);
  }

  /** One of several. */
  record Choice(String id, String title, BooleanSupplier on, Runnable run) {}

  /**
   * Nothing more is added.
   *
   * @param spared the ids of what goes to the menu where there is little room, the first one first
   */
  SceneBar done(List<String> spared) {
    add(more);
    Squeeze squeeze =
        new Squeeze(this, spared.stream().map(id -> spares.get(id.replace('.', '-'))).toList());
    squeeze.fitLater();
    refresh();
    return this;
  }

  /** Shows what is on and what is off. */
  void refresh() {
    states.forEach(Runnable::run);
  }
}
